#pragma once
// Saves the open documents beside the window, one after the other. Edits go on meanwhile; the history moves its saved
// mark when the file is on the disk, and until then the journal keeps the work.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/tasks.h"
#include "session/session.h"

namespace weftlight::session {

class Saver {
 public:
  using Then = std::function<void(const SaveResult&)>;
  /// Both outlive it. `runner` writes; its take() runs what follows a save.
  Saver(Session& session, base::TaskRunner& runner) : session_(session), runner_(runner) {}
  Saver(const Saver&) = delete;
  Saver& operator=(const Saver&) = delete;

  /// Saves the document as it is now. A save of the same document to the same file that still waits is replaced: its
  /// `then` follows the newer one too. `over_changes`: also if another program changed its file meanwhile.
  void save(uint64_t document, const std::string& path, bool over_changes, Then then);
  /// True while a save of the document runs or waits; of any document for 0.
  bool saving(uint64_t document) const;
  /// True while another document is being saved to this file.
  bool takes(const std::string& path, uint64_t but_for) const;
  /// Runs `then` when no save of the document (of any, for 0) runs or waits. Not if a save fails before: its own `then`
  /// tells the user, who decides anew.
  void after(uint64_t document, std::function<void()> then);
  /// True if something follows the saves of this document (0: of all).
  bool awaited(uint64_t document) const;

 private:
  struct Request {
    SaveJob job;
    std::vector<Then> then;
  };
  void start();
  void finish(const SaveResult& result);

  Session& session_;
  base::TaskRunner& runner_;
  std::vector<Request> requests_;  // oldest first; the first one is being written
  std::vector<std::pair<uint64_t, std::function<void()>>> after_;
};

}  // namespace weftlight::session
