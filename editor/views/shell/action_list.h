#pragma once
// The actions as menu, toolbar and command palette show them. All three only name the action that was
// chosen; the editor's one table runs it.

#include <span>
#include <string>
#include <vector>

#include "session/action_item.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// The row at the top: menus, then the toolbar's icons, the title in the middle. Id of the action or "".
std::string draw_menu_bar(const PanelContext& c, std::span<const ActionItem> items, const std::string& title);

/// The items one below the other, submenus too; for an open menu. Named `prefix` + id in the map.
std::string draw_menu_items(const PanelContext& c, std::span<const ActionItem> items, const std::string& prefix);
/// What a right click offers: the items that belong there, when the menu is due or stands open. Named `name` + "." + id
/// in the map.
std::string draw_context_menu(const PanelContext& c, std::span<const ActionItem> items, bool ActionItem::*belongs,
                              const char* name, bool due);

/// What the mouse does, and the key of every action, in a window of their own. A click on a key waits for another.
struct KeysWindow {
  bool open = false;
  std::string typed;    // what is looked for
  std::string waiting;  // action that the next key is for
  std::string pressed;  // that key, when it came
  std::string wanted;   // a key that another action has
};
void draw_keys_window(PanelContext& c, std::span<const ActionItem> items, KeysWindow& window);
/// The action that has the key, other than `but`; null: none.
const ActionItem* holder_of(std::span<const ActionItem> items, const std::string& key, const std::string& but);

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

}  // namespace weftlight::views
