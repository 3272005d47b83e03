#include "platform/process.h"

#include <windows.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "platform/file.h"
#include "platform/windows/open_handle.h"
#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

constexpr size_t kMaxOutput = size_t{1} << 20;  // what is printed beyond it is dropped

/// One word as the C library of the started program takes it apart again.
std::wstring quoted(const std::string& word) {
  if (!word.empty() && word.find_first_of(" \t\n\v\"") == std::string::npos) return wide(word);
  std::string out = "\"";
  size_t backslashes = 0;
  for (const char c : word) {
    if (c == '\\') {
      ++backslashes;
      continue;
    }
    // Backslashes mean themselves, except before a quotation mark.
    out.append(c == '"' ? 2 * backslashes + 1 : backslashes, '\\');
    out += c;
    backslashes = 0;
  }
  out.append(2 * backslashes, '\\').append("\"");
  return wide(out);
}

/// The program is given no handle but its output, if there is one. Null if it cannot be started.
OpenHandle spawn(const std::vector<std::string>& words, HANDLE output) {
  if (words.empty()) return nullptr;
  std::wstring line;
  for (const std::string& word : words) line.append(line.empty() ? L"" : L" ").append(quoted(word));
  STARTUPINFOEXW how{};
  how.StartupInfo.cb = sizeof how;
  std::vector<char> list;
  DWORD flags = CREATE_NO_WINDOW;
  if (output != nullptr) {
    SIZE_T size = 0;
    ::InitializeProcThreadAttributeList(nullptr, 1, 0, &size);
    list.resize(size);
    how.lpAttributeList = reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(list.data());
    if (::InitializeProcThreadAttributeList(how.lpAttributeList, 1, 0, &size) == 0) return nullptr;
    ::UpdateProcThreadAttribute(how.lpAttributeList, 0, PROC_THREAD_ATTRIBUTE_HANDLE_LIST, &output, sizeof output,
                                nullptr, nullptr);
    how.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    how.StartupInfo.hStdOutput = output;
    flags |= EXTENDED_STARTUPINFO_PRESENT;
  } else {
    how.StartupInfo.cb = sizeof how.StartupInfo;
  }
  PROCESS_INFORMATION started{};
  const BOOL made = ::CreateProcessW(nullptr, line.data(), nullptr, nullptr, output != nullptr, flags, nullptr, nullptr,
                                     &how.StartupInfo, &started);
  if (how.lpAttributeList != nullptr) ::DeleteProcThreadAttributeList(how.lpAttributeList);
  if (made == 0) return nullptr;
  ::CloseHandle(started.hThread);
  return OpenHandle(started.hProcess);
}

HANDLE handle_of(std::intptr_t number) { return reinterpret_cast<HANDLE>(number); }

/// Reads what is there, but not for ever; true at the end of the output.
bool read_all(HANDLE from, std::string& text) {
  char buffer[4096];
  for (size_t all = 0; all < kMaxOutput;) {
    DWORD there = 0, got = 0;
    if (::PeekNamedPipe(from, nullptr, 0, nullptr, &there, nullptr) == 0) return true;
    if (there == 0) return false;
    if (::ReadFile(from, buffer, sizeof buffer, &got, nullptr) == 0) return true;
    all += got;
    text.append(buffer, std::min(size_t{got}, kMaxOutput - std::min(text.size(), kMaxOutput)));
  }
  return false;
}

}  // namespace

Process::Process(const std::vector<std::string>& words) {
  SECURITY_ATTRIBUTES inherited{};
  inherited.nLength = sizeof inherited;
  inherited.bInheritHandle = TRUE;
  HANDLE ends[2]{};
  if (::CreatePipe(&ends[0], &ends[1], &inherited, 0) == 0) return;
  OpenHandle reading(ends[0]), writing(ends[1]);
  ::SetHandleInformation(reading.get(), HANDLE_FLAG_INHERIT, 0);
  id_ = reinterpret_cast<std::intptr_t>(spawn(words, writing.get()).release());
  if (running()) reading_ = reinterpret_cast<std::intptr_t>(reading.release());
}

Process::~Process() {
  if (reading_ >= 0) ::CloseHandle(handle_of(reading_));
  if (!running()) return;
  const OpenHandle program(handle_of(static_cast<std::intptr_t>(id_)));
  ::TerminateProcess(program.get(), 1);  // nothing polite reaches a program without a window or a console
}

void Process::look() {
  if (!running()) return;
  if (reading_ >= 0 && read_all(handle_of(reading_), output_)) ::CloseHandle(handle_of(std::exchange(reading_, -1)));
  const HANDLE program = handle_of(static_cast<std::intptr_t>(id_));
  if (::WaitForSingleObject(program, 0) == WAIT_TIMEOUT) return;
  // What it printed itself is there by now. A program that it started may hold the output open for as long as it likes.
  if (reading_ >= 0) {
    read_all(handle_of(reading_), output_);
    ::CloseHandle(handle_of(std::exchange(reading_, -1)));
  }
  DWORD code = 1;
  succeeded_ = ::GetExitCodeProcess(program, &code) != 0 && code == 0;
  ::CloseHandle(program);
  id_ = 0;
}

bool start_program(const std::vector<std::string>& words) { return spawn(words, nullptr) != nullptr; }

bool is_program(const std::string& name, const std::string& folders) {
  std::istringstream each(folders);
  for (std::string folder; std::getline(each, folder, ';');)
    for (const char* ending : {"", ".exe"})
      if (file_facts(folder + "\\" + name + ending).kind == FileKind::kRegular) return true;
  return false;
}

}  // namespace weftlight::platform
