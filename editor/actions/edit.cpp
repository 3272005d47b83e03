// Back and forth, the selection, and the list of all commands.

#include "actions/action_parts.h"

namespace weftlight::actions {

void add_edit_actions(Actions& all) {
  Action& undo = add(all, "Edit", "undo", "Undo", "Ctrl+Z", [](Desk& e) { e.undo(); });
  undo.enabled = [](const Desk& e) { return e.document().history().can_undo(); };
  Action& redo = add(all, "Edit", "redo", "Redo", "Ctrl+Shift+Z", [](Desk& e) { e.redo(); });
  redo.enabled = [](const Desk& e) { return e.document().history().can_redo(); };
  add_selection_actions(all);
  new_group(add(all, "Edit", "commands", "Commands\xE2\x80\xA6", "Ctrl+P", [](Desk& e) { e.show_commands(); }));
}

}  // namespace weftlight::actions
