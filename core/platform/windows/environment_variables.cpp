#include "platform/environment_variables.h"

#include <windows.h>

#include <cstdlib>

#include "platform/windows/wide.h"

namespace weftlight::platform {

std::string variable(const char* name) {
  const std::wstring wide_name = wide(name);
  std::wstring value(256, L'\0');
  for (;;) {
    const DWORD size = ::GetEnvironmentVariableW(wide_name.c_str(), value.data(), static_cast<DWORD>(value.size()));
    const bool whole = size < value.size();
    value.resize(size, L'\0');
    if (whole) return narrow(value);
  }
}

// Through the C library, which keeps a copy of its own and tells the system.
void set_variable(const char* name, const std::string& value) { ::_wputenv_s(wide(name).c_str(), wide(value).c_str()); }

bool errors_go_to_terminal() {
  DWORD mode = 0;
  return ::GetConsoleMode(::GetStdHandle(STD_ERROR_HANDLE), &mode) != 0;
}

}  // namespace weftlight::platform
