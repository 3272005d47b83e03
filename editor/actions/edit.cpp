// The Edit menu: history, selection, and the command palette.

#include "actions/action_parts.h"

namespace weftlight::actions {
void add_edit_actions(Actions& all) {
  Action& undo = add(all, "Edit", "undo", tr("Undo"), "Ctrl+Z", [](ActionHost& e) { e.undo(); });
  undo.enabled = [](const ActionHost& e) { return e.document().history().can_undo(); };
  undo.label = [](const ActionHost& e) {
    const std::string step = e.document().history().undo_label();
    return step.empty() ? tr("Undo") : fill(tr("Undo: {step}"), arg("step", step));
  };
  Action& redo = add(all, "Edit", "redo", tr("Redo"), "Ctrl+Shift+Z", [](ActionHost& e) { e.redo(); });
  redo.enabled = [](const ActionHost& e) { return e.document().history().can_redo(); };
  redo.label = [](const ActionHost& e) {
    const std::string step = e.document().history().redo_label();
    return step.empty() ? tr("Redo") : fill(tr("Redo: {step}"), arg("step", step));
  };
  Action& history = add(all, "Edit", "history", tr("History"), "Ctrl+H",
                        [](ActionHost& e) { e.settings().show_history = !e.settings().show_history; });
  history.checked = [](const ActionHost& e) { return e.settings().show_history; };
  add_selection_actions(all);
  new_group(
      add(all, "Edit", "commands", tr("Commands\xE2\x80\xA6"), "Ctrl+P", [](ActionHost& e) { e.show_commands(); }));
}

}  // namespace weftlight::actions
