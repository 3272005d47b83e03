#include "actions/actions.h"

#include <utility>

#include "actions/action_parts.h"

namespace weftlight::actions {

namespace {

/// The actions from `first` on are about the cloth: they show it if it is hidden.
void show_cloth_first(Actions& all, size_t first, Settings& settings) {
  for (size_t i = first; i < all.size(); ++i)
    all[i].run = [&settings, run = std::move(all[i].run)] {
      settings.cloth = true;
      run();
    };
}

}  // namespace

std::vector<Action> make_actions(const Subjects& s, const std::vector<std::string>& recent,
                                 const std::map<std::string, std::string>& keys,
                                 const std::vector<std::string>& views) {
  Actions all;
  add_file_actions(all, s.files, recent);
  add_export_actions(all, s.exports);
  add_file_of_draft_actions(all, s.files, s.draft, s.clipboard, s.window);
  add_tab_actions(all, s.tabs);
  add_quit_action(all, s.files);
  add_history_actions(all, s.draft, s.settings);
  add_selection_actions(all, {s.draft, s.clipboard, s.window, s.settings});
  add_command_palette_action(all, s.window);
  add_draft_actions(all, s.draft, s.dialogs);
  add_thread_actions(all, s.draft, s.clipboard, s.window);
  add_palette_actions(all, s.draft, s.dialogs, s.yarns);
  add_loom_actions(all, s.draft, s.loom);
  add_draft_view_actions(all, s.draft, s.settings, s.dialogs, s.window);
  const size_t first_view = all.size();
  add_cloth_view_actions(all, s.draft, s.cloth, views);
  show_cloth_first(all, first_view, s.settings);
  add_comparison_actions(all, s.draft, s.comparison, s.window);
  add_window_actions(all, s.window, s.tabs, s.settings);
  const size_t first_of_cloth = all.size();
  add_cloth_actions(all, s.draft, s.cloth, s.settings);
  show_cloth_first(all, first_of_cloth, s.settings);
  add_library_actions(all, s.files);
  add_help_actions(all, s.window, s.settings);
  for (Action& a : all) {
    a.item.shipped = a.item.shortcut;
    if (const auto own = keys.find(a.item.id); own != keys.end()) a.item.shortcut = own->second;
  }
  return all;
}

std::string nameless_id(const std::string& id) { return id.substr(0, id.find(':')); }

std::vector<ActionItem> show(const std::vector<Action>& actions) {
  std::vector<ActionItem> items;
  for (const Action& a : actions) {
    items.push_back(a.item);
    items.back().enabled = !a.enabled || a.enabled();
    items.back().checked = a.checked && a.checked();
    if (a.label) items.back().label = a.label();
  }
  return items;
}

}  // namespace weftlight::actions
