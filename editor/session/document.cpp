#include "session/document.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "draft/edits.h"

namespace weftlight::session {

Document::Document(Design design) : history_(std::move(design)), cells_(drawdown(now().draft)) {}

Document::Document(WifFile file, std::vector<Diagnostic> remarks, std::string path)
    : opened_(std::make_shared<const WifFile>(std::move(file))),
      remarks_(std::move(remarks)),
      path_(std::move(path)),
      history_(opened_->design),
      cells_(drawdown(now().draft)) {}

std::string Document::name() const {
  return path_.empty() ? "Untitled" : std::filesystem::path(path_).filename().string();
}

WifUnit Document::unit(System system) const {
  if (!opened_) return {};
  return system == System::kWarp ? opened_->warp_unit : opened_->weft_unit;
}

bool Document::follow(const std::shared_ptr<const Design>& before) {
  if (before == history_.snapshot()) return false;
  update_drawdown(cells_, before->draft, now().draft);
  ++revision_;
  return true;
}

bool Document::commit(const Edit& edit, uint64_t stroke) {
  const auto before = snapshot();
  history_.commit(edit.apply(*before), edit.label, stroke);
  return follow(before);
}

bool Document::undo() {
  const auto before = snapshot();
  if (history_.can_undo()) history_.undo();
  return follow(before);
}

bool Document::redo() {
  const auto before = snapshot();
  if (history_.can_redo()) history_.redo();
  return follow(before);
}

void Document::mark_saved(std::string path) {
  path_ = std::move(path);
  history_.mark_saved();
}

std::function<std::string()> Document::writer() const {
  return [file = opened_, design = snapshot()] { return file ? write_wif(*file, *design) : write_new_wif(*design); };
}

OpenResult open_document(const std::string& path) {
  FileBytes file = read_file(path);
  if (!file.error.empty())
    return {{}, {{Severity::kError, 0, file.error, "Check the path, and that the file may be read."}}};
  WifRead read = read_wif(file.bytes);
  if (!read.file) return {{}, std::move(read.diagnostics)};
  return {Document(std::move(*read.file), std::move(read.diagnostics), path), {}};
}

}  // namespace weftlight::session
