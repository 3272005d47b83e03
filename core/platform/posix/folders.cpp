// The user's folders by the XDG base directory specification.

#include "platform/folders.h"

#include <dlfcn.h>

#include <filesystem>

#include "platform/environment_variables.h"

#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <cstdint>
#else
#include <link.h>
#endif

namespace weftlight::platform {
namespace fs = std::filesystem;

namespace {

/// $NAME, or ~/FALLBACK. The specification has relative paths ignored.
std::string user_folder(const char* name, const char* fallback) {
  if (std::string given = variable(name); given.starts_with('/')) return given;
  const std::string home = home_folder();
  return (fs::path(home.empty() ? "." : home) / fallback).string();
}

#ifndef __APPLE__
/// The library that this code is in, as a module that Python loaded; empty in a program.
std::string own_library() {
  Dl_info place{};
  link_map* map = nullptr;  // whose name is empty for the program itself
  const bool found =
      ::dladdr1(reinterpret_cast<void*>(&program_folder), &place, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0;
  return found && map != nullptr && map->l_name != nullptr ? map->l_name : "";
}
#endif

}  // namespace

std::string program_folder() {
  std::error_code error;
#ifdef __APPLE__
  char buffer[4096];
  uint32_t size = sizeof buffer;
  return _NSGetExecutablePath(buffer, &size) == 0 ? fs::canonical(buffer, error).parent_path().string() : std::string();
#else
  const std::string library = own_library();
  const fs::path file = library.empty() ? fs::read_symlink("/proc/self/exe", error) : fs::canonical(library, error);
  return file.parent_path().string();
#endif
}

std::string home_folder() { return variable("HOME"); }
std::string settings_folder() { return user_folder("XDG_CONFIG_HOME", ".config"); }
std::string state_folder() { return user_folder("XDG_STATE_HOME", ".local/state"); }
std::string cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

}  // namespace weftlight::platform
