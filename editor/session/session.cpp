#include "session/session.h"

#include <algorithm>
#include <utility>

#include "session/editing/follow_document.h"
#include "session/editing/selection_state.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design, design::History;

Session::Session(std::string recovery, Document first) : recovery_(std::move(recovery)), journal_(recovery_) {
  all_.push_back(made(std::move(first), Origin::kFirst));
}

std::unique_ptr<OpenDocument> Session::made(Document document, Origin origin) {
  const DocumentView view = view_of(document);
  std::vector<Diagnostic> remarks = document.remarks();
  auto open = std::make_unique<OpenDocument>(
      OpenDocument{journal_.new_document(), std::move(document), view, std::move(remarks), origin});
  keep_unsaved(*open);
  return open;
}

size_t Session::place_of(uint64_t id) const {
  const auto at = std::find_if(all_.begin(), all_.end(), [id](const auto& open) { return open->id == id; });
  return static_cast<size_t>(at - all_.begin());
}

OpenDocument* Session::find(uint64_t id) {
  const size_t place = place_of(id);
  return place < all_.size() ? all_[place].get() : nullptr;
}

const OpenDocument* Session::find(uint64_t id) const {
  const size_t place = place_of(id);
  return place < all_.size() ? all_[place].get() : nullptr;
}

OpenDocument* Session::on_file(const std::string& path, const FileIdentity& file) {
  for (const auto& open : all_) {
    const Document& d = open->document;
    if (!d.path().empty() && (is_same_name(d.path(), path) || is_one_file(d.file(), file))) return open.get();
  }
  return nullptr;
}

std::vector<uint64_t> Session::unsaved() const {
  std::vector<uint64_t> ids;
  for (const auto& open : all_)
    if (!open->document.is_saved()) ids.push_back(open->id);
  return ids;
}

bool Session::gives_way(const OpenDocument& open, Origin to) const {
  const History& history = open.document.history();
  if (!open.document.is_saved() || history.can_undo() || history.can_redo()) return false;
  return open.origin == Origin::kFirst || (open.origin == Origin::kShipped && to == Origin::kShipped);
}

OpenDocument& Session::add(Document document, Origin origin) {
  auto open = made(std::move(document), origin);
  if (gives_way(active(), origin)) all_[active_] = std::move(open);
  else all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(++active_), std::move(open));
  return active();
}

void Session::replace(uint64_t id, Document document) {
  const size_t place = place_of(id);
  if (place == all_.size()) return;
  journal_.forget(id);
  all_[place] = made(std::move(document), Origin::kOwn);
}

void Session::show(uint64_t id) {
  if (const size_t place = place_of(id); place < all_.size()) active_ = place;
}

void Session::step(int by) {
  const auto count = static_cast<int>(all_.size());
  active_ = static_cast<size_t>((static_cast<int>(active_) + by % count + count) % count);
}

void Session::move(uint64_t id, size_t place) {
  const size_t from = place_of(id), to = std::min(place, all_.size() - 1);
  if (from == all_.size() || from == to) return;
  const uint64_t shown = active().id;
  auto open = std::move(all_[from]);
  all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(from));
  all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(to), std::move(open));
  show(shown);
}

void Session::close(uint64_t id, Document (*instead)()) {
  const size_t place = place_of(id);
  if (place == all_.size()) return;
  journal_.forget(id);
  if (all_.size() == 1) {
    all_.front() = made(instead(), Origin::kFirst);
    return;
  }
  all_.erase(all_.begin() + static_cast<std::ptrdiff_t>(place));
  // Shows the tab that takes its position, or the last one.
  if (place < active_ || active_ == all_.size()) --active_;
}

bool Session::followed(OpenDocument& open, bool changed) {
  if (!changed) return false;
  open.view.rejected_edit.reset();
  follow_document(open.view, open.document);
  keep_unsaved(open);
  return true;
}

namespace {

constexpr size_t kMaxKept = 1000;  // selections of a document

void keep_selection(OpenDocument& open, uint64_t step, const Selection& selected) {
  open.selections[step] = {selected, open.view.chosen, open.view.drawing.color, open.view.drawing.yarn};
  if (open.selections.size() > kMaxKept) open.selections.erase(open.selections.begin());
}

/// Before an edit: a move has shifted the selection already.
Selection selected_before(const SelectState& s, const Design& before) {
  return s.move && *s.move->base == before ? s.move->from : s.selected;
}

/// Nothing is taken from what is selected now if nothing was selected then.
void bring_selection_back(OpenDocument& open) {
  const auto kept = open.selections.find(open.document.history().mark().step);
  if (kept == open.selections.end()) return;
  const Draft& draft = open.document.now().draft;
  const Selection& selected = kept->second.selected;
  if (!selected.empty() && is_shown(draft, selected.grid)) select_cells(open.view.select, clipped(selected, draft));
  if (kept->second.chosen.threads.empty()) return;
  open.view.chosen = kept->second.chosen;
  open.view.chosen.dragging = false;
  limit_choice(open.view.chosen, draft);
}

/// Where an active colour or yarn went with its step, what was active before it is so again.
void bring_active_back(OpenDocument& open, int color, int yarn) {
  const auto kept = open.selections.find(open.document.history().mark().step);
  if (kept == open.selections.end()) return;
  const Design& design = open.document.now();
  const auto exists = [](int index, const auto& list) { return index < static_cast<int>(list.size()); };
  DrawingState& drawing = open.view.drawing;
  if (!exists(color, design.draft.palette) && exists(kept->second.color, design.draft.palette))
    drawing.color = kept->second.color;
  if (!exists(yarn, design.yarns) && exists(kept->second.yarn, design.yarns)) drawing.yarn = kept->second.yarn;
}

}  // namespace

