// The File and Library menus: new, open, save, export, shipped drafts.

#include <algorithm>
#include <filesystem>
#include <utility>

#include "actions/action_parts.h"
#include "platform/page.h"
#include "session/library/library.h"
#include "weaves/table.h"
#include "wif/wif.h"

namespace weftlight::actions {

using base::fill, base::mark, base::tr;
using session::LibraryFile, session::library_files;
using weaves::WeaveKind, weaves::weave_kinds;
using wif::write_new_wif;

namespace {

void add_recent(Actions& all, const FileActions& files, const std::vector<std::string>& recent) {
  const char* const menu = mark("Open recent");
  constexpr size_t kMax = 10;  // in the menu; the gallery shows all
  add(all, "File", "recent", tr("Browse with pictures\xE2\x80\xA6"), "Ctrl+Shift+O", [&files] {
    files.show_gallery(GalleryPage::kRecent);
  }).item.submenu = menu;
  for (size_t i = 0; i < std::min(recent.size(), kMax); ++i) {
    const std::string& path = recent[i];
    Action& a = add(all, "File", ("recent:" + path).c_str(), std::filesystem::path(path).filename().string().c_str(),
                    "", [&files, path] { files.open_path(path); });
    a.item.submenu = menu;
    a.item.group = i == 0;
  }
}

Action& on_tab(Action& a) {
  a.item.on_tab = true;
  return a;
}

}  // namespace

void add_file_actions(Actions& all, const FileActions& files, const std::vector<std::string>& recent) {
  add(all, "File", "new", tr("New draft\xE2\x80\xA6"), "Ctrl+N", [&files] { files.new_draft(0); });
  int number = 0;
  for (const WeaveKind& weave : weave_kinds())
    add(all, "", (std::string("new.") + weave.id).c_str(),
        fill(tr("New draft: {weave}\xE2\x80\xA6"), arg("weave", tr(weave.name))).c_str(), "",
        [&files, at = number++] { files.new_draft(at); });
  add(all, "File", "open", tr("Open\xE2\x80\xA6"), "Ctrl+O", files.open);
  add_recent(all, files, recent);
  add(all, "File", "folder", tr("Folder of drafts"), "", [&files] { files.show_gallery(GalleryPage::kFolder); });
  new_group(on_tab(add(all, "File", "save", tr("Save"), "Ctrl+S", files.save)));
  on_tab(add(all, "File", "save_as", tr("Save as\xE2\x80\xA6"), "Ctrl+Shift+S", files.save_as));
  add(all, "File", "save_all", tr("Save all"), "Ctrl+Alt+S", files.save_all).enabled = files.any_unsaved;
  add(all, "File", "save_plain", tr("Save for other programs\xE2\x80\xA6"), "", files.save_for_others);
}

void add_export_actions(Actions& all, const ExportActions& exports) {
  new_group(add(all, "File", "export", tr("Export texture set\xE2\x80\xA6"), "Ctrl+E", exports.export_textures));
  add(all, "File", "print", tr("Print\xE2\x80\xA6"), "Ctrl+Shift+P", exports.print);
}

void add_file_of_draft_actions(Actions& all, const FileActions& files, const ActiveDraft& draft,
                               const Clipboard& clipboard, const WindowActions& window) {
  add(all, "File", "recovery", tr("Recover unsaved work\xE2\x80\xA6"), "", files.offer_recovery).enabled =
      files.has_left_work;
  const auto has_file = [&draft] { return !draft.document().path().empty(); };
  const auto copy_path = [&draft, &clipboard, &window] {
    clipboard.set_text(draft.document().path());
    window.say(fill(tr("Copied {text}"), arg("text", draft.document().path())));
  };
  new_group(on_tab(add(all, "File", "duplicate", tr("Duplicate"), "", files.duplicate)));
  on_tab(add(all, "File", "reload", tr("Reload from disk"), "", files.reload)).enabled = has_file;
  if (platform::is_page()) {
    const auto copy_link = [&draft] { platform::copy_link(write_new_wif(draft.document().now())); };
    on_tab(add(all, "File", "copy_link", tr("Copy a link to this draft"), "", copy_link));
    return;
  }
  on_tab(add(all, "File", "copy_path", tr("Copy file path"), "", copy_path)).enabled = has_file;
  on_tab(add(all, "File", "show_in_folder", tr("Show in folder"), "", files.show_in_folder)).enabled = has_file;
}

void add_tab_actions(Actions& all, const TabActions& tabs) {
  new_group(on_tab(add(all, "File", "close", tr("Close"), "Ctrl+W", tabs.close)));
  on_tab(add(all, "File", "close_others", tr("Close other tabs"), "", tabs.close_others)).enabled = [&tabs] {
    return tabs.count() > 1;
  };
  on_tab(add(all, "File", "close_right", tr("Close tabs to the right"), "", tabs.close_to_right)).enabled = [&tabs] {
    return tabs.active() + 1 < tabs.count();
  };
}

void add_quit_action(Actions& all, const FileActions& files) {
  if (platform::is_page()) return;  // the browser closes it
  add(all, "File", "quit", tr("Quit"), "Ctrl+Q", files.quit);
}

void add_library_actions(Actions& all, const FileActions& files) {
  add(all, "Library", "library", tr("Browse with pictures\xE2\x80\xA6"), "Ctrl+L",
      [&files] { files.show_gallery(GalleryPage::kLibrary); });
  bool first = true;
  for (const LibraryFile& file : library_files()) {
    Action& a = add(all, "Library", ("library." + file.id).c_str(), file.name.c_str(), "",
                    [&files, path = file.path] { files.open_copy(path); });
    a.item.submenu = file.cloth ? mark("Cloths") : "";
    a.item.group = std::exchange(first, false);
  }
}

}  // namespace weftlight::actions
