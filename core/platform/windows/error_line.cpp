#include "platform/error_line.h"

#include <windows.h>

#include <cstdio>

#include "platform/windows/wide.h"

namespace weftlight::platform {

void write_error_line(const std::string& line) {
  // Without a console the standard error leads nowhere, unless another program reads it or it goes to a file.
  if (::GetFileType(::GetStdHandle(STD_ERROR_HANDLE)) == FILE_TYPE_UNKNOWN)
    ::MessageBoxW(nullptr, wide(line).c_str(), L"Weftlight", MB_OK | MB_ICONERROR | MB_SETFOREGROUND);
  else std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace weftlight::platform
