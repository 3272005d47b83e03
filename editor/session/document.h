#pragma once
// The open draft: the file as it was opened, the history of the design, and the drawdown kept in step.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draft/history.h"
#include "session/edit.h"
#include "session/file_identity.h"
#include "session/journal_format.h"
#include "session/names.h"
#include "wif/wif.h"

namespace weftlight::session {

class Document {
 public:
  /// A draft that never was a file.
  explicit Document(Design design);
  /// An opened one; `path` empty: an unnamed copy (the starter). `identity`: of the file that was read.
  Document(WifFile file, std::vector<Diagnostic> remarks, std::string path, FileIdentity identity = {});

  const Design& now() const { return history_.now(); }
  std::shared_ptr<const Design> snapshot() const { return history_.snapshot(); }
  const BitMatrix& cells() const { return cells_; }
  uint64_t revision() const { return revision_; }
  const History& history() const { return history_; }
  const std::vector<Diagnostic>& remarks() const { return remarks_; }
  const std::string& path() const { return path_; }
  /// File name; without a file what it was once called, or "Untitled".
  std::string name() const;
  /// The same for the eye: without a file the draft's title, where it has one.
  std::string shown_name() const;
  /// What the opened file measures threads in.
  WifUnit unit(System system) const;
  bool is_saved() const { return history_.is_saved(); }

  /// True when the design changed.
  bool commit(const Edit& edit, uint64_t stroke);
  bool undo();
  bool redo();
  /// To a step of the history.
  bool go_to(size_t step);
  /// `bytes`: what was written.
  void mark_saved(std::string path, std::string_view bytes);
  /// Nothing on the disk is what is shown.
  void mark_unsaved() { history_.mark_unsaved(); }
  /// It has no file (any more), and keeps its name.
  void without_file(std::string name);

  /// What another program did to the file since it was read or written; cheap where nothing was done.
  FileChange look_at_file() { return path_.empty() ? FileChange::kNone : changed_since(path_, file_); }
  /// The file may be replaced as it is now.
  void accept_file() { file_ = identify(path_); }
  /// For the journal.
  DocumentNote note() const;

  /// What a save writes: a function of values only, so that another thread may call it.
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

struct OpenResult {
  std::optional<Document> document;
  std::vector<Diagnostic> remarks;  // why it could not be opened
};
OpenResult open_document(const std::string& path);

}  // namespace weftlight::session
