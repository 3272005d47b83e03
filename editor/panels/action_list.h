#pragma once
// The actions as menu, toolbar and command palette show them. All three only name the action that was
// chosen; the editor's one table runs it.

#include <span>
#include <string>

#include "panels/panel.h"

namespace weftlight {

struct ActionItem {
  std::string id;        // "save"
  std::string menu;      // "File"; empty: only in the command palette
  std::string label;     // "Save"
  std::string shortcut;  // "Ctrl+S"
  std::string icon;      // Font Awesome glyph; with one it is in the toolbar
  bool enabled = true;
  bool checked = false;
  bool group = false;    // a line above it in the menu
};

/// The row at the top: menus, then the toolbar's icons, the title in the middle. Id of the action or "".
std::string draw_menu_bar(const PanelContext& c, std::span<const ActionItem> items, const std::string& title);

struct CommandPalette {
  bool open = false;
  bool appearing = false;
  std::string typed;
  int chosen = 0;
};
/// A list over the window, narrowed by typing; Enter runs the chosen one. Id of the action or "".
std::string draw_command_palette(const PanelContext& c, std::span<const ActionItem> items, CommandPalette& palette);

/// True when every letter of `typed` occurs in `label` in order, whatever the case; a better match scores
/// higher (runs and starts of words count more).
bool matches(const std::string& label, const std::string& typed, int& score);

}  // namespace weftlight
