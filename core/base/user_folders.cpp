#include "base/user_folders.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "platform/file.h"
#include "platform/folders.h"

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

std::string own_folder(const std::string& of_all) { return (fs::path(of_all) / "weftlight").string(); }

}  // namespace

std::string config_folder() { return own_folder(platform::settings_folder()); }
std::string cache_folder() { return own_folder(platform::cache_folder()); }
std::string state_folder() { return own_folder(platform::state_folder()); }

void keep_newest(const std::string& folder, const std::string& extension, size_t max_files) {
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  std::error_code ec;
  for (const std::string& name : platform::names_in(folder, ec))
    if (const fs::path at = fs::path(folder) / name; at.extension() == extension)
      all.emplace_back(fs::last_write_time(at, ec), at);
  if (all.size() <= max_files) return;
  std::sort(all.begin(), all.end());
  for (size_t i = 0; i < all.size() - max_files; ++i) fs::remove(all[i].second, ec);
}

}  // namespace weftlight::base
