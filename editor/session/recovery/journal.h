#pragma once
// Keeps unsaved work on disk, on its own threads: an edit is in the journal a tenth of a second later, however busy the
// window is. Of several waiting states only the newest is written. One thread writes, another flushes, because a busy
// disk takes half a second to flush and writes must not wait for that.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "session/recovery/recovery.h"

namespace weftlight::session {

class Journal {
 public:
  /// `recovery` outlives it.
  explicit Journal(Recovery& recovery);
  /// Finishes the waiting tasks; each failing one is tried once more.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A unique number for a document of this session.
  uint64_t new_document() { return ++documents_; }
  /// Writes the newest state of the document; `make_text` is called on the writing thread.
  void keep(uint64_t document, DocumentNote note, std::function<std::string()> make_text);
  /// Removes the journal: the document is saved or its changes are discarded.
  void forget(uint64_t document);
  /// Removes `left` once the journal of `document` is on disk.
  void replace(const LeftWork& left, uint64_t document);
  void discard(const LeftWork& left);

  /// The message of the current error with file and cause, until a retry succeeds (one per second); else empty.
  std::string problem() const;
  /// True while something is not on disk yet.
  bool busy() const;
  /// Waits until everything is on disk or has failed.
  void settle();
  /// The same for at most this time.
  void settle_for(std::chrono::milliseconds longest);

 private:
  struct State {
    DocumentNote note;
    std::function<std::string()> make_text;
  };
  struct Written {  // state of the journal of a document
    DocumentNote note;
    std::string text;
    size_t appended = 0, entries = 0;
    bool whole = false;  // the file is intact, so that entries can be appended
  };
  struct WaitingWork {  // of a document
    std::optional<State> keep;
    bool forget = false;
    std::list<LeftWork> then;  // discarded after success
  };
  void post(uint64_t document, WaitingWork task);
  void work();
  void flush();
  void try_again(std::map<uint64_t, WaitingWork>::node_type task, base::Error error);
  base::Result<void> perform(uint64_t document, const WaitingWork& task);
  base::Result<void> write(uint64_t document, const State& state);
  bool settled() const;

  Recovery& recovery_;
  uint64_t documents_ = 0;
  std::map<uint64_t, Written> written_;  // used by the writing thread only
  mutable std::mutex mutex_;
  std::condition_variable wake_, flush_, settled_;
  std::map<uint64_t, WaitingWork> waiting_;  // by document; 0 for tasks without a document
  std::map<uint64_t, base::Error> errors_;
  std::chrono::steady_clock::time_point next_{};  // earliest time of the next write
  std::set<std::string> unflushed_;               // journals
  base::Result<void> flushed_;                    // the last flush
  bool leaving_ = false, working_ = false, written_all_ = false, flushing_ = false;
  bool begin_anew_ = false;  // start all journals again: unflushed entries may be lost
  std::thread thread_, flusher_;
};

}  // namespace weftlight::session
