// The View menu: zoom, drawdown styles, navigation, comparison, saved views.

#include <utility>

#include "actions/action_parts.h"
#include "render_data/named_views.h"

namespace weftlight::actions {
namespace {

void add_drawdown_styles(Actions& all) {
  constexpr std::pair<const char*, const char*> kStyles[] = {{"look.threads", mark("Drawdown as threads")},
                                                             {"look.color", mark("Drawdown in colour")},
                                                             {"look.structure", mark("Drawdown as structure")}};
  for (int i = 0; i < 3; ++i) {
    const auto style = static_cast<DrawdownStyle>(i);
    Action& a = add(all, "View", kStyles[i].first, tr(kStyles[i].second), "",
                    [style](ActionHost& e) { e.settings().drawdown_style = style; });
    a.checked = [style](const ActionHost& e) { return e.settings().drawdown_style == style; };
    a.item.group = i == 0;
  }
  Action& back = add(all, "View", "back", tr("Back of the cloth"), "Ctrl+B", [](ActionHost& e) {
    e.view().draft.face = e.view().draft.face == Face::kFront ? Face::kBack : Face::kFront;
  });
  back.checked = [](const ActionHost& e) { return e.view().draft.face == Face::kBack; };
  const auto option = [&all](const char* id, const char* label, const char* key, bool Settings::*on) {
    Action& a = add(all, "View", id, label, key, [on](ActionHost& e) { e.settings().*on = !(e.settings().*on); });
    a.checked = [on](const ActionHost& e) { return e.settings().*on; };
  };
  option("end1_right", tr("End 1 at the right"), "", &Settings::end1_right);
  option("pick1_bottom", tr("Pick 1 at the bottom"), "", &Settings::pick1_bottom);
  option("threading_below", tr("Threading below the drawdown"), "", &Settings::threading_below);
  option("minimap", tr("Overview map"), "O", &Settings::minimap);
  option("tiled", tr("Tiled drawdown"), "Shift+T", &Settings::tiled);
  option("show_repeat", tr("Outline the repeat"), "F2", &Settings::show_repeat);
}

void add_moves(Actions& all) {
  new_group(add(all, "View", "go_to", tr("Go to an end or pick\xE2\x80\xA6"), "Ctrl+G",
                [](ActionHost& e) { e.ask_thread(); }));
  const auto move = [&all](const char* id, const char* label, const char* key, void (*how)(DraftView&)) {
    add(all, "View", id, label, key, [how](ActionHost& e) { how(e.view().draft); }).item.submenu = mark("Go to");
  };
  // Beyond the edge; the layout limits it.
  constexpr float kFar = 1e9f;
  move("go_first", tr("First end and pick"), "Home", [](DraftView& w) { w.scroll_end = w.scroll_pick = 0; });
  move("go_last", tr("Last end and pick"), "End", [](DraftView& w) { w.scroll_end = w.scroll_pick = kFar; });
  // Down on the screen, whichever way the picks run.
  const auto page = [&all](const char* id, const char* label, const char* key, int down) {
    add(all, "View", id, label, key, [down](ActionHost& e) {
      page_picks(e.view().draft, e.settings().pick1_bottom ? -down : down);
    }).item.submenu = mark("Go to");
  };
  page("page_down", tr("Page down"), "PageDown", 1);
  page("page_up", tr("Page up"), "PageUp", -1);
  move("page_ends_on", tr("Page forward along the ends"), "Shift+PageDown", [](DraftView& w) { page_ends(w, 1); });
  move("page_ends_back", tr("Page back along the ends"), "Shift+PageUp", [](DraftView& w) { page_ends(w, -1); });
}

/// Goes to the next difference from the other draft, wrapping around.
void step_difference(ActionHost& e, int by) {
  const Report* r = e.last_report();
  if (r == nullptr || r->other != e.view().differences.other || r->places.empty())
    return e.say(tr("No crossing differs"));
  const int places = static_cast<int>(r->places.size());
  const int from = e.view().differences.place < 0 && by < 0 ? 0 : e.view().differences.place;
  const int next = ((from + by) % places + places) % places;
  show_place(e.view(), next, r->places[static_cast<size_t>(next)]);
}

void add_heavy_lines(Actions& all) {
  for (const int every : {0, 4, 5, 6, 8, 10}) {
    const std::string words = every == 0 ? tr("None") : fill(tr("Every {count} threads"), arg("count", every));
    Action& a = add(all, "View", ("heavy." + std::to_string(every)).c_str(), words.c_str(), "",
                    [every](ActionHost& e) { e.settings().heavy_lines = every; });
    a.item.submenu = mark("Heavy lines");
    a.checked = [every](const ActionHost& e) { return e.settings().heavy_lines == every; };
  }
}

void add_comparison(Actions& all) {
  const auto held = [](const ActionHost& e) { return e.view().differences.other != nullptr; };
  new_group(add(all, "View", "compare_draft", tr("Compare with a draft\xE2\x80\xA6"), "",
                [](ActionHost& e) { e.ask_other(); }));
  add(all, "View", "next_difference", tr("Next difference"), "F3", [](ActionHost& e) {
    step_difference(e, 1);
  }).enabled = held;
  add(all, "View", "previous_difference", tr("Previous difference"), "Shift+F3", [](ActionHost& e) {
    step_difference(e, -1);
  }).enabled = held;
  add(all, "View", "compare_done", tr("Stop comparing"), "", [](ActionHost& e) {
    e.view().differences.other = nullptr;
  }).enabled = held;
}

void add_views(Actions& all, const std::vector<std::string>& kept) {
  const char* const menu = mark("Views of the cloth");
  new_group(add(all, "View", "reset_view", tr("Reset the cloth view"), "Ctrl+Shift+0",
                [](ActionHost& e) { e.reset_view(); }));
  add(all, "View", "keep_view", tr("Open the draft with this view"), "", [](ActionHost& e) { e.keep_view(); });
  const auto in_menu = [menu](Action& a) { a.item.submenu = menu; };
  for (const ShippedView& view : kShippedViews)
    in_menu(add(all, "View", (std::string("view.") + view.id).c_str(), tr(view.label), "",
                [name = std::string(view.id)](ActionHost& e) { e.go_to_view(name); }));
  for (size_t i = 0; i < kept.size(); ++i) {
    Action& a = add(all, "View", ("view.kept:" + kept[i]).c_str(), kept[i].c_str(), "",
                    [name = kept[i]](ActionHost& e) { e.go_to_view(name); });
    a.item.group = i == 0;
    in_menu(a);
  }
  Action& keep = add(all, "View", "view_keep_as", tr("Save view as\xE2\x80\xA6"), "Ctrl+Shift+K",
                     [](ActionHost& e) { e.keep_view_as(); });
  keep.item.group = true;
  in_menu(keep);
  Action& change = add(all, "View", "views_change", tr("Rename or delete views\xE2\x80\xA6"), "",
                       [](ActionHost& e) { e.change_views(); });
  change.enabled = [](const ActionHost& e) { return !e.document().now().views.empty(); };
  in_menu(change);
}

}  // namespace

void add_view_actions(Actions& all, const std::vector<std::string>& kept_views) {
  add(all, "View", "zoom_in", tr("Larger cells"), "Ctrl++",
      [](ActionHost& e) { e.view().draft.pitch = zoomed_pitch(e.view().draft.pitch, 1); });
  add(all, "View", "zoom_out", tr("Smaller cells"), "Ctrl+-",
      [](ActionHost& e) { e.view().draft.pitch = zoomed_pitch(e.view().draft.pitch, -1); });
  add(all, "View", "fit", tr("Fit the draft"), "Ctrl+0", [](ActionHost& e) { e.view().draft.pitch = 0; });
  add_moves(all);
  add_heavy_lines(all);
  add_drawdown_styles(all);
  add_views(all, kept_views);
  Action& floats = add(all, "View", "show_floats", tr("Mark long floats"), "F5",
                       [](ActionHost& e) { e.view().analysis.show_floats = !e.view().analysis.show_floats; });
  floats.checked = [](const ActionHost& e) { return e.view().analysis.show_floats; };
  add_comparison(all);
  Action& inspector = add(all, "View", "inspector", tr("Inspector"), "F4",
                          [](ActionHost& e) { e.settings().inspector = !e.settings().inspector; });
  inspector.item.group = true;
  inspector.checked = [](const ActionHost& e) { return e.settings().inspector; };
  const auto tab = [&all](const char* id, const char* label, const char* key, int by) {
    add(all, "View", id, label, key, [by](ActionHost& e) { e.show_tab(by); }).enabled = [](const ActionHost& e) {
      return e.tabs() > 1;
    };
  };
  tab("next_tab", tr("Next draft"), "Ctrl+Tab", 1);
  tab("previous_tab", tr("Previous draft"), "Ctrl+Shift+Tab", -1);
  add(all, "View", "show_remarks", tr("Messages about the file"), "", [](ActionHost& e) { e.show_remarks(); });
  add(all, "View", "theme", tr("Switch light or dark theme"), "", [](ActionHost& e) { e.toggle_theme(); });
}

}  // namespace weftlight::actions
