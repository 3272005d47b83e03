#include "platform/durable_file.h"

#include <utility>

#include "platform/file.h"
#include "platform/unique_name.h"

namespace weftlight::platform {
namespace fs = std::filesystem;

namespace {

/// The file at the end of a chain of symbolic links; it need not exist.
fs::path link_target(fs::path path) {
  constexpr int kMaxLinks = 32;
  std::error_code error;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, error); ++i) {
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

std::string folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path().string() : std::string(".");
}

/// An empty file beside `target` and its lock.
std::error_code make_beside(const std::string& target, std::string& path, FileLock& lock) {
  constexpr int kMaxTries = 10;
  for (int i = 0; i < kMaxTries; ++i) {
    path = temporary_beside(target);
    lock = FileLock::make(path);
    if (lock.answer() == LockAnswer::kNoLocks) return {};
    // A process that removes stale files may come between a file and its lock.
    if (lock.held() && lock.stands_at(path)) return {};
    if (lock.answer() == LockAnswer::kNoFile && lock.cause() != std::errc::file_exists) return lock.cause();
  }
  return std::make_error_code(std::errc::device_or_resource_busy);
}

std::error_code rename_for_good(const std::string& made, const std::string& target) {
  const std::error_code error = rename(made, target);
  // A rename survives a power failure only if the folder is synced too. Where it cannot be, the file is whole anyway.
  if (!error) sync(folder_of(target));
  return error;
}

std::error_code sync_all_in(const fs::path& folder) {
  std::error_code error;
  for (const std::string& name : names_in(folder.string(), error)) {
    const fs::path at = folder / name;
    const fs::file_status what = fs::symlink_status(at, error);
    std::error_code failed;
    if (fs::is_directory(what)) failed = sync_all_in(at);
    if (fs::is_regular_file(what)) failed = sync(at.string());
    if (failed) return failed;
  }
  return error ? error : sync(folder.string());
}

}  // namespace

DurableFile::DurableFile(const std::string& path) : target_(link_target(path).string()) {
  std::error_code unknown;
  const fs::file_status old = fs::status(target_, unknown);
  if (fs::exists(old)) {
    // A rename would replace a read-only file without an error.
    if ((error_ = platform::why_not_writable(target_))) return;
    permissions_ = old.permissions();
  }
  error_ = make_beside(target_, beside_, lock_);
  if (error_) beside_.clear();
}

DurableFile::~DurableFile() {
  if (!beside_.empty()) remove_with_contents(beside_);
}

std::error_code DurableFile::put_in_place() {
  std::error_code error;
  File made(beside_, File::Open::kWrite);
  if (made.error()) return made.error();
  if (permissions_) fs::permissions(beside_, *permissions_, error);
  if (!error) error = made.sync();
  if (!error) error = made.close();
  if (!error) error = rename_for_good(beside_, target_);
  if (!error) beside_.clear();
  return error;
}

std::error_code why_not_replaced(const std::string& path) {
  const std::string target = link_target(path).string();
  if (file_facts(target).kind != FileKind::kNone)
    if (const std::error_code error = why_not_writable(target)) return error;
  return why_not_writable(folder_of(target) + "/.");  // the file beside is made in the folder
}

std::error_code put_in_place(const std::string& made, const std::string& target) {
  const bool folder = file_facts(made).kind == FileKind::kFolder;
  if (const std::error_code error = folder ? sync_all_in(made) : sync(made)) return error;
  return rename_for_good(made, target);
}

std::error_code make_folders(const std::string& folder) {
  std::error_code error;
  if (folder.empty() || fs::is_directory(folder, error)) return {};
  const std::string above = fs::path(folder).parent_path().string();
  if (above != folder)
    if (const std::error_code failed = make_folders(above)) return failed;
  fs::create_directory(folder, error);
  if (!error) sync(folder_of(folder));
  return error;
}

}  // namespace weftlight::platform
