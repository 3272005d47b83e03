#pragma once
// A file lock as the sign that the owner of a file is alive. It ends with its process, however the process ends, and
// works between threads, processes, containers and, where the network share supports locks, machines. Process numbers
// are no such sign: they repeat, and elsewhere they mean another process or none.

#include <cstdint>
#include <string>
#include <system_error>

namespace weftlight::platform {

enum class LockAnswer {
  kHeld,
  kTaken,    // another owner holds it
  kNoLocks,  // the file system has no locks: the owner is unknown
  kNoFile,   // the file does not exist, or cannot be opened for writing
};

/// An open file and its lock. A forked process shares its parent's lock while it lives; a started program does not. The
/// locked byte lies beyond the end of any file, so others can still read and write the file.
class FileLock {
 public:
  FileLock() = default;
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  /// Locks a file, which is created if needed, readable by its user only.
  static FileLock take(const std::string& path);
  /// The same, but waits until the lock is free.
  static FileLock wait_for(const std::string& path);
  /// Locks an existing file that is not a symbolic link.
  static FileLock take_existing(const std::string& path);
  /// Creates and locks a new, empty file with the usual permissions; kNoFile if it exists already.
  static FileLock make(const std::string& path);

  LockAnswer answer() const { return answer_; }
  bool held() const { return answer_ == LockAnswer::kHeld; }
  /// Why the lock is not held.
  const std::error_code& cause() const { return cause_; }
  /// True if `path` still names the locked file. False if it was removed or renamed before the lock was acquired.
  bool stands_at(const std::string& path) const;

 private:
  static FileLock open(const std::string& path, int flags, unsigned mode, bool wait);
  std::intptr_t handle_ = -1;
  LockAnswer answer_ = LockAnswer::kNoFile;
  std::error_code cause_;
};

}  // namespace weftlight::platform
