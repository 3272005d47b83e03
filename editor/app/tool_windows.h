#pragma once
// The windows inside the window: command palette, history, and the list of shortcuts.

#include <span>
#include <string>

#include "session/document/document.h"
#include "views/shell/action_list.h"
#include "views/shell/history_window.h"

namespace weftlight::app {

using session::ActionItem, session::Document;
using views::CommandPalette, views::HistoryWindow, views::KeysWindow, views::PanelContext, views::draw_command_palette,
    views::draw_history, views::draw_keys_window;

class ToolWindows {
 public:
  void show_commands() {
    commands_ = {};
    commands_.open = commands_.appearing = true;
  }
  bool shows_commands() const { return commands_.open; }
  void toggle_keys() { keys_.open = !keys_.open; }
  /// True while the history or the list of shortcuts has the keyboard: Escape closes it.
  bool have_keyboard() const { return history_.focused || keys_.focused; }
  /// The list of shortcuts takes the key if an action waits for a new one.
  bool take_key(const std::string& key) {
    if (keys_.waiting.empty()) return false;
    keys_.pressed = key;
    return true;
  }
  /// Draws the command palette; returns the id of the chosen action or "".
  std::string draw_commands(PanelContext& c, std::span<const ActionItem> items) {
    return draw_command_palette(c, items, commands_);
  }
  void draw_history_and_keys(PanelContext& c, const Document& document, std::span<const ActionItem> items) {
    draw_history(c, document, history_);
    draw_keys_window(c, items, keys_);
  }

 private:
  CommandPalette commands_;
  HistoryWindow history_;
  KeysWindow keys_;
};

}  // namespace weftlight::app
