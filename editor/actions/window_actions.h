#pragma once
// The window: its status line, its controls, and the windows inside it.

#include <functional>
#include <string>

#include "session/editing/grid.h"

namespace weftlight::actions {

using session::Hover;

struct WindowActions {
  /// Shows a message in the status line until it is read.
  std::function<void(std::string)> say;
  /// The same for what could not be done.
  std::function<void(std::string)> refuse;
  /// The cell under the pointer.
  std::function<Hover()> hover;
  /// Gives the keyboard to a control, by its name in the --ui-map.
  std::function<void(std::string)> focus;
  std::function<void()> open_menus, show_commands, show_handbook, show_remarks, toggle_keys, toggle_theme;
};

}  // namespace weftlight::actions
