#include "platform/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "platform/posix/open_file_lock.h"

namespace weftlight::platform {

FileLock::~FileLock() {
  if (handle_ < 0) return;
  unlock_open_file(static_cast<int>(handle_));
  ::close(static_cast<int>(handle_));
}

FileLock FileLock::open(const std::string& path, int flags, unsigned mode, bool wait) {
  FileLock lock;
  const int file = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC | O_NONBLOCK, mode);
  lock.handle_ = file;
  const int error = file < 0 ? errno : lock_open_file(file, wait);
  lock.cause_ = {error, std::generic_category()};
  if (file < 0) return lock;
  const bool taken = error == EAGAIN || error == EACCES || error == EWOULDBLOCK;
  lock.answer_ = error == 0 ? LockAnswer::kHeld : taken ? LockAnswer::kTaken : LockAnswer::kNoLocks;
  return lock;
}

FileLock FileLock::take(const std::string& path) { return open(path, O_CREAT, 0600, false); }
FileLock FileLock::wait_for(const std::string& path) { return open(path, O_CREAT, 0600, true); }
FileLock FileLock::take_existing(const std::string& path) { return open(path, O_NOFOLLOW, 0, false); }
FileLock FileLock::make(const std::string& path) { return open(path, O_CREAT | O_EXCL, 0666, false); }

bool FileLock::stands_at(const std::string& path) const {
  struct stat held {
  }, there{};
  return handle_ >= 0 && ::fstat(static_cast<int>(handle_), &held) == 0 && ::stat(path.c_str(), &there) == 0 &&
         held.st_dev == there.st_dev && held.st_ino == there.st_ino;
}

}  // namespace weftlight::platform
