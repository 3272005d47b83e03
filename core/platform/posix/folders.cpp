// The user's folders by the XDG base directory specification.

#include "platform/folders.h"

#include <filesystem>

#include "platform/environment.h"

#ifdef __APPLE__
#include <mach-o/dyld.h>

#include <cstdint>
#endif

namespace weftlight::platform {
namespace fs = std::filesystem;

namespace {

/// $NAME, or ~/FALLBACK. The specification has relative paths ignored.
std::string user_folder(const char* name, const char* fallback) {
  if (const std::string given = variable(name); given.starts_with('/')) return given;
  const std::string home = home_folder();
  return (fs::path(home.empty() ? "." : home) / fallback).string();
}

}  // namespace

std::string program_folder() {
  std::error_code error;
#ifdef __APPLE__
  char buffer[4096];
  uint32_t size = sizeof buffer;
  return _NSGetExecutablePath(buffer, &size) == 0 ? fs::canonical(buffer, error).parent_path().string() : std::string();
#else
  return fs::read_symlink("/proc/self/exe", error).parent_path().string();
#endif
}

std::string home_folder() { return variable("HOME"); }
std::string settings_folder() { return user_folder("XDG_CONFIG_HOME", ".config"); }
std::string state_folder() { return user_folder("XDG_STATE_HOME", ".local/state"); }
std::string cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }

}  // namespace weftlight::platform
