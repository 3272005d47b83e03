#pragma once
// The lock of an open file, on which FileLock (platform/file_lock.h) is built.

namespace weftlight::platform {

/// Locks the whole of an open file for its owner; waits until it is free, or not. 0, or errno: EAGAIN, EACCES or
/// EWOULDBLOCK where another owner holds it.
int lock_open_file(int file, bool wait);
/// Frees the lock of a file that is about to be closed.
void unlock_open_file(int file);

}  // namespace weftlight::platform
