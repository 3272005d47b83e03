// The View menu: zoom, navigation, drawdown styles, views of the cloth, comparison, and the window.

#include <algorithm>
#include <utility>

#include "actions/action_parts.h"
#include "scene/named_views.h"
#include "session/editing/follow_document.h"

namespace weftlight::actions {

using base::fill, base::mark, base::tr;
using draft::Draft, draft::Face;
using scene::ShippedView, scene::kShippedViews;
using session::DraftView, session::DrawdownStyle, session::Report, session::Settings, session::page_ends,
    session::page_picks, session::show_place, session::zoomed_pitch;

namespace {

void add_drawdown_styles(Actions& all, const ActiveDraft& draft, Settings& settings) {
  constexpr std::pair<const char*, const char*> kStyles[] = {{"look.threads", mark("Drawdown as threads")},
                                                             {"look.color", mark("Drawdown in colour")},
                                                             {"look.structure", mark("Drawdown as structure")}};
  for (int i = 0; i < 3; ++i) {
    const auto style = static_cast<DrawdownStyle>(i);
    Action& a = add(all, "View", kStyles[i].first, tr(kStyles[i].second), "",
                    [&settings, style] { settings.drawdown_style = style; });
    a.checked = [&settings, style] { return settings.drawdown_style == style; };
    a.item.group = i == 0;
  }
  Action& back = add(all, "View", "back", tr("Back of the cloth"), "Ctrl+B", [&draft] {
    draft.view().draft.face = draft.view().draft.face == Face::kFront ? Face::kBack : Face::kFront;
  });
  back.checked = [&draft] { return draft.view().draft.face == Face::kBack; };
  const auto option = [&all, &settings](const char* id, const char* label, const char* key, bool Settings::*on) {
    Action& a = add(all, "View", id, label, key, [&settings, on] { settings.*on = !(settings.*on); });
    a.checked = [&settings, on] { return settings.*on; };
  };
  option("end1_right", tr("End 1 at the right"), "", &Settings::end1_right);
  option("pick1_bottom", tr("Pick 1 at the bottom"), "", &Settings::pick1_bottom);
  option("threading_below", tr("Threading below the drawdown"), "", &Settings::threading_below);
  option("minimap", tr("Overview map"), "O", &Settings::minimap);
  option("tiled", tr("Tiled drawdown"), "Shift+T", &Settings::tiled);
  option("show_repeat", tr("Outline the repeat"), "F2", &Settings::show_repeat);
  option("rulers", tr("Rulers"), "", &Settings::rulers);
  option("imperial", tr("Inches, yards, ounces and pounds"), "", &Settings::imperial);
  constexpr int kPlanTab = 4;  // of the inspector
  add(all, "View", "plan", tr("Plan of the cloth"), "",
      [&settings] { settings.inspector = true, settings.inspector_tab = kPlanTab; });
}

void add_moves(Actions& all, const ActiveDraft& draft, Settings& settings, const DraftDialogs& dialogs) {
  new_group(add(all, "View", "go_to", tr("Go to an end or pick\xE2\x80\xA6"), "Ctrl+G", dialogs.go_to));
  const auto move = [&all, &draft](const char* id, const char* label, const char* key, void (*how)(DraftView&)) {
    add(all, "View", id, label, key, [&draft, how] { how(draft.view().draft); }).item.submenu = mark("Go to");
  };
  // Beyond the edge; the layout limits it.
  constexpr float kFar = 1e9f;
  move("go_first", tr("First end and pick"), "Home", [](DraftView& w) { w.scroll_end = w.scroll_pick = 0; });
  move("go_last", tr("Last end and pick"), "End", [](DraftView& w) { w.scroll_end = w.scroll_pick = kFar; });
  // Down on the screen, whichever way the picks run.
  const auto page = [&all, &draft, &settings](const char* id, const char* label, const char* key, int down) {
    add(all, "View", id, label, key, [&draft, &settings, down] {
      page_picks(draft.view().draft, settings.pick1_bottom ? -down : down);
    }).item.submenu = mark("Go to");
  };
  page("page_down", tr("Page down"), "PageDown", 1);
  page("page_up", tr("Page up"), "PageUp", -1);
  move("page_ends_on", tr("Page forward along the ends"), "Shift+PageDown", [](DraftView& w) { page_ends(w, 1); });
  move("page_ends_back", tr("Page back along the ends"), "Shift+PageUp", [](DraftView& w) { page_ends(w, -1); });
}

/// Goes to the next difference from the other draft, wrapping around.
void step_difference(const ActiveDraft& draft, const ComparisonActions& comparison, const WindowActions& window,
                     int by) {
  const Report* r = comparison.report();
  if (r == nullptr || r->other != draft.view().differences.other || r->places.empty())
    return window.refuse(tr("No crossing differs"));
  const int places = static_cast<int>(r->places.size());
  const int from = draft.view().differences.place < 0 && by < 0 ? 0 : draft.view().differences.place;
  const int next = ((from + by) % places + places) % places;
  show_place(draft.view(), next, r->places[static_cast<size_t>(next)]);
}

void add_heavy_lines(Actions& all, Settings& settings) {
  for (const int every : {0, 4, 5, 6, 8, 10}) {
    const std::string words = every == 0 ? tr("None") : fill(tr("Every {count} threads"), arg("count", every));
    Action& a = add(all, "View", ("heavy." + std::to_string(every)).c_str(), words.c_str(), "",
                    [&settings, every] { settings.heavy_lines = every; });
    a.item.submenu = mark("Heavy lines");
    a.checked = [&settings, every] { return settings.heavy_lines == every; };
  }
}

/// In percent, beside the size that the screen asks for.
void add_interface_sizes(Actions& all, Settings& settings) {
  for (const int percent : session::kInterfaceSizes) {
    Action& a = add(all, "View", ("interface." + std::to_string(percent)).c_str(),
                    fill(tr("Interface size: {percent}%"), arg("percent", percent)).c_str(), "",
                    [&settings, percent] { settings.interface_percent = percent; });
    a.item.submenu = mark("Interface size");
    a.checked = [&settings, percent] { return settings.interface_percent == percent; };
  }
}

}  // namespace

void add_draft_view_actions(Actions& all, const ActiveDraft& draft, Settings& settings, const DraftDialogs& dialogs,
                            const WindowActions& window) {
  add(all, "View", "zoom_in", tr("Larger cells"), "Ctrl++",
      [&draft] { draft.view().draft.pitch = zoomed_pitch(draft.view().draft.pitch, 1); });
  add(all, "View", "zoom_out", tr("Smaller cells"), "Ctrl+-", [&draft, &window] {
    DraftView& v = draft.view().draft;
    const Draft& d = draft.document().now().draft;
    const float smallest = smallest_pitch(v, d.ends(), d.picks());
    if (v.pitch <= smallest) return window.refuse(tr("Smaller cells could not be read."));
    v.pitch = std::max(smallest, zoomed_pitch(v.pitch, -1));
  });
  add(all, "View", "fit", tr("Fit the draft"), "Ctrl+0", [&draft] { draft.view().draft.pitch = 0; });
  add_moves(all, draft, settings, dialogs);
  add_heavy_lines(all, settings);
  add_drawdown_styles(all, draft, settings);
}

void add_cloth_view_actions(Actions& all, const ActiveDraft& draft, const ClothActions& cloth,
                            const std::vector<std::string>& kept) {
  const char* const menu = mark("Views of the cloth");
  new_group(add(all, "View", "reset_view", tr("Reset the cloth view"), "Ctrl+Shift+0", cloth.reset_view));
  add(all, "View", "keep_view", tr("Open the draft with this view"), "", cloth.save_view);
  const auto in_menu = [menu](Action& a) { a.item.submenu = menu; };
  for (const ShippedView& view : kShippedViews)
    in_menu(add(all, "View", (std::string("view.") + view.id).c_str(), tr(view.label), "",
                [&cloth, name = std::string(view.id)] { cloth.go_to_view(name); }));
  for (size_t i = 0; i < kept.size(); ++i) {
    Action& a = add(all, "View", ("view.kept:" + kept[i]).c_str(), kept[i].c_str(), "",
                    [&cloth, name = kept[i]] { cloth.go_to_view(name); });
    a.item.group = i == 0;
    in_menu(a);
  }
  Action& keep = add(all, "View", "view_keep_as", tr("Save view as\xE2\x80\xA6"), "Ctrl+Shift+K", cloth.save_view_as);
  keep.item.group = true;
  in_menu(keep);
  Action& change = add(all, "View", "views_change", tr("Rename or delete views\xE2\x80\xA6"), "", cloth.change_views);
  change.enabled = [&draft] { return !draft.document().now().views.empty(); };
  in_menu(change);
}

void add_comparison_actions(Actions& all, const ActiveDraft& draft, const ComparisonActions& comparison,
                            const WindowActions& window) {
  Action& floats = add(all, "View", "show_floats", tr("Mark long floats"), "F5",
                       [&draft] { draft.view().analysis.show_floats = !draft.view().analysis.show_floats; });
  floats.checked = [&draft] { return draft.view().analysis.show_floats; };
  const auto held = [&draft] { return draft.view().differences.other != nullptr; };
  new_group(add(all, "View", "compare_draft", tr("Compare with a draft\xE2\x80\xA6"), "", comparison.choose_draft));
  add(all, "View", "next_difference", tr("Next difference"), "F3", [&draft, &comparison, &window] {
    step_difference(draft, comparison, window, 1);
  }).enabled = held;
  add(all, "View", "previous_difference", tr("Previous difference"), "Shift+F3", [&draft, &comparison, &window] {
    step_difference(draft, comparison, window, -1);
  }).enabled = held;
  add(all, "View", "compare_done", tr("Stop comparing"), "", [&draft] {
    draft.view().differences.other = nullptr;
  }).enabled = held;
}

void add_window_actions(Actions& all, const WindowActions& window, const TabActions& tabs, Settings& settings) {
  Action& cloth = add(all, "View", "cloth_pane", tr("Cloth beside the draft"), "Shift+F4",
                      [&settings] { settings.cloth = !settings.cloth; });
  cloth.item.group = true;
  cloth.checked = [&settings] { return settings.cloth; };
  Action& inspector =
      add(all, "View", "inspector", tr("Inspector"), "F4", [&settings] { settings.inspector = !settings.inspector; });
  inspector.checked = [&settings] { return settings.inspector; };
  const auto tab = [&all, &tabs](const char* id, const char* label, const char* key, int by) {
    add(all, "View", id, label, key, [&tabs, by] { tabs.step(by); }).enabled = [&tabs] { return tabs.count() > 1; };
  };
  tab("next_tab", tr("Next draft"), "Ctrl+Tab", 1);
  tab("previous_tab", tr("Previous draft"), "Ctrl+Shift+Tab", -1);
  add(all, "View", "show_remarks", tr("File messages"), "", window.show_remarks);
  add(all, "View", "theme", tr("Switch light or dark theme"), "", window.toggle_theme);
  add_interface_sizes(all, settings);
}

}  // namespace weftlight::actions
