#include "app/editing.h"

#include <optional>
#include <string>

namespace weftlight::app {

void Editing::commit(const Edit& edit) {
  if (session_.commit(edit, edit.stroke != 0 ? edit.stroke : strokes_.now())) return edited_();
  if (!edit.why) return;
  if (std::string why = edit.why(document().now()); !why.empty()) messages_.say(std::move(why));
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
  std::optional<RejectedEdit>& rejected_edit = view().rejected_edit;
  if (!rejected_edit || rejected_edit->closest || strokes_.going_on()) return;
  rejected_edit->closest = closest_weave_to(document().now(), *rejected_edit->requested);
  if (!rejected_edit->closest) rejected_edit.reset();
}

ActiveDraft Editing::actions() {
  return {.document = [this]() -> const Document& { return document(); },
          .view = [this]() -> DocumentView& { return view(); },
          .commit = [this](const Edit& edit) { commit(edit); },
          .undo = [this] { undo(); },
          .redo = [this] { redo(); }};
}

}  // namespace weftlight::app
