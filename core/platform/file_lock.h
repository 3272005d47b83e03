#pragma once
// A lock on a file that tells whether its owner lives: it ends with the process, however that ends, and holds between
// threads, processes, containers and, where the share carries locks, machines. Numbers of processes tell nothing of the
// kind: they repeat, and mean another process or none elsewhere.

#include <string>

namespace weftlight::platform {

enum class LockAnswer {
  kHeld,
  kTaken,    // another has it
  kNoLocks,  // the file system has none: who owns the file cannot be told
  kNoFile,   // it is not there, or cannot be opened for writing
};

/// An open file with its lock. A forked process keeps the lock of its parent for as long as it lives; a started program
/// does not get it. What is locked lies beyond the end of any file: others may read and write it meanwhile.
class FileLock {
 public:
  FileLock() = default;
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  /// Makes the file where it is not there, for its user alone.
  static FileLock take(const std::string& path);
  /// The same, waiting until nobody else has it.
  static FileLock wait_for(const std::string& path);
  /// Of a file that is there, and no link; makes none.
  static FileLock take_existing(const std::string& path);
  /// Makes a new file, empty, as programs make files; kNoFile where there is one already.
  static FileLock make(const std::string& path);

  LockAnswer answer() const { return answer_; }
  bool held() const { return answer_ == LockAnswer::kHeld; }
  /// errno of what is not held; 0: it is.
  int cause() const { return cause_; }
  /// Whether `path` still leads to the file that was opened: not where somebody removed or renamed it before the lock
  /// was had.
  bool stands_at(const std::string& path) const;

 private:
  static FileLock open(const std::string& path, int flags, unsigned mode, bool wait);
  int file_ = -1;
  LockAnswer answer_ = LockAnswer::kNoFile;
  int cause_ = 0;
};

}  // namespace weftlight::platform
