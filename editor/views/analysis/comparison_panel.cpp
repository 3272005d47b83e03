#include "views/analysis/comparison_panel.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "session/editing/follow_document.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {

using analysis::Difference, analysis::region_text, analysis::thread_list;
using base::arg, base::fill, base::tr, base::tr_n;
using draft::System;
using session::DocumentView, session::scroll_to, session::show_place;
using ui::fitted, ui::muted_text, ui::row_label, ui::section, ui::text_button, ui::tooltip;

std::string difference_text(const Difference& d) {
  if (!d.threads.empty()) return thread_list(d.threads);
  const auto shown = [](const std::string& text) { return text.empty() ? std::string(tr("none")) : text; };
  return d.a.empty() && d.b.empty() ? "" : shown(d.a) + " \xE2\x86\x92 " + shown(d.b);
}

namespace {

using Panel = ViewContext<DifferenceView>;

constexpr int kShownPlaces = 5;

/// The threads that a difference lists; null if it lists no threads.
const System* system_of(const Difference& d) {
  static constexpr System kWarpThreads = System::kWarp, kWeftThreads = System::kWeft;
  if (d.what == "threading" || d.what.starts_with("warp ")) return &kWarpThreads;
  if (d.what == "treadling" || d.what == "lifts" || d.what.starts_with("weft ")) return &kWeftThreads;
  return nullptr;
}

/// Selects the threads and scrolls to the first.
void show_threads(PanelContext& c, System system, const std::vector<int>& threads) {
  c.wanted.change_view([=](DocumentView& v) {
    v.chosen = {system, threads, threads.front(), {}, false, false};
    scroll_to(v.draft, system, threads.front());
  });
}

void draw_difference(PanelContext& c, const Difference& d) {
  const float label = c.style.px(104);
  const System* system = system_of(d);
  const std::string text = difference_text(d);
  ImGui::PushID(d.what.c_str());
  const ImVec2 at = ImGui::GetCursorPos();
  const bool pressed = ImGui::Selectable("##row", false, system == nullptr ? ImGuiSelectableFlags_Disabled : 0);
  c.map.add_item("difference:" + d.what);
  if (text.size() > 24) tooltip(c, text.c_str());
  if (pressed && !d.threads.empty()) show_threads(c, *system, d.threads);
  ImGui::SetCursorPos(at);
  muted_text(c, tr(d.what.c_str()));
  ImGui::SameLine(label);
  ImGui::TextUnformatted(fitted(text, ImGui::GetContentRegionAvail().x).c_str());
  ImGui::PopID();
}

/// The list of differing areas of the drawdown. False if there are none.
bool draw_places(Panel& c, const Report& r) {
  row_label(c, tr("Crossings"),
            tr("Crossings that differ, in the part of the drawdown that both drafts have. They are tinted there"));
  if (r.comparison.crossings == 0) {
    ImGui::TextUnformatted(tr("all the same"));
    return false;
  }
  const int64_t differing = r.comparison.crossings;
  ImGui::TextUnformatted(fill(tr_n("{count} differs", "{count} differ", differing), arg("count", differing)).c_str());
  c.map.add_item("difference.crossings");
  const auto places = static_cast<int>(r.places.size());
  const float line = ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild("places", {0, static_cast<float>(std::min(places, kShownPlaces)) * line + c.style.px(4)});
  for (int i = 0; i < places; ++i) {
    ImGui::PushID(i);
    if (ImGui::Selectable(region_text(r.places[static_cast<size_t>(i)]).c_str(), i == c.view.place))
      c.wanted.change_view([i, at = r.places[static_cast<size_t>(i)]](DocumentView& v) { show_place(v, i, at); });
    ImGui::PopID();
    c.map.add_item("place:" + std::to_string(i + 1));
  }
  ImGui::EndChild();
  if (text_button(c, "difference.back", tr("Previous"), "Shift+F3")) c.wanted.add_action("previous_difference");
  ImGui::SameLine();
  if (text_button(c, "difference.next", tr("Next"), "F3")) c.wanted.add_action("next_difference");
  return true;
}

}  // namespace

void draw_comparison(const PanelContext& panel, const DifferenceView& differences, const Report* r) {
  Panel c{panel, differences};
  if (!c.view.other || !section(c, "section.comparison", tr("Comparison"))) return;
  row_label(c, tr("Compared to"), nullptr);
  ImGui::TextUnformatted(fitted(c.view.other->name, ImGui::GetContentRegionAvail().x).c_str());
  tooltip(c, c.view.other->name.c_str());
  if (r == nullptr || r->other != c.view.other) return muted_text(c, tr("Comparing\xE2\x80\xA6"));
  row_label(c, tr("Cloth"), nullptr);
  ImGui::TextUnformatted(r->comparison.differences.empty() ? tr("the drafts are the same")
                         : r->comparison.same_cloth        ? tr("the same")
                                                           : tr("different"));
  c.map.add_item(r->comparison.same_cloth ? "difference.same" : "difference.other");
  for (const Difference& d : r->comparison.differences) draw_difference(c, d);
  if (draw_places(c, *r)) ImGui::SameLine();
  if (text_button(c, "difference.done", tr("Done"), tr("Stop comparing"))) c.wanted.add_action("compare_done");
}

}  // namespace weftlight::views
