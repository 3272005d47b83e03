#include "session/files/stale_files.h"

#include <filesystem>
#include <vector>

#include "platform/file.h"
#include "platform/file_lock.h"
#include "platform/unique_name.h"

namespace weftlight::session {
namespace fs = std::filesystem;

void remove_stale_files(const std::string& path) {
  if (path.empty()) return;
  const fs::path file(path), folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<std::string> found;
  std::error_code error;
  for (const std::string& name : platform::names_in(folder.string(), error))
    if (platform::is_temporary_of(path, name) && fs::is_regular_file(fs::symlink_status(folder / name, error)))
      found.push_back((folder / name).string());
  for (const std::string& left : found) {
    const auto lock = platform::FileLock::take_existing(left);
    // Keeps a file that was finished and renamed meanwhile.
    if (lock.held() && lock.stands_at(left)) fs::remove(left, error);
  }
}

}  // namespace weftlight::session
