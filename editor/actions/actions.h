#pragma once
// The table of actions. It feeds the menus, the shortcuts, the toolbar and the command palette.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "actions/action_host.h"
#include "actions/names.h"
#include "session/action_item.h"

namespace weftlight::actions {

struct Action {
  ActionItem item;  // `enabled` and `checked` are filled in by show()
  std::function<void(ActionHost&)> run;
  std::function<bool(const ActionHost&)> enabled = nullptr;       // null: always
  std::function<bool(const ActionHost&)> checked = nullptr;       // null: never
  std::function<std::string(const ActionHost&)> label = nullptr;  // null: the label of the item
};

/// `recent`: files offered under File. `keys`: shortcuts set by the user, by action id (Settings::keys). `views`: names
/// of the saved views of the active document.
std::vector<Action> make_actions(const std::vector<std::string>& recent,
                                 const std::map<std::string, std::string>& keys = {},
                                 const std::vector<std::string>& views = {});
/// The items for the panels, with their present state and labels.
std::vector<ActionItem> show(const std::vector<Action>& actions, const ActionHost& host);

}  // namespace weftlight::actions
