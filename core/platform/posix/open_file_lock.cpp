#include "platform/posix/open_file_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdint>

namespace weftlight::platform {

// As flock's: locks of the process would go when any part of the program closed the same file. Of one byte that no file
// reaches: some servers keep others from reading and writing what is locked.
int lock_open_file(int file, bool wait) {
  int result = 0;
#ifdef F_OFD_SETLK
  struct flock byte {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = static_cast<off_t>(INT64_MAX / 2);
  byte.l_len = 1;
  while ((result = ::fcntl(file, wait ? F_OFD_SETLKW : F_OFD_SETLK, &byte)) != 0 && errno == EINTR) {
  }
  if (result == 0) return 0;
  if (errno != EINVAL) return errno;
#endif
  // Systems without the former.
  while ((result = ::flock(file, wait ? LOCK_EX : LOCK_EX | LOCK_NB)) != 0 && errno == EINTR) {
  }
  return result == 0 ? 0 : errno;
}

void unlock_open_file(int /*file*/) {}  // closing it does

}  // namespace weftlight::platform
