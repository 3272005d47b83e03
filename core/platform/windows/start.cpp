#include "platform/start.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// After it, whose words it needs.
#include <shellapi.h>

#include <cstdio>
#include <memory>

#include "platform/windows/wide.h"

namespace weftlight::platform {

std::vector<std::string> start(int argc, char** argv) {
  // A line ends as it ends in files of this program everywhere, and a console reads UTF-8.
  for (std::FILE* stream : {stdin, stdout, stderr}) ::_setmode(::_fileno(stream), _O_BINARY);
  ::SetConsoleOutputCP(CP_UTF8);
  // A console that no other program uses was opened for this one alone, by a double click: the window is enough.
  DWORD others[2];
  if (::GetConsoleProcessList(others, 2) == 1) ::FreeConsole();
  // argv is in the code page of the system, which has not all letters.
  int count = 0;
  const auto free = [](wchar_t** words) { ::LocalFree(words); };
  const std::unique_ptr<wchar_t*, decltype(free)> words(::CommandLineToArgvW(::GetCommandLineW(), &count), free);
  std::vector<std::string> arguments;
  if (!words) arguments.assign(argv, argv + argc);
  for (int i = 0; words && i < count; ++i) arguments.push_back(narrow(words.get()[i]));
  return arguments;
}

void keep_freed_memory() {}  // the system's allocator does so by itself

}  // namespace weftlight::platform
