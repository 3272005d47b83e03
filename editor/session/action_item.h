#pragma once
// An action as menus, keys and the command palette show it. The table that runs it is editor/actions.

#include <string>

#include "session/names.h"

namespace weftlight::session {

struct ActionItem {
  std::string id;        // "save"
  std::string menu;      // "File"; empty: only in the command palette
  std::string submenu;   // "Repeat": items that follow each other with the same one stand in it
  std::string label;     // "Save"
  std::string shortcut;  // "Ctrl+S"
  std::string shipped;   // shortcut, before the weaver chose another
  bool enabled = true;
  bool checked = false;
  bool group = false;         // a line above it in the menu
  bool on_selection = false;  // also in the menu of a right click on the selection
  bool on_tab = false;        // also in that of a right click on a draft's tab
};

}  // namespace weftlight::session
