#pragma once
// The open documents, each with its view and its journal, and the active one. No window and no dialogs: the caller has
// asked before it closes an unsaved document.

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "session/document/bring_back.h"
#include "session/document/document.h"
#include "session/editing/document_view.h"
#include "session/recovery/journal.h"
#include "session/recovery/recovery.h"
#include "session/save.h"

namespace weftlight::session {

using wif::Diagnostic;

/// Where a document comes from. An unedited document is replaced by the next: the initial one by any other, a shipped
/// draft by the next shipped one, so that browsing the library does not pile up tabs.
enum class Origin { kOwn, kFirst, kShipped };

/// What was selected, and active on the colour bars, at a step of the history.
struct KeptSelection {
  Selection selected;
  ThreadChoice chosen;
  int color = 0, yarn = 0;
};

struct OpenDocument {
  uint64_t id = 0;  // unique; also its number in the journal
  Document document;
  DocumentView view;
  std::vector<Diagnostic> remarks;  // about its file
  Origin origin = Origin::kOwn;
  std::map<uint64_t, KeptSelection> selections{};  // by the mark of the step; undo and redo bring them back
};

class Session {
 public:
  /// Unsaved work is kept in the folder `recovery`; `first` is the initial document.
  Session(std::string recovery, Document first);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// In the order of their tabs; at least one.
  const std::vector<std::unique_ptr<OpenDocument>>& all() const { return all_; }
  OpenDocument& active() { return *all_[active_]; }
  const OpenDocument& active() const { return *all_[active_]; }
  size_t active_place() const { return active_; }
  /// Null if it is no longer open.
  OpenDocument* find(uint64_t id);
  const OpenDocument* find(uint64_t id) const;
  /// The document of this file, by its name, and by the file as it was read just now, which may have other names; null
  /// if none is open. No disk is asked.
  OpenDocument* on_file(const std::string& path, const FileIdentity& file = {});
  std::vector<uint64_t> unsaved() const;
  /// Unique for every state of every document; grows with the edits of a document.
  uint64_t revision() const { return (active().id << kRevisionBits) + active().document.revision(); }
  /// True if that revision belongs to the active document.
  bool is_of_active(uint64_t revision) const { return revision >> kRevisionBits == active().id; }

  /// Opens a tab beside the active one, or replaces it (see Origin), and shows it.
  OpenDocument& add(Document document, Origin origin);
  /// Replaces the document of a tab, with a new view: for a reload.
  void replace(uint64_t id, Document document);
  void show(uint64_t id);
  /// The next tab (1) or the previous (-1), wrapping around.
  void step(int by);
  /// Moves the tab to a position in the tab strip.
  void move(uint64_t id, size_t place);
  /// Discards unsaved changes. `instead` makes the document that replaces the last one.
  void close(uint64_t id, Document (*instead)());

  // Edits of the active document, or of another one. True if its design changed.
  bool commit(const Edit& edit, uint64_t stroke) { return commit(active(), edit, stroke); }
  bool commit(OpenDocument& open, const Edit& edit, uint64_t stroke);
  bool undo();
  bool redo();
  /// Goes to a step of the history.
  bool go_to(size_t step);
  /// What a save of the document as it is now needs; it is written by write() of save.h, on any thread.
  SaveJob save_job(uint64_t id, const std::string& path) const;
  /// Updates the files in it of this document and the others.
  void tell_files(SaveJob& job) const;
  /// After write(): what was written counts as saved, edits made meanwhile do not. The document keeps its old file and
  /// its unsaved changes if it failed.
  void take_saved(const SaveJob& job, const SaveResult& result);
  /// Updates the journal after a direct change of the document.
  void keep_unsaved(const OpenDocument& open);
  /// Discards all unsaved changes.
  void forget_all();

  // Work of crashed sessions.
  /// Reads what crashed sessions left, newest first. From any thread, since a slow disk takes its time.
  std::vector<LeftWork> find_left() { return recovery_.left_behind(); }
  /// What find_left() returned is offered from now on.
  void set_left(std::vector<LeftWork> left) { left_ = std::move(left); }
  const std::vector<LeftWork>& left() const { return left_; }
  /// Opens what bring_back() made of that work (bring_back.h, for any thread), replacing the tab of its file if that
  /// has no unsaved changes. Null if it could not be read, or has been opened already: its journal stays.
  OpenDocument* take_back(const LeftWork& left, OpenResult back);
  void discard(size_t left);

  /// The error of the journal until a retry succeeds.
  std::string problem() const { return journal_.problem(); }
  bool busy() const { return journal_.busy(); }
  void settle() { journal_.settle(); }
  /// Waits until the journal has everything on disk, or failed, but no longer.
  void settle_for(std::chrono::milliseconds longest) { journal_.settle_for(longest); }

 private:
  static constexpr int kRevisionBits = 32;
  std::unique_ptr<OpenDocument> made(Document document, Origin origin);
  bool gives_way(const OpenDocument& open, Origin to) const;
  bool followed(OpenDocument& open, bool changed);
  /// Goes to another step of the history by `go`.
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
