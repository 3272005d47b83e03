// %APPDATA% and %LOCALAPPDATA%, unless a variable of the XDG specification, which other systems' scripts set, names
// another.

#include "platform/folders.h"

#include <windows.h>

#include <filesystem>

#include "platform/environment_variables.h"
#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace fs = std::filesystem;

namespace {

std::string user_folder(const char* name, const char* of_windows, const char* in_it) {
  if (std::string given = variable(name); fs::path(given).is_absolute()) return given;
  const std::string all = variable(of_windows);
  const fs::path folder = fs::path(all.empty() ? home_folder() : all);
  return (*in_it == '\0' ? folder : folder / in_it).string();
}

}  // namespace

std::string program_folder() {
  HMODULE module = nullptr;  // of the program, or of the library that holds this code
  ::GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                       reinterpret_cast<const wchar_t*>(&program_folder), &module);
  wchar_t path[4096];
  const DWORD size = ::GetModuleFileNameW(module, path, 4096);
  return size == 0 || size == 4096 ? std::string() : fs::path(narrow({path, size})).parent_path().string();
}

std::string home_folder() {
  std::string home = variable("HOME");  // as shells that were brought along set it
  return home.empty() ? variable("USERPROFILE") : home;
}
std::string settings_folder() { return user_folder("XDG_CONFIG_HOME", "APPDATA", ""); }
std::string state_folder() { return user_folder("XDG_STATE_HOME", "LOCALAPPDATA", ""); }
std::string cache_folder() { return user_folder("XDG_CACHE_HOME", "LOCALAPPDATA", "Cache"); }

}  // namespace weftlight::platform
