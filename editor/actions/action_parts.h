#pragma once
// Helpers for the files that fill the table of actions.

#include <functional>
#include <utility>
#include <vector>

#include "actions/action.h"
#include "actions/subjects.h"
#include "base/text.h"

namespace weftlight::actions {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using session::Settings;

using Actions = std::vector<Action>;

// Menus are known by their English names; the menu bar looks them up in the catalogue.
inline constexpr const char* kMenus[] = {mark("File"),  mark("Edit"),    mark("Draft"), mark("View"),
                                         mark("Cloth"), mark("Library"), mark("Help")};

inline Action& add(Actions& all, const char* menu, const char* id, const char* label, const char* shortcut,
                   std::function<void()> run) {
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

// The groups of the table, in the order of the menus. Each takes the subjects that it acts on.
void add_file_actions(Actions& all, const FileActions& files, const std::vector<std::string>& recent);
void add_export_actions(Actions& all, const ExportActions& exports);
/// Recovery, and actions on the file of the active draft.
void add_file_of_draft_actions(Actions& all, const FileActions& files, const ActiveDraft& draft,
                               const Clipboard& clipboard, const WindowActions& window);
void add_tab_actions(Actions& all, const TabActions& tabs);
void add_quit_action(Actions& all, const FileActions& files);
void add_history_actions(Actions& all, const ActiveDraft& draft, Settings& settings);
/// What the actions on the selection act on.
struct SelectionSubjects {
  const ActiveDraft& draft;
  const Clipboard& clipboard;
  const WindowActions& window;
  const Settings& settings;
};
/// Clipboard, moves, mirrors and rotations, repeats, threads, and tools; under Edit.
void add_selection_actions(Actions& all, const SelectionSubjects& subjects);
void add_command_palette_action(Actions& all, const WindowActions& window);
void add_draft_actions(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs);
/// Actions on the chosen ends or picks of the Threads panel; under Draft.
void add_thread_actions(Actions& all, const ActiveDraft& draft, const Clipboard& clipboard,
                        const WindowActions& window);
/// The lists of colours and yarns; under Draft.
void add_palette_actions(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs, const YarnActions& yarns);
/// Weaving at the loom, pick by pick; under Draft.
void add_loom_actions(Actions& all, const ActiveDraft& draft, const LoomActions& loom);
/// Zoom, navigation and drawdown styles; under View.
void add_draft_view_actions(Actions& all, const ActiveDraft& draft, Settings& settings, const DraftDialogs& dialogs,
                            const WindowActions& window);
/// `kept_views`: names of the saved views of the active document. Under View.
void add_cloth_view_actions(Actions& all, const ActiveDraft& draft, const ClothActions& cloth,
                            const std::vector<std::string>& kept_views);
/// Long floats and differences marked in the drawdown; under View.
void add_comparison_actions(Actions& all, const ActiveDraft& draft, const ComparisonActions& comparison,
                            const WindowActions& window);
/// Inspector, tabs, messages and theme; under View.
void add_window_actions(Actions& all, const WindowActions& window, const TabActions& tabs, Settings& settings);
void add_cloth_actions(Actions& all, const ActiveDraft& draft, const ClothActions& cloth, Settings& settings);
void add_library_actions(Actions& all, const FileActions& files);
void add_help_actions(Actions& all, const WindowActions& window, Settings& settings);

}  // namespace weftlight::actions
