#pragma once
// Keeps unsaved work on the disk, on threads of its own: what the hand did is in its file a tenth of a second later,
// however busy the window is. Of several states that wait the newest wins. One thread writes, another flushes: a busy
// disk takes half a second to flush, and nothing that is written meanwhile may wait for that.

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

#include "session/names.h"
#include "session/recovery.h"

namespace weftlight::session {

class Journal {
 public:
  /// `recovery` outlives it.
  explicit Journal(Recovery& recovery);
  /// Finishes what waits; a disk that refuses is asked once more and no longer.
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A number for a document of this session, never given twice.
  uint64_t new_document() { return ++documents_; }
  /// The document's newest state; `make_text` is called on the thread.
  void keep(uint64_t document, DocumentNote note, std::function<std::string()> make_text);
  /// The document is saved, or its changes are not wanted.
  void forget(uint64_t document);
  /// `left` goes once what was kept of `document` stands on the disk.
  void replace(const LeftWork& left, uint64_t document);
  void discard(const LeftWork& left);

  /// What stands wrong, naming file and cause, until it succeeds (it is tried again every second); else empty.
  std::string problem() const;
  /// Something is not on the disk yet.
  bool busy() const;
  /// Waits until everything is on the disk, or was refused.
  void settle();

 private:
  struct State {
    DocumentNote note;
    std::function<std::string()> make_text;
  };
  struct Written {  // how the document's journal stands
    DocumentNote note;
    std::string text;
    size_t appended = 0, entries = 0;
    bool whole = false;  // what is appended can be read
  };
  struct Task {  // what a document waits for
    std::optional<State> keep;
    bool forget = false;
    std::list<LeftWork> then;  // discarded when it succeeded
  };
  void post(uint64_t document, Task task);
  void work();
  void flush();
  void try_again(std::map<uint64_t, Task>::node_type task, std::string problem);
  std::string perform(uint64_t document, const Task& task);
  std::string write(uint64_t document, const State& state);

  Recovery& recovery_;
  uint64_t documents_ = 0;
  std::map<uint64_t, Written> written_;  // of the thread
  mutable std::mutex mutex_;
  std::condition_variable wake_, flush_, settled_;
  std::map<uint64_t, Task> waiting_;  // by document; of 0: what no document waits for
  std::map<uint64_t, std::string> problems_;
  std::chrono::steady_clock::time_point next_{};  // no entry before
  std::set<std::string> unflushed_;               // journals
  std::string flush_problem_;
  bool leaving_ = false, working_ = false, written_all_ = false, flushing_ = false;
  bool begin_anew_ = false;  // what was not flushed may be lost
  std::thread thread_, flusher_;
};

}  // namespace weftlight::session
