#include "app/actions.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include "app/action_parts.h"
#include "app/editor.h"
#include "draft/edits.h"
#include "drape/mesh.h"
#include "files/files.h"
#include "panels/axis.h"
#include "panels/icons.h"

namespace weftlight::app {
namespace {

void add_file(Actions& all, const std::vector<std::string>& recent) {
  with_icon(add(all, "File", "new", "New draft\xE2\x80\xA6", "Ctrl+N", [](Editor& e) { e.new_draft(); }), icon::kNew);
  with_icon(add(all, "File", "open", "Open\xE2\x80\xA6", "Ctrl+O", [](Editor& e) { e.open(); }), icon::kOpen);
  with_icon(new_group(add(all, "File", "save", "Save", "Ctrl+S", [](Editor& e) { e.save(); })), icon::kSave);
  add(all, "File", "save_as", "Save as\xE2\x80\xA6", "Ctrl+Shift+S", [](Editor& e) { e.save_as(); });
  add(all, "File", "save_plain", "Save for other programs\xE2\x80\xA6", "", [](Editor& e) { e.save_for_others(); });
  new_group(
      add(all, "File", "export", "Export textures\xE2\x80\xA6", "Ctrl+E", [](Editor& e) { e.export_textures(); }));
  bool first = true;
  for (const std::string& path : recent) {
    Action& a = add(all, "File", ("recent:" + path).c_str(), std::filesystem::path(path).filename().c_str(), "",
                    [path](Editor& e) { e.open_path(path); });
    a.item.group = std::exchange(first, false);
  }
  new_group(add(all, "File", "quit", "Quit", "Ctrl+Q", [](Editor& e) { e.quit(); }));
}

/// "twill_2_2" -> "Twill 2 2".
std::string spoken(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

void add_library(Actions& all) {
  std::vector<std::filesystem::path> drafts;
  std::error_code missing;  // no presets, no library
  for (const auto& entry : std::filesystem::directory_iterator(presets_dir() + "/drafts", missing))
    if (entry.path().extension() == ".wif") drafts.push_back(entry.path());
  std::sort(drafts.begin(), drafts.end());
  for (const auto& path : drafts) {
    const std::string name = path.stem().string();
    add(all, "Library", ("library." + name).c_str(), spoken(name).c_str(), "",
        [file = path.string()](Editor& e) { e.open_copy(file); });
  }
}

void add_edit(Actions& all) {
  Action& undo = with_icon(add(all, "Edit", "undo", "Undo", "Ctrl+Z", [](Editor& e) { e.undo(); }), icon::kUndo);
  undo.enabled = [](const Editor& e) { return e.document().history().can_undo(); };
  Action& redo = with_icon(add(all, "Edit", "redo", "Redo", "Ctrl+Shift+Z", [](Editor& e) { e.redo(); }), icon::kRedo);
  redo.enabled = [](const Editor& e) { return e.document().history().can_redo(); };
  add_selection_actions(all);
  new_group(add(all, "Edit", "commands", "Commands\xE2\x80\xA6", "Ctrl+P", [](Editor& e) { e.show_commands(); }));
}

void add_draft(Actions& all) {
  add(all, "Draft", "notes", "Title and notes\xE2\x80\xA6", "", [](Editor& e) { e.ask_notes(); });
  add(all, "Draft", "size", "Ends, picks, shafts\xE2\x80\xA6", "", [](Editor& e) { e.ask_size(); });
  const auto shed = [&all](const char* id, const char* label, bool rising) {
    Action& a = add(all, "Draft", id, label, "", [rising](Editor& e) {
      e.commit(
          {rising ? "Rising shed" : "Sinking shed", [rising](Design d) { return with_rising(std::move(d), rising); }});
    });
    a.checked = [rising](const Editor& e) { return e.document().now().draft.rising == rising; };
    return &a;
  };
  shed("rising", "Rising shed", true)->item.group = true;
  shed("sinking", "Sinking shed", false);
  const auto drive = [&all](const char* id, const char* label, Drive to) {
    Action& a = add(all, "Draft", id, label, "", [to](Editor& e) {
      e.commit(to == Drive::kLiftplan ? Edit{"Drive by liftplan", to_liftplan}
                                      : Edit{"Drive by treadles", to_treadling});
    });
    a.checked = [to](const Editor& e) { return e.document().now().draft.drive == to; };
    a.enabled = [to](const Editor& e) { return e.document().now().draft.drive != to; };
    return &a;
  };
  drive("treadling", "Drive by tie-up and treadles", Drive::kTreadling)->item.group = true;
  drive("liftplan", "Drive by liftplan", Drive::kLiftplan);
  add_thread_actions(all);
}

void add_drawdown_looks(Actions& all) {
  constexpr std::pair<const char*, const char*> kLooks[] = {{"look.threads", "Drawdown as threads"},
                                                            {"look.color", "Drawdown in colour"},
                                                            {"look.structure", "Drawdown as structure"}};
  for (int i = 0; i < 3; ++i) {
    const auto look = static_cast<DrawdownStyle>(i);
    Action& a =
        add(all, "View", kLooks[i].first, kLooks[i].second, "", [look](Editor& e) { e.work().drawdown_style = look; });
    a.checked = [look](const Editor& e) { return e.work().drawdown_style == look; };
    a.item.group = i == 0;
  }
  Action& back = add(all, "View", "back", "Back of the cloth in the drawdown", "Ctrl+B",
                     [](Editor& e) { e.work().face = e.work().face == Face::kFront ? Face::kBack : Face::kFront; });
  back.checked = [](const Editor& e) { return e.work().face == Face::kBack; };
  Action& right = add(all, "View", "end1_right", "End 1 at the right", "",
                      [](Editor& e) { e.work().end1_right = !e.work().end1_right; });
  right.checked = [](const Editor& e) { return e.work().end1_right; };
}

void add_view(Actions& all) {
  add(all, "View", "zoom_in", "Larger cells", "Ctrl++",
      [](Editor& e) { e.work().pitch = zoomed_pitch(e.work().pitch, 1); });
  add(all, "View", "zoom_out", "Smaller cells", "Ctrl+-",
      [](Editor& e) { e.work().pitch = zoomed_pitch(e.work().pitch, -1); });
  add(all, "View", "fit", "Fit the draft", "Ctrl+0", [](Editor& e) { e.work().pitch = 0; });
  add_drawdown_looks(all);
  new_group(
      add(all, "View", "reset_view", "Reset the view of the cloth", "Ctrl+Shift+0", [](Editor& e) { e.reset_view(); }));
  add(all, "View", "keep_view", "Keep this view with the draft", "", [](Editor& e) { e.keep_view(); });
  Action& remarks = add(all, "View", "show_remarks", "Remarks on the file", "", [](Editor& e) { e.show_remarks(); });
  remarks.item.group = true;
  add(all, "View", "theme", "Light or dark", "", [](Editor& e) { e.toggle_theme(); });
}

void add_cloth(Actions& all) {
  for (const std::string& name : drape_names()) {
    Action& a = add(all, "Cloth", ("drape." + name).c_str(), ("Drape: " + name).c_str(), "", [name](Editor& e) {
      e.commit({"Choose drape", [name](Design d) {
                  d.scene.mesh = name;
                  return d;
                }});
    });
    a.checked = [name](const Editor& e) { return e.document().now().scene.mesh == name; };
  }
  Action& rungs = add(all, "Cloth", "rungs", "Methods in false colours", "F6",
                      [](Editor& e) { e.work().show_rungs = !e.work().show_rungs; });
  rungs.item.group = true;
  rungs.checked = [](const Editor& e) { return e.work().show_rungs; };
  const auto comparison = [&all](const char* id, const char* label, const char* key, Compare to) {
    Action& a = add(all, "Cloth", id, label, key,
                    [to](Editor& e) { e.work().compare = e.work().compare == to ? Compare::kOff : to; });
    a.checked = [to](const Editor& e) { return e.work().compare == to; };
  };
  comparison("compare", "Compare with the ray-traced threads", "F7", Compare::kSplit);
  comparison("difference", "Difference from the ray-traced threads", "F8", Compare::kDifference);
}

}  // namespace

std::vector<Action> make_actions(const std::vector<std::string>& recent) {
  Actions all;
  add_file(all, recent);
  add_edit(all);
  add_draft(all);
  add_view(all);
  add_cloth(all);
  add_library(all);
  add(all, "Help", "keys", "Keys and mouse", "F1", [](Editor& e) { e.toggle_keys(); });
  return all;
}

std::vector<ActionItem> show(const std::vector<Action>& actions, const Editor& editor) {
  std::vector<ActionItem> items;
  for (const Action& a : actions) {
    items.push_back(a.item);
    items.back().enabled = !a.enabled || a.enabled(editor);
    items.back().checked = a.checked && a.checked(editor);
  }
  return items;
}

}  // namespace weftlight::app
