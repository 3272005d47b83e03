// Files: new, open, save, export, the library of shipped drafts.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "actions/action_parts.h"
#include "draft/generators/table.h"
#include "files/files.h"

namespace weftlight::actions {
namespace {

/// "twill_2_2" -> "Twill 2 2".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

void add_file_actions(Actions& all, const std::vector<std::string>& recent) {
  add(all, "File", "new", "New draft\xE2\x80\xA6", "Ctrl+N", [](Desk& e) { e.new_draft(); });
  int number = 0;
  for (const WeaveKind& weave : weave_kinds())
    add(all, "", (std::string("new.") + weave.id).c_str(),
        (std::string("New draft: ") + weave.name + "\xE2\x80\xA6").c_str(), "",
        [at = number++](Desk& e) { e.new_draft_of(at); });
  add(all, "File", "open", "Open\xE2\x80\xA6", "Ctrl+O", [](Desk& e) { e.open(); });
  new_group(add(all, "File", "save", "Save", "Ctrl+S", [](Desk& e) { e.save(); }));
  add(all, "File", "save_as", "Save as\xE2\x80\xA6", "Ctrl+Shift+S", [](Desk& e) { e.save_as(); });
  add(all, "File", "save_all", "Save all", "Ctrl+Alt+S", [](Desk& e) { e.save_all(); }).enabled = [](const Desk& e) {
    return e.any_unsaved();
  };
  add(all, "File", "save_plain", "Save for other programs\xE2\x80\xA6", "", [](Desk& e) { e.save_for_others(); });
  new_group(add(all, "File", "export", "Export textures\xE2\x80\xA6", "Ctrl+E", [](Desk& e) { e.export_textures(); }));
  add(all, "File", "print", "Print\xE2\x80\xA6", "Ctrl+Shift+P", [](Desk& e) { e.ask_print(); });
  Action& left =
      add(all, "File", "recovery", "Bring back unsaved work\xE2\x80\xA6", "", [](Desk& e) { e.offer_recovery(); });
  left.enabled = [](const Desk& e) { return e.has_left_work(); };
  bool first = true;
  for (const std::string& path : recent) {
    Action& a = add(all, "File", ("recent:" + path).c_str(), std::filesystem::path(path).filename().c_str(), "",
                    [path](Desk& e) { e.open_path(path); });
    a.item.group = std::exchange(first, false);
  }
  new_group(add(all, "File", "close", "Close", "Ctrl+W", [](Desk& e) { e.close_tab(); }));
  add(all, "File", "quit", "Quit", "Ctrl+Q", [](Desk& e) { e.quit(); });
}

namespace {

/// The .wif files of a folder of presets, by name; `submenu`: the menu they stand in, with `id` before their names.
void add_presets(Actions& all, const char* folder, const std::string& id, const char* submenu) {
  std::vector<std::filesystem::path> files;
  std::error_code missing;  // no presets, no library
  for (const auto& entry : std::filesystem::directory_iterator(presets_dir() + folder, missing))
    if (entry.path().extension() == ".wif") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& path : files) {
    const std::string name = path.stem().string();
    add(all, "Library", (id + name).c_str(), spoken(name).c_str(), "", [file = path.string()](Desk& e) {
      e.open_copy(file);
    }).item.submenu = submenu;
  }
}

}  // namespace

void add_library_actions(Actions& all) {
  add_presets(all, "/cloths", "library.cloth.", "Cloths");
  add_presets(all, "/drafts", "library.", "");
}

}  // namespace weftlight::actions
