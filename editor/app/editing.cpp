#include "app/editing.h"

#include <string>
#include <utility>

namespace weftlight::app {

using session::OpenDocument;

void Editing::commit(const Edit& edit) {
  if (session_.commit(edit, edit.stroke != 0 ? edit.stroke : strokes_.now())) return edited_();
  if (!edit.why) return;
  if (std::string why = edit.why(document().now()); !why.empty()) messages_.refuse(std::move(why));
}

void Editing::commit_to(uint64_t id, const Edit& edit) {
  OpenDocument* open = session_.find(id);
  if (open != nullptr && session_.commit(*open, edit, 0) && open == &session_.active()) edited_();
}

void Editing::take_computed() {
  SlowEdits::Outcome outcome = slow_edits_.take_outcome();
  if (outcome.edited) edited_();
  if (!outcome.said.empty()) messages_.refuse(std::move(outcome.said));
}

bool Editing::commit(const TypedKey& typed) {
  for (const Edit& edit : typed.edits) commit(edit);
  return typed.taken;
}

void Editing::undo() {
  if (session_.undo()) edited_();
}

void Editing::redo() {
  if (session_.redo()) edited_();
}

void Editing::go_to_step(size_t step) {
  if (session_.go_to(step)) edited_();
}

void Editing::find_closest_weave() {
  if (!strokes_.going_on()) slow_edits_.find_closest_weave();
}

ActiveDraft Editing::actions() {
  return {.document = [this]() -> const Document& { return document(); },
          .view = [this]() -> DocumentView& { return view(); },
          .commit = [this](const Edit& edit) { commit(edit); },
          .compute = [this](const SlowEdit& edit) { compute(edit); },
          .undo = [this] { undo(); },
          .redo = [this] { redo(); }};
}

}  // namespace weftlight::app
