#pragma once
// An action as menus, keys and the command palette show it. The table that runs it is editor/actions.

#include <string>

namespace weftlight::session {

struct ActionItem {
  std::string id;        // "save"
  std::string menu;      // "File"; empty if only the command palette lists it
  std::string submenu;   // "Repeat": consecutive items with the same name share a submenu
  std::string label;     // "Save"
  std::string shortcut;  // "Ctrl+S"
  std::string shipped;   // default shortcut, before the user chose another
  bool enabled = true;
  bool checked = false;
  bool group = false;         // a separator above it in the menu
  bool on_selection = false;  // also in the context menu of the selection
  bool on_tab = false;        // also in the context menu of a draft's tab
};

}  // namespace weftlight::session
