#pragma once
// The folder of unsaved work: a folder of its own for each session, with a journal of each document. The session's
// folder holds a lock for as long as the session lives, so that a crashed one is told from one that runs by nothing
// that could repeat, as the numbers of processes do. Where there are no locks no recovery copy is kept, which is said:
// nobody could tell whose it is.

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "platform/file_lock.h"
#include "session/journal_format.h"
#include "session/names.h"

namespace weftlight::session {

/// A document with unsaved work whose session is no more.
struct LeftWork {
  std::string journal;  // its file
  DocumentNote note;
  int64_t written_ns = 0;  // when its last entry was, since 1970
  std::string problem{};   // why it cannot be read, and then it says nothing of its document; empty: it can
};

/// For any thread.
class Recovery {
 public:
  /// In `root`, which is made when it is needed: state_folder()/recovery.
  explicit Recovery(std::string root);
  /// Takes the session's folder with it when no journal is left in it.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Makes the session's folder and its lock, anew when somebody took them away; what went wrong, or empty.
  std::string open();
  std::string journal_path(uint64_t document) const;

  /// What crashed sessions left, newest first, what cannot be read last. Their locks are held from now on, so that no
  /// other window offers the same. Folders with nothing in them go.
  std::vector<LeftWork> left_behind();
  /// Removes the journal, and its session's folder with the last one.
  void discard(const LeftWork& left);

 private:
  std::string root_, folder_;
  platform::FileLock lock_;
  std::mutex mutex_;
  std::map<std::string, platform::FileLock> crashed_;  // by folder
};

/// The last whole entry of a journal that was left; none: it cannot be read.
std::optional<JournalEntry> read_left(const LeftWork& left);

}  // namespace weftlight::session
