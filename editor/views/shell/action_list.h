#pragma once
// Menu bar, toolbar, context menus, command palette and the window of shortcuts. They return the id of the chosen
// action; the editor's action table runs it. Menus and submenus of an ActionItem are marked texts, its label is already
// translated.

#include <span>
#include <string>
#include <vector>

#include "session/action_item.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ActionItem;

constexpr int kNoMenu = -1;
/// The row at the top: menus, toolbar, and the title in the middle. `opens`: the menu, counted from 0, that the
/// keyboard opens in this frame; afterwards the one that it opens in the next. Returns the id of the chosen action or
/// "".
std::string draw_menu_bar(const PanelContext& c, std::span<const ActionItem> items, const std::string& title,
                          int& opens);

/// The items of an open menu, with submenus. Named `prefix` + id in the map.
std::string draw_menu_items(const PanelContext& c, std::span<const ActionItem> items, const std::string& prefix);
/// A context menu of the items that belong there, if it is `due` or open. Named `name` + "." + id in the map.
std::string draw_context_menu(const PanelContext& c, std::span<const ActionItem> items, bool ActionItem::*belongs,
                              const char* name, bool due);

/// The window of mouse gestures and of the shortcuts of all actions. A click on a shortcut waits for a new one.
struct KeysWindow {
  bool open = false;
  std::string typed;      // search text
  std::string waiting;    // id of the action that waits for a key
  std::string pressed;    // the key that was pressed for it
  std::string requested;  // a key that another action has
  bool focused = false;   // has the keyboard
};
void draw_keys_window(PanelContext& c, std::span<const ActionItem> items, KeysWindow& window);
/// The action with that shortcut, except `except`; null if there is none.
const ActionItem* action_with_key(std::span<const ActionItem> items, const std::string& key, const std::string& except);

struct CommandPalette {
  bool open = false;
  bool appearing = false;
  std::string typed;
  int chosen = 0;
};
/// A list of all actions, filtered by typing; Enter runs the chosen one. Returns the id of the action or "".
std::string draw_command_palette(const PanelContext& c, std::span<const ActionItem> items, CommandPalette& palette);

/// How a label has the typed words, by the one that fits worst: not at all, inside of a word, where one begins, or
/// whole. Case and the marks of letters do not count.
enum class Fit { kNone, kInside, kBeginning, kWord };
Fit fit_of(const std::string& label, const std::string& typed);
/// The actions whose labels have the typed words, those that fit best first; all in their order if nothing is typed.
std::vector<const ActionItem*> found_actions(std::span<const ActionItem> items, const std::string& typed);

}  // namespace weftlight::views
