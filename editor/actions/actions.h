#pragma once
// The one table of what can be done: it feeds the menus, the keys, the toolbar and the command palette.

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
  std::function<std::string(const ActionHost&)> label = nullptr;  // null: as it stands in the item
};

/// `recent`: files offered under File. `keys`: shortcuts that the weaver gave, by action (Settings::keys). `views`:
/// names of those that the shown document keeps.
std::vector<Action> make_actions(const std::vector<std::string>& recent,
                                 const std::map<std::string, std::string>& keys = {},
                                 const std::vector<std::string>& views = {});
/// The table as the panels show it, with what holds now.
std::vector<ActionItem> show(const std::vector<Action>& actions, const ActionHost& desk);

}  // namespace weftlight::actions
