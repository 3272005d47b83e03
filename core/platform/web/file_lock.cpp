// Files of the page belong to this program alone, so a lock is kept in its memory.

#include "platform/file_lock.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

namespace weftlight::platform {
namespace {

struct Locked {
  ino_t number = 0;
  int file = -1;
};
struct Locks {
  std::mutex mutex;
  std::condition_variable freed;
  std::vector<Locked> held;

  bool is_held(ino_t number) const {
    return std::any_of(held.begin(), held.end(), [number](const Locked& one) { return one.number == number; });
  }
};
Locks& locks() {
  static Locks& all = *new Locks;
  return all;
}

/// 0, or errno.
int lock_of(int file, bool wait) {
  struct stat there {};
  if (::fstat(file, &there) != 0) return errno;
  std::unique_lock lock(locks().mutex);
  const auto is_free = [&] { return !locks().is_held(there.st_ino); };
  if (wait) locks().freed.wait(lock, is_free);
  if (!is_free()) return EAGAIN;
  locks().held.push_back({there.st_ino, file});
  return 0;
}

void unlock(int file) {
  const std::lock_guard lock(locks().mutex);
  std::erase_if(locks().held, [file](const Locked& one) { return one.file == file; });
  locks().freed.notify_all();
}

}  // namespace

FileLock::~FileLock() {
  if (handle_ < 0) return;
  unlock(static_cast<int>(handle_));
  ::close(static_cast<int>(handle_));
}

FileLock::FileLock(FileLock&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)),
      answer_(std::exchange(other.answer_, LockAnswer::kNoFile)),
      cause_(other.cause_) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(answer_, other.answer_);
  std::swap(cause_, other.cause_);
  return *this;
}

FileLock FileLock::open(const std::string& path, int flags, unsigned mode, bool wait) {
  FileLock lock;
  const int file = ::open(path.c_str(), flags | O_RDWR | O_CLOEXEC | O_NONBLOCK, mode);
  lock.handle_ = file;
  const int error = file < 0 ? errno : lock_of(file, wait);
  lock.cause_ = {error, std::generic_category()};
  if (file < 0) return lock;
  lock.answer_ = error == 0 ? LockAnswer::kHeld : error == EAGAIN ? LockAnswer::kTaken : LockAnswer::kNoLocks;
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
