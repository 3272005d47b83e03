// The Edit menu: the history, and the command palette.

#include "actions/action_parts.h"

namespace weftlight::actions {

using base::fill, base::tr;
using session::Settings;

void add_history_actions(Actions& all, const ActiveDraft& draft, Settings& settings) {
  Action& undo = add(all, "Edit", "undo", tr("Undo"), "Ctrl+Z", draft.undo);
  undo.enabled = [&draft] { return draft.document().history().can_undo(); };
  undo.label = [&draft] {
    const std::string step = draft.document().history().undo_label();
    return step.empty() ? tr("Undo") : fill(tr("Undo: {step}"), arg("step", step));
  };
  Action& redo = add(all, "Edit", "redo", tr("Redo"), "Ctrl+Shift+Z", draft.redo);
  redo.enabled = [&draft] { return draft.document().history().can_redo(); };
  redo.label = [&draft] {
    const std::string step = draft.document().history().redo_label();
    return step.empty() ? tr("Redo") : fill(tr("Redo: {step}"), arg("step", step));
  };
  Action& history = add(all, "Edit", "history", tr("History"), "Ctrl+H",
                        [&settings] { settings.show_history = !settings.show_history; });
  history.checked = [&settings] { return settings.show_history; };
}

void add_command_palette_action(Actions& all, const WindowActions& window) {
  new_group(add(all, "Edit", "commands", tr("Commands\xE2\x80\xA6"), "Ctrl+P", window.show_commands));
}

}  // namespace weftlight::actions
