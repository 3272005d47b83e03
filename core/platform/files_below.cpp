#include "platform/files_below.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "platform/file.h"

namespace weftlight::platform {
namespace fs = std::filesystem;

FilesBelow files_below(const std::string& folder) {
  FilesBelow out;
  std::vector<fs::path> waiting{folder};
  while (!waiting.empty()) {
    const fs::path now = std::move(waiting.back());
    waiting.pop_back();
    std::error_code error;
    for (const std::string& name : names_in(now.string(), error)) {
      const fs::path path = now / name;
      std::error_code ignored;  // of a file that has just gone
      if (fs::is_directory(fs::symlink_status(path, ignored))) waiting.push_back(path);
      else if (fs::is_regular_file(path, ignored)) out.files.push_back(path.string());
    }
    if (error) out.unread.push_back(now.string());
  }
  std::ranges::sort(out.files);
  std::ranges::sort(out.unread);
  return out;
}

}  // namespace weftlight::platform
