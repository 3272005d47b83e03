// Back and forth in the history, the selection, and the list of all commands.

#include "actions/action_parts.h"

namespace weftlight::actions {
namespace {

/// "Undo: Paint threading".
std::string with_step(const char* verb, const std::string& step) {
  return step.empty() ? verb : std::string(verb) + ": " + step;
}

}  // namespace

void add_edit_actions(Actions& all) {
  Action& undo = add(all, "Edit", "undo", "Undo", "Ctrl+Z", [](ActionHost& e) { e.undo(); });
  undo.enabled = [](const ActionHost& e) { return e.document().history().can_undo(); };
  undo.label = [](const ActionHost& e) { return with_step("Undo", e.document().history().undo_label()); };
  Action& redo = add(all, "Edit", "redo", "Redo", "Ctrl+Shift+Z", [](ActionHost& e) { e.redo(); });
  redo.enabled = [](const ActionHost& e) { return e.document().history().can_redo(); };
  redo.label = [](const ActionHost& e) { return with_step("Redo", e.document().history().redo_label()); };
  Action& history = add(all, "Edit", "history", "History", "Ctrl+H",
                        [](ActionHost& e) { e.settings().show_history = !e.settings().show_history; });
  history.checked = [](const ActionHost& e) { return e.settings().show_history; };
  add_selection_actions(all);
  new_group(add(all, "Edit", "commands", "Commands\xE2\x80\xA6", "Ctrl+P", [](ActionHost& e) { e.show_commands(); }));
}

}  // namespace weftlight::actions
