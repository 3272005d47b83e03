#pragma once
// The one table of what can be done: it feeds the menus, the keys, the toolbar and the command palette.

#include <functional>
#include <string>
#include <vector>

#include "app/names.h"
#include "panels/action_list.h"

namespace weftlight::app {

class Editor;

struct Action {
  ActionItem item;  // `enabled` and `checked` are filled in by show()
  std::function<void(Editor&)> run;
  std::function<bool(const Editor&)> enabled = nullptr;  // null: always
  std::function<bool(const Editor&)> checked = nullptr;  // null: never
};

/// `recent`: files offered under File.
std::vector<Action> make_actions(const std::vector<std::string>& recent);
/// The table as the panels show it, with what holds now.
std::vector<ActionItem> show(const std::vector<Action>& actions, const Editor& editor);

}  // namespace weftlight::app
