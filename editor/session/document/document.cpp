#include "session/document/document.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text.h"
#include "base/utf8.h"
#include "design/edits.h"
#include "files/picture_draft.h"
#include "wif/other_formats.h"

namespace weftlight::session {

using base::content_hash, base::cut_utf8, base::mark, base::read_file, base::tr;
using draft::drawdown, draft::update_drawdown;
using wif::Severity, wif::WifRead, wif::kMaxDraftBytes, wif::read_draft, wif::write_new_wif, wif::write_wif;

namespace {

constexpr const char* kUntitled = mark("Untitled");  // journals hold the English name

/// A title without what names of files cannot hold on one system or another: "2/2 twill" becomes "2-2 twill".
std::string as_file_name(std::string_view title) {
  constexpr size_t kLongest = 100;  // bytes
  std::string name(cut_utf8(title, kLongest));
  for (char& ch : name)
    if (static_cast<unsigned char>(ch) < ' ' || std::string_view("/\\:*?\"<>|").find(ch) != std::string_view::npos)
      ch = '-';
  const size_t first = name.find_first_not_of(". "), last = name.find_last_not_of(". ");
  return first == std::string::npos ? std::string() : name.substr(first, last - first + 1);
}

}  // namespace

Document::Document(Design design) : history_(std::move(design)), cells_(drawdown(now().draft)) {}

Document::Document(WifFile file, std::vector<Diagnostic> remarks, std::string path, FileIdentity identity)
    : opened_(std::make_shared<const WifFile>(std::move(file))),
      remarks_(std::move(remarks)),
      path_(std::move(path)),
      file_(identity),
      history_(opened_->design),
      cells_(drawdown(now().draft)) {}

std::string Document::name() const {
  if (!path_.empty()) return std::filesystem::path(path_).filename().string();
  return old_name_.empty() ? tr(kUntitled) : old_name_;
}

std::string Document::shown_name() const {
  if (path_.empty() && old_name_.empty() && !now().title.empty()) return now().title;
  return name();
}

std::string Document::file_stem() const {
  if (is_named()) return std::filesystem::path(name()).stem().string();
  const std::string name = as_file_name(now().title);
  return name.empty() ? "untitled" : name;
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

bool Document::go_to(size_t step) {
  const auto before = snapshot();
  history_.go_to(step);
  return follow(before);
}

void Document::mark_saved(std::string path, const FileIdentity& file, const History::Mark& mark) {
  path_ = std::move(path);
  file_ = file;
  history_.mark_saved(mark);
}

void Document::without_file(std::string name) {
  path_.clear();
  file_ = {};
  old_name_ = name == kUntitled ? std::string() : std::move(name);
  history_.mark_unsaved();
}

DocumentNote Document::note() const {
  if (path_.empty()) return {{}, old_name_.empty() ? kUntitled : old_name_, {}};
  // The next session may start in another folder.
  std::error_code error;
  const std::filesystem::path full = std::filesystem::absolute(path_, error);
  return {error ? path_ : full.string(), name(), file_};
}

std::function<std::string()> Document::writer() const {
  return [file = opened_, design = snapshot()] { return file ? write_wif(*file, *design) : write_new_wif(*design); };
}

std::string name_of(const DocumentNote& note) { return note.name == kUntitled ? tr(kUntitled) : note.name; }

OpenResult open_document(const std::string& path, const std::stop_token& stop) {
  // Read before the bytes, so that a write in between is noticed.
  FileIdentity identity = facts_of(path);
  const bool picture = files::is_picture(path);
  const base::Result<std::string> file = read_file(path, picture ? base::kMaxFileBytes : kMaxDraftBytes, stop);
  if (!file)
    return {{}, {{Severity::kError, 0, file.error().text, tr("Check the path, and that the file may be read.")}}};
  WifRead read = picture ? files::read_picture_draft(path) : read_draft(*file);
  if (!read.file) return {{}, std::move(read.diagnostics)};
  identity.hash = content_hash(*file);
  if (read.file->format == "wif")
    return {Document(std::move(*read.file), std::move(read.diagnostics), path, identity), {}};
  // A file of another format is not overwritten: saving asks for a name.
  Document document(std::move(*read.file), std::move(read.diagnostics), {});
  document.without_file(std::filesystem::path(path).stem().string() + ".wif");
  return {std::move(document), {}};
}

}  // namespace weftlight::session
