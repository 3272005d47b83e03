// The File and Library menus: new, open, save, export, shipped drafts.

#include <algorithm>
#include <filesystem>
#include <utility>

#include "actions/action_parts.h"
#include "session/library/library.h"
#include "weaves/table.h"

namespace weftlight::actions {
namespace {

void add_recent(Actions& all, const std::vector<std::string>& recent) {
  const char* const menu = mark("Open recent");
  constexpr size_t kMax = 10;  // in the menu; the gallery shows all
  add(all, "File", "recent", tr("Browse with pictures\xE2\x80\xA6"), "Ctrl+Shift+O", [](ActionHost& e) {
    e.show_gallery(false);
  }).item.submenu = menu;
  for (size_t i = 0; i < std::min(recent.size(), kMax); ++i) {
    const std::string& path = recent[i];
    Action& a = add(all, "File", ("recent:" + path).c_str(), std::filesystem::path(path).filename().c_str(), "",
                    [path](ActionHost& e) { e.open_path(path); });
    a.item.submenu = menu;
    a.item.group = i == 0;
  }
}

Action& on_tab(Action& a) {
  a.item.on_tab = true;
  return a;
}

void copy_path(ActionHost& e) {
  e.set_clipboard(e.document().path());
  e.say(fill(tr("Copied {text}"), arg("text", e.document().path())));
}

/// Actions on the file of the active draft.
void add_file_of_draft(Actions& all) {
  const auto has_file = [](const ActionHost& e) { return !e.document().path().empty(); };
  new_group(on_tab(add(all, "File", "duplicate", tr("Duplicate"), "", [](ActionHost& e) { e.duplicate(); })));
  on_tab(add(all, "File", "reload", tr("Reload from disk"), "", [](ActionHost& e) { e.reload(); })).enabled = has_file;
  on_tab(add(all, "File", "copy_path", tr("Copy file path"), "", copy_path)).enabled = has_file;
  on_tab(add(all, "File", "show_in_folder", tr("Show in folder"), "", [](ActionHost& e) {
    e.show_in_folder();
  })).enabled = has_file;
}

void add_closing(Actions& all) {
  new_group(on_tab(add(all, "File", "close", tr("Close"), "Ctrl+W", [](ActionHost& e) { e.close_tab(); })));
  on_tab(add(all, "File", "close_others", tr("Close other tabs"), "", [](ActionHost& e) {
    e.close_other_tabs();
  })).enabled = [](const ActionHost& e) { return e.tabs() > 1; };
  on_tab(add(all, "File", "close_right", tr("Close tabs to the right"), "", [](ActionHost& e) {
    e.close_tabs_to_right();
  })).enabled = [](const ActionHost& e) { return e.tab_place() + 1 < e.tabs(); };
}

}  // namespace

void add_file_actions(Actions& all, const std::vector<std::string>& recent) {
  add(all, "File", "new", tr("New draft\xE2\x80\xA6"), "Ctrl+N", [](ActionHost& e) { e.new_draft(); });
  int number = 0;
  for (const WeaveKind& weave : weave_kinds())
    add(all, "", (std::string("new.") + weave.id).c_str(),
        fill(tr("New draft: {weave}\xE2\x80\xA6"), arg("weave", tr(weave.name))).c_str(), "",
        [at = number++](ActionHost& e) { e.new_draft_of(at); });
  add(all, "File", "open", tr("Open\xE2\x80\xA6"), "Ctrl+O", [](ActionHost& e) { e.open(); });
  add_recent(all, recent);
  new_group(on_tab(add(all, "File", "save", tr("Save"), "Ctrl+S", [](ActionHost& e) { e.save(); })));
  on_tab(add(all, "File", "save_as", tr("Save as\xE2\x80\xA6"), "Ctrl+Shift+S", [](ActionHost& e) { e.save_as(); }));
  add(all, "File", "save_all", tr("Save all"), "Ctrl+Alt+S", [](ActionHost& e) { e.save_all(); }).enabled =
      [](const ActionHost& e) { return e.any_unsaved(); };
  add(all, "File", "save_plain", tr("Save for other programs\xE2\x80\xA6"), "",
      [](ActionHost& e) { e.save_for_others(); });
  new_group(add(all, "File", "export", tr("Export texture set\xE2\x80\xA6"), "Ctrl+E",
                [](ActionHost& e) { e.export_textures(); }));
  add(all, "File", "print", tr("Print\xE2\x80\xA6"), "Ctrl+Shift+P", [](ActionHost& e) { e.ask_print(); });
  Action& left = add(all, "File", "recovery", tr("Recover unsaved work\xE2\x80\xA6"), "",
                     [](ActionHost& e) { e.offer_recovery(); });
  left.enabled = [](const ActionHost& e) { return e.has_left_work(); };
  add_file_of_draft(all);
  add_closing(all);
  add(all, "File", "quit", tr("Quit"), "Ctrl+Q", [](ActionHost& e) { e.quit(); });
}

void add_library_actions(Actions& all) {
  add(all, "Library", "library", tr("Browse with pictures\xE2\x80\xA6"), "Ctrl+L",
      [](ActionHost& e) { e.show_gallery(true); });
  bool first = true;
  for (const LibraryFile& file : library_files()) {
    Action& a = add(all, "Library", ("library." + file.id).c_str(), file.name.c_str(), "",
                    [path = file.path](ActionHost& e) { e.open_copy(path); });
    a.item.submenu = file.cloth ? mark("Cloths") : "";
    a.item.group = std::exchange(first, false);
  }
}

}  // namespace weftlight::actions
