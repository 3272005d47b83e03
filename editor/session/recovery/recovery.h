#pragma once
// The folder of unsaved work: one folder per session, with a journal per document. A session locks its folder while it
// runs, which tells crashed sessions from running ones; process ids would repeat. Without file locks no recovery copy
// is kept, and this is reported, because its owner would be unknown.

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"
#include "platform/file_lock.h"
#include "session/recovery/journal_format.h"

namespace weftlight::session {

/// Unsaved work of a crashed session.
struct LeftWork {
  std::string journal;              // path of the journal
  base::Result<DocumentNote> note;  // or why the journal cannot be read
  int64_t written_ns = 0;           // time of its last entry, since 1970
};

/// Where Weftlight keeps it, and reports of its crashes (crash_reports.h).
std::string recovery_folder();

/// Thread-safe.
class Recovery {
 public:
  /// `root` is recovery_folder(), or another in tests; it is created when needed.
  explicit Recovery(std::string root);
  /// Removes the folder of the session if no journal is left in it.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  /// Creates the folder of the session, which its user alone can read, and its lock, again if they were removed.
  base::Result<void> open();
  std::string journal_path(uint64_t document) const;

  /// Work of crashed sessions, newest first, unreadable work last. Their locks are held from now on, so that no other
  /// window offers the same work. Empty folders are removed.
  std::vector<LeftWork> left_behind();
  /// Removes the journal, and the folder of its session after the last one.
  void discard(const LeftWork& left);

 private:
  std::string root_, folder_;
  // Two, so that a slow disk with old journals holds up none of this session.
  std::mutex own_, others_;
  platform::FileLock lock_;                            // guarded by own_
  std::map<std::string, platform::FileLock> crashed_;  // by folder; guarded by others_
};

/// The last complete entry of the journal.
base::Result<JournalEntry> read_left(const LeftWork& left);

}  // namespace weftlight::session
