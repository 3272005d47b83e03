#pragma once
// Helpers for the files that fill the table of actions.

#include <functional>
#include <utility>
#include <vector>

#include "actions/actions.h"
#include "actions/names.h"
#include "base/text.h"

namespace weftlight::actions {

using base::arg;
using base::fill;
using base::mark;
using base::tr;

using Actions = std::vector<Action>;

// Menus are known by their English names; the menu bar looks them up in the catalogue.
inline constexpr const char* kMenus[] = {mark("File"),  mark("Edit"),    mark("Draft"), mark("View"),
                                         mark("Cloth"), mark("Library"), mark("Help")};

inline Action& add(Actions& all, const char* menu, const char* id, const char* label, const char* shortcut,
                   std::function<void(ActionHost&)> run) {
  Action& a = all.emplace_back();
  a.item.id = id;
  a.item.menu = menu;
  a.item.label = label;
  a.item.shortcut = shortcut;
  a.run = std::move(run);
  return a;
}

inline Action& new_group(Action& a) {
  a.item.group = true;
  return a;
}

// One function per file, in the order of the menus.
void add_file_actions(Actions& all, const std::vector<std::string>& recent);
void add_edit_actions(Actions& all);
/// Clipboard, moves, mirrors and rotations, repeats, threads, and tools; under Edit.
void add_selection_actions(Actions& all);
void add_draft_actions(Actions& all);
/// Actions on the chosen ends or picks of the Threads panel; under Draft.
void add_thread_actions(Actions& all);
/// Weaving at the loom, pick by pick; under Draft.
void add_loom_actions(Actions& all);
/// `kept_views`: names of the saved views of the active document.
void add_view_actions(Actions& all, const std::vector<std::string>& kept_views);
void add_cloth_actions(Actions& all);
void add_library_actions(Actions& all);
void add_help_actions(Actions& all);

}  // namespace weftlight::actions
