#include "base/user_folders.h"

#include <cstdlib>
#include <filesystem>

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

/// $VARIABLE/weftlight, or ~/fallback/weftlight.
std::string user_folder(const char* variable, const char* fallback) {
  if (const char* given = std::getenv(variable); given != nullptr && *given == '/')
    return (fs::path(given) / "weftlight").string();
  const char* home = std::getenv("HOME");
  return (fs::path(home != nullptr ? home : ".") / fallback / "weftlight").string();
}

}  // namespace

std::string config_folder() { return user_folder("XDG_CONFIG_HOME", ".config"); }
std::string cache_folder() { return user_folder("XDG_CACHE_HOME", ".cache"); }
std::string state_folder() { return user_folder("XDG_STATE_HOME", ".local/state"); }

}  // namespace weftlight::base
