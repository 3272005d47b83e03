// Files of the page belong to this program alone, so a lock is kept in its memory.

#include "platform/posix/open_file_lock.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <condition_variable>
#include <mutex>
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

}  // namespace

int lock_open_file(int file, bool wait) {
  struct stat there {};
  if (::fstat(file, &there) != 0) return errno;
  std::unique_lock lock(locks().mutex);
  const auto is_free = [&] { return !locks().is_held(there.st_ino); };
  if (wait) locks().freed.wait(lock, is_free);
  if (!is_free()) return EAGAIN;
  locks().held.push_back({there.st_ino, file});
  return 0;
}

void unlock_open_file(int file) {
  const std::lock_guard lock(locks().mutex);
  std::erase_if(locks().held, [file](const Locked& one) { return one.file == file; });
  locks().freed.notify_all();
}

}  // namespace weftlight::platform
