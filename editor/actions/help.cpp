// The Help menu.

#include "actions/action_parts.h"

namespace weftlight::actions {

using base::tr;
using session::Settings;

void add_help_actions(Actions& all, const WindowActions& window, Settings& settings) {
  add(all, "Help", "tour", tr("Tour in five steps"), "", [&settings] { settings.tour = 0; });
  add(all, "Help", "menus", tr("Open the menus with the keyboard"), "F10", window.open_menus);
  add(all, "Help", "keys", tr("Keys and mouse"), "F1", window.toggle_keys);
}

}  // namespace weftlight::actions
