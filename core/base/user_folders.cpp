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

void keep_newest(const std::string& folder, const std::string& extension, size_t max_files,
                 const std::string& written) {
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  std::error_code ec;
  fs::file_time_type now = fs::last_write_time(written, ec);
  if (ec) now = fs::file_time_type::max();
  for (const std::string& name : platform::names_in(folder, ec)) {
    const fs::path at = fs::path(folder) / name;
    if (at.extension() != extension) continue;
    fs::file_time_type time = fs::last_write_time(at, ec);
    if (at == fs::path(written)) time = fs::file_time_type::max();
    else if (time > now) time = fs::file_time_type::min();
    all.emplace_back(time, at);
  }
  if (all.size() <= max_files) return;
  std::sort(all.begin(), all.end());
  for (size_t i = 0; i < all.size() - max_files; ++i) fs::remove(all[i].second, ec);
}

}  // namespace weftlight::base
