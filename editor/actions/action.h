#pragma once
// One row of the table of actions.

#include <functional>
#include <string>

#include "session/action_item.h"

namespace weftlight::actions {

using session::ActionItem;

struct Action {
  ActionItem item;  // `enabled` and `checked` are filled in by show()
  std::function<void()> run;
  std::function<bool()> enabled = nullptr;       // null: always
  std::function<bool()> checked = nullptr;       // null: never
  std::function<std::string()> label = nullptr;  // null: the label of the item
};

}  // namespace weftlight::actions