bool Session::commit(OpenDocument& open, const Edit& edit, uint64_t stroke) {
  const std::shared_ptr<const Design> before = open.document.snapshot();
  const uint64_t from = open.document.history().mark().step;
  const Selection selected = selected_before(open.view.select, *before);
  const bool changed = open.document.commit(edit, stroke);
  if (changed) keep_selection(open, from, selected);
  std::optional<RejectedEdit> rejected_edit =
      refusal_after(std::move(open.view.rejected_edit), *before, edit, stroke, changed);
  if (changed) follow_given(open.view.drawing.given, before->draft, open.document.now().draft, edit.by_painting);
  // Painting goes on where it is; another edit that adds shafts or treadles leaves a fitted draft fitted.
  const Draft& now = open.document.now().draft;
  if (changed && !edit.by_painting && (now.shafts > before->draft.shafts || now.treadles > before->draft.treadles))
    open.view.draft.has_grown = true;
  followed(open, changed);
  open.view.rejected_edit = std::move(rejected_edit);
  return changed;
}

template <class Go>
bool Session::gone(Go go) {
  OpenDocument& open = active();
  const std::shared_ptr<const Design> before = open.document.snapshot();
  keep_selection(open, open.document.history().mark().step, open.view.select.selected);
  const auto [color, yarn] = std::pair(open.view.drawing.color, open.view.drawing.yarn);
  if (!followed(open, go(open.document))) return false;
  bring_selection_back(open);
  bring_active_back(open, color, yarn);
  follow_given(open.view.drawing.given, before->draft, open.document.now().draft, true);
  return true;
}

bool Session::undo() {
  return gone([](Document& d) { return d.undo(); });
}
bool Session::redo() {
  return gone([](Document& d) { return d.redo(); });
}
bool Session::go_to(size_t step) {
  return gone([step](Document& d) { return d.go_to(step); });
}

SaveJob Session::save_job(uint64_t id, const std::string& path) const {
  const OpenDocument* open = find(id);
  if (open == nullptr) return {};
  const Document& d = open->document;
  SaveJob job{id, path, d.writer(), d.history().mark()};
  tell_files(job);
  return job;
}

void Session::tell_files(SaveJob& job) const {
  job.others.clear();
  for (const auto& open : all_) {
    const Document& d = open->document;
    if (open->id != job.document) {
      if (d.file().there) job.others.push_back(d.file());
    } else {
      job.own_path = d.path();
      job.own_file = d.file();
    }
  }
}

void Session::take_saved(const SaveJob& job, const SaveResult& result) {
  OpenDocument* open = find(job.document);
  if (open == nullptr || !is_written(result)) return;
  open->document.mark_saved(result->path, result->file, job.mark);
  open->origin = Origin::kOwn;
  keep_unsaved(*open);
}

void Session::keep_unsaved(const OpenDocument& open) {
  if (open.document.is_saved()) journal_.forget(open.id);
  else journal_.keep(open.id, open.document.note(), open.document.writer());
}

void Session::forget_all() {
  for (const auto& open : all_) journal_.forget(open->id);
}

OpenDocument* Session::take_back(const LeftWork& left, OpenResult back) {
  const auto taken =
      std::erase_if(left_, [&](const LeftWork& l) { return back.document && l.journal == left.journal; });
  if (taken == 0) return nullptr;
  OpenDocument* there = back.document->path().empty() ? nullptr : on_file(back.document->path(), back.document->file());
  if (there != nullptr && there->document.is_saved()) {
    show(there->id);
    replace(there->id, std::move(*back.document));
  } else {
    if (there != nullptr) back.document->without_file(back.document->name());
    add(std::move(*back.document), Origin::kOwn);
  }
  journal_.replace(left, active().id);
  return &active();
}

void Session::discard(size_t which) {
  journal_.discard(left_[which]);
  left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(which));
}

}  // namespace weftlight::session
