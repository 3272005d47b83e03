#pragma once
// The open draft: the file as it was opened, the history of the design, and the drawdown kept in step.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "draft/history.h"
#include "session/edit.h"
#include "session/names.h"
#include "wif/wif.h"

namespace weftlight::session {

class Document {
 public:
  /// A draft that never was a file.
  explicit Document(Design design);
  /// An opened one; `path` empty: an unnamed copy (the starter).
  Document(WifFile file, std::vector<Diagnostic> remarks, std::string path);

  const Design& now() const { return history_.now(); }
  std::shared_ptr<const Design> snapshot() const { return history_.snapshot(); }
  const BitMatrix& cells() const { return cells_; }
  uint64_t revision() const { return revision_; }
  const History& history() const { return history_; }
  const std::vector<Diagnostic>& remarks() const { return remarks_; }
  const std::string& path() const { return path_; }
  /// File name, or "Untitled".
  std::string name() const;
  /// What the opened file measures threads in.
  WifUnit unit(System system) const;
  bool is_saved() const { return history_.is_saved(); }

  /// True when the design changed.
  bool commit(const Edit& edit, uint64_t stroke);
  bool undo();
  bool redo();
  void mark_saved(std::string path);

  /// What a save writes: a function of values only, so that another thread may call it.
  std::function<std::string()> writer() const;

 private:
  bool follow(const std::shared_ptr<const Design>& before);

  std::shared_ptr<const WifFile> opened_;
  std::vector<Diagnostic> remarks_;
  std::string path_;
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
