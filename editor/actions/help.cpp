// What helps.

#include "actions/action_parts.h"

namespace weftlight::actions {

void add_help_actions(Actions& all) {
  add(all, "Help", "tour", "A look round in five steps", "", [](ActionHost& e) { e.settings().tour = 0; });
  add(all, "Help", "keys", "Keys and mouse", "F1", [](ActionHost& e) { e.toggle_keys(); });
}

}  // namespace weftlight::actions
