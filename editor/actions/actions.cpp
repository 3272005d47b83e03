#include "actions/actions.h"

#include "actions/action_parts.h"

namespace weftlight::actions {

std::vector<Action> make_actions(const std::vector<std::string>& recent, const std::map<std::string, std::string>& keys,
                                 const std::vector<std::string>& views) {
  Actions all;
  add_file_actions(all, recent);
  add_edit_actions(all);
  add_draft_actions(all);
  add_view_actions(all, views);
  add_cloth_actions(all);
  add_library_actions(all);
  add_help_actions(all);
  for (Action& a : all) {
    a.item.shipped = a.item.shortcut;
    if (const auto own = keys.find(a.item.id); own != keys.end()) a.item.shortcut = own->second;
  }
  return all;
}

std::vector<ActionItem> show(const std::vector<Action>& actions, const ActionHost& desk) {
  std::vector<ActionItem> items;
  for (const Action& a : actions) {
    items.push_back(a.item);
    items.back().enabled = !a.enabled || a.enabled(desk);
    items.back().checked = a.checked && a.checked(desk);
    if (a.label) items.back().label = a.label(desk);
  }
  return items;
}

}  // namespace weftlight::actions
