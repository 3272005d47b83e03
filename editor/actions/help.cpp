// The Help menu.

#include "actions/action_parts.h"

namespace weftlight::actions {

void add_help_actions(Actions& all) {
  add(all, "Help", "tour", tr("Tour in five steps"), "", [](ActionHost& e) { e.settings().tour = 0; });
  add(all, "Help", "keys", tr("Keys and mouse"), "F1", [](ActionHost& e) { e.toggle_keys(); });
}

}  // namespace weftlight::actions
