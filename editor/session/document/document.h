#pragma once
// An open draft: the file as it was opened, the history of the design, and the current drawdown.

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "design/history.h"
#include "session/document/edit.h"
#include "session/files/file_identity.h"
#include "session/recovery/journal_format.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design, design::History;
using draft::BitMatrix, draft::System;
using wif::Diagnostic, wif::WifFile, wif::WifUnit;

class Document {
 public:
  /// A draft without a file.
  explicit Document(Design design);
  /// An opened file. An empty `path` makes an unnamed copy (the starter draft). `identity` is that of the file as read.
  Document(WifFile file, std::vector<Diagnostic> remarks, std::string path, FileIdentity identity = {});

  const Design& now() const { return history_.now(); }
  std::shared_ptr<const Design> snapshot() const { return history_.snapshot(); }
  const BitMatrix& cells() const { return cells_; }
  uint64_t revision() const { return revision_; }
  const History& history() const { return history_; }
  const std::vector<Diagnostic>& remarks() const { return remarks_; }
  const std::string& path() const { return path_; }
  /// File name, for people. Without a file the former name, or "Untitled", translated.
  std::string name() const;
  /// True if it has or had a file.
  bool is_named() const { return !path_.empty() || !old_name_.empty(); }
  /// The name to show: without a file the title of the draft, if it has one.
  std::string shown_name() const;
  /// What a new file of the draft is called, without an ending: as its file, after its title, or "untitled".
  std::string file_stem() const;
  /// The unit of length of the threads in the opened file.
  WifUnit unit(System system) const;
  bool is_saved() const { return history_.is_saved(); }

  /// True when the design changed.
  bool commit(const Edit& edit, uint64_t stroke);
  bool undo();
  bool redo();
  /// Goes to a step of the history.
  bool go_to(size_t step);
  /// What has this mark in the history is on disk, as `file` at `path`.
  void mark_saved(std::string path, const FileIdentity& file, const History::Mark& mark);
  /// The disk no longer holds what is shown.
  void mark_unsaved() { history_.mark_unsaved(); }
  /// Detaches the document from its file; it keeps the name.
  void without_file(std::string name);

  /// How another program changed the file since it was read or written. Cheap if nothing changed.
  FileChange look_at_file() { return path_.empty() ? FileChange::kNone : changed_since(path_, file_); }
  /// The file as it was read or written last.
  const FileIdentity& file() const { return file_; }
  /// Accepts the file as it is now, so that a save may replace it.
  void accept_file() { accept(identify(path_)); }
  void accept(const FileIdentity& file) { file_ = file; }
  /// The header of its journal.
  DocumentNote note() const;

  /// Makes the text of a save. It holds values only, so that any thread may call it.
  std::function<std::string()> writer() const;

 private:
  bool follow(const std::shared_ptr<const Design>& before);

  std::shared_ptr<const WifFile> opened_;
  std::vector<Diagnostic> remarks_;
  std::string path_, old_name_;
  FileIdentity file_;
  History history_;
  BitMatrix cells_;
  uint64_t revision_ = 1;
};

/// The name in the header of a journal, for people: that of a document without one is kept in English.
std::string name_of(const DocumentNote& note);

struct OpenResult {
  std::optional<Document> document;
  std::vector<Diagnostic> remarks;  // why it could not be opened
};
/// Ends with an error soon after a request to stop.
OpenResult open_document(const std::string& path, const std::stop_token& stop = {});

}  // namespace weftlight::session
