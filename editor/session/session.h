#pragma once
// The documents that are open, each with its view and its journal, and which of them is shown. No window and no
// questions: who closes what is unsaved has asked before.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "session/bring_back.h"
#include "session/document.h"
#include "session/document_view.h"
#include "session/journal.h"
#include "session/names.h"
#include "session/recovery.h"

namespace weftlight::session {

/// Where a document comes from, which says whom it gives way to while nothing was done in it: what the window began
/// with to any other, a shipped draft to the next one, so that leafing through the library leaves no trail.
enum class Origin { kOwn, kFirst, kShipped };

struct OpenDocument {
  uint64_t id = 0;  // never given twice; also its number in the journal
  Document document;
  DocumentView view;
  std::vector<Diagnostic> remarks;  // on its file
  Origin origin = Origin::kOwn;
};

class Session {
 public:
  /// Unsaved work is kept in the folder `recovery`; `first` is what is open.
  Session(std::string recovery, Document first, bool per_inch);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// In the order of their tabs; at least one.
  const std::vector<std::unique_ptr<OpenDocument>>& all() const { return all_; }
  OpenDocument& active() { return *all_[active_]; }
  const OpenDocument& active() const { return *all_[active_]; }
  size_t active_place() const { return active_; }
  /// Null: it is no longer open.
  OpenDocument* find(uint64_t id);
  /// The one on this file; null: none is.
  OpenDocument* on_file(const std::string& path);
  std::vector<uint64_t> unsaved() const;
  /// Tells every state of every document from every other; grows with the edits of one.
  uint64_t revision() const { return (active().id << kRevisionBits) + active().document.revision(); }
  /// Whether the state of that revision was one of the active document's.
  bool is_of_active(uint64_t revision) const { return revision >> kRevisionBits == active().id; }

  /// Opens it beside the active one, or in its place where that gives way, and shows it.
  OpenDocument& add(Document document, Origin origin, bool per_inch);
  /// Another text in the same tab, its view begun anew: a file read again.
  void replace(uint64_t id, Document document, bool per_inch);
  void show(uint64_t id);
  /// The next tab (1) or the one before (-1), round and round.
  void step(int by);
  /// To the place in the row of tabs.
  void move(uint64_t id, size_t place);
  /// What was not saved in it is not wanted. Of the last one `instead` takes the place.
  void close(uint64_t id, Document (*instead)());

  // What is done in the active one. True when its design changed.
  bool commit(const Edit& edit, uint64_t stroke);
  bool undo();
  bool redo();
  /// To a step of the history.
  bool go_to(size_t step);
  /// What went wrong, or empty.
  std::string save(uint64_t id, const std::string& path);
  /// After something was done to `document` itself.
  void keep_unsaved(const OpenDocument& open);
  /// Nothing of what is unsaved is wanted.
  void forget_all();

  // What crashed sessions left.
  /// Newest first; looked for when the session began.
  const std::vector<LeftWork>& left() const { return left_; }
  /// Opens it, in the place of its file where that is open and untouched; none: why it cannot be read, and it stays
  /// where it is.
  OpenDocument* bring_back(size_t left, bool per_inch, std::vector<Diagnostic>& why);
  void discard(size_t left);

  /// What could not be journalled, until it is.
  std::string problem() const { return journal_.problem(); }
  bool busy() const { return journal_.busy(); }
  void settle() { journal_.settle(); }

 private:
  static constexpr int kRevisionBits = 32;
  std::unique_ptr<OpenDocument> made(Document document, Origin origin, bool per_inch);
  bool gives_way(const OpenDocument& open, Origin to) const;
  bool followed(bool changed);
  /// To another step of the history.
  template <class Go>
  bool gone(Go go);
  size_t place_of(uint64_t id) const;

  Recovery recovery_;
  Journal journal_;
  std::vector<std::unique_ptr<OpenDocument>> all_;
  size_t active_ = 0;
  std::vector<LeftWork> left_;
};

}  // namespace weftlight::session
