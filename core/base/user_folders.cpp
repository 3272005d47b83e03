#include "base/user_folders.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

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

void keep_newest(const std::string& folder, const std::string& extension, size_t max_files) {
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  std::error_code ec;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ec))
    if (entry.path().extension() == extension) all.emplace_back(entry.last_write_time(ec), entry.path());
  if (all.size() <= max_files) return;
  std::sort(all.begin(), all.end());
  for (size_t i = 0; i < all.size() - max_files; ++i) fs::remove(all[i].second, ec);
}

}  // namespace weftlight::base
