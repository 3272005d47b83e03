#pragma once
// The one way in which a finished file comes to stand in another's place: written beside it, synced, renamed, and the
// folder synced. Whenever the program or the power ends, the old file is there or the new one, whole.

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "platform/file_lock.h"

namespace weftlight::platform {

/// A file that is being written to replace another.
class DurableFile {
 public:
  /// Makes an empty file beside `path`, locked while it is written, so that others can tell it from what a killed
  /// program left (unique_name.h). Symbolic links are followed and stay. A read-only file is not replaced.
  explicit DurableFile(const std::string& path);
  /// Removes the file beside, unless it was put in place.
  ~DurableFile();
  DurableFile(const DurableFile&) = delete;
  DurableFile& operator=(const DurableFile&) = delete;

  /// Why there is no file beside.
  const std::error_code& error() const { return error_; }
  /// To be filled, by any program or library; it has the extension of `path`.
  const std::string& beside() const { return beside_; }
  /// Call it after the file beside is written and closed. It gets the permissions of the old file.
  std::error_code put_in_place();

 private:
  std::string target_, beside_;
  std::optional<std::filesystem::perms> permissions_;  // of the old file
  FileLock lock_;
  std::error_code error_;
};

/// Why a DurableFile could not be made there, without making one.
std::error_code why_not_replaced(const std::string& path);

/// Puts a finished file, or a folder with all its files, in the place of `target` in the same folder or volume: a file
/// replaces a file, a folder an empty folder or none.
std::error_code put_in_place(const std::string& made, const std::string& target);

/// Makes a folder, and those above it that are missing. Each is on the disk under its name, where its folder can be
/// synced: a file in it would be lost with it, even if synced itself.
std::error_code make_folders(const std::string& folder);

}  // namespace weftlight::platform
