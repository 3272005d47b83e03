#pragma once
// Dialogs, menus and lists by keyboard alone. While one is open, the arrows and Space are ImGui's; Tab, Enter and
// Escape are ours: versions of ImGui differ in them. Nothing here acts on the main window, whose arrows are shortcuts.

#include "ui/ui_map.h"

namespace weftlight::ui {

/// Call before every frame.
void begin_keyboard();
/// Menus, lists and dialogs that are open, one in another.
int open_popups();
/// Closes those above the first `left`; the one below gets the keyboard.
void close_popups_above(int left);
/// Gives the keyboard to the next control of the open dialog (`by` 1) or the one before (-1), around the ends. `map`:
/// as drawn last.
void step_focus(UiMap& map, int by);
/// True if Enter is for the control that has the keyboard, not for the first button of the dialog: its frame is shown,
/// and it is not a row of a list.
bool takes_enter(const UiMap& map);
/// Presses that control, where ImGui does not do so.
void press_focused(const UiMap& map);

}  // namespace weftlight::ui
