#pragma once
// The table of actions. It feeds the menus, the shortcuts, the toolbar and the command palette.

#include <map>
#include <string>
#include <vector>

#include "actions/action.h"
#include "actions/subjects.h"

namespace weftlight::actions {

/// The rows keep references to `subjects`, which outlive the table.
/// `recent`: files offered under File. `keys`: shortcuts set by the user, by action id (Settings::keys). `views`: names
/// of the saved views of the active document.
std::vector<Action> make_actions(const Subjects& subjects, const std::vector<std::string>& recent,
                                 const std::map<std::string, std::string>& keys = {},
                                 const std::vector<std::string>& views = {});
/// An id without what the user named: "recent" of "recent:/home/anna/scarf.wif". No other part of an id is theirs.
std::string nameless_id(const std::string& id);
/// The items for the panels, with their present state and labels.
std::vector<ActionItem> show(const std::vector<Action>& actions);

}  // namespace weftlight::actions
