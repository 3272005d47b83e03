#include "views/analysis/report_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "session/selection_state.h"
#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

constexpr float kListHeight = 168;  // pixels at 96 dpi
constexpr size_t kShownHeddles = 64;

void fact(const PanelContext& c, const char* label, const std::string& text, const char* tip) {
  row_label(c, label, tip);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

std::string plural(int64_t n, const char* one, const char* many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

/// Scrolls to a float and selects its crossings.
void show_float(PanelContext& c, const analysis::Float& f) {
  const Draft& d = c.design.draft;
  const bool warp = f.system == System::kWarp;
  const int across = warp ? d.picks() : d.ends(), last = std::min(f.first + f.length, across) - 1;
  const Cell from = warp ? Cell{f.thread, f.first} : Cell{f.first, f.thread};
  const Cell to = warp ? Cell{f.thread, last} : Cell{last, f.thread};
  c.wanted.gesture(
      [=, system = f.system, thread = f.thread, middle = (f.first + last) / 2](DocumentView& v, const Design& now) {
        scroll_to(v, system, thread);
        scroll_to(v, warp ? System::kWeft : System::kWarp, middle);
        select_cells(v.select, clipped(selection_between(BitGrid::kDrawdown, from, to), now.draft));
        return MaybeEdit();
      });
}

void draw_float_list(PanelContext& c, const Report& r) {
  if (r.floats.listed.empty()) return;
  ImGui::BeginChild("floats", {0, c.style.px(kListHeight)});
  ImGuiListClipper rows;
  rows.Begin(static_cast<int>(r.floats.listed.size()));
  while (rows.Step()) {
    for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
      const analysis::Float& f = r.floats.listed[static_cast<size_t>(i)];
      const int threads = f.system == System::kWarp ? c.design.draft.picks() : c.design.draft.ends();
      ImGui::PushID(i);
      if (ImGui::Selectable(float_text(f, threads).c_str())) show_float(c, f);
      ImGui::PopID();
      c.map.add_item("float:" + std::to_string(i + 1));
    }
  }
  ImGui::EndChild();
}

void draw_floats(PanelContext& c, const Report* r) {
  float limit = static_cast<float>(c.view.float_limit);
  if (slider(c, {"floats.limit", "Allowed", 1, 30, "%.0f", "How many threads a float may cross"}, limit))
    c.wanted.change_view(
        [most = std::clamp(static_cast<int>(std::lround(limit)), 1, 30)](DocumentView& v) { v.float_limit = most; });
  row_label(c, "Show", "Tints what floats too far in the drawdown");
  bool show = c.view.show_floats;
  if (ImGui::Checkbox("##show", &show)) c.wanted.change_view([show](DocumentView& v) { v.show_floats = show; });
  c.map.add_item("floats.show");
  if (r == nullptr) return muted_text(c, "Counting\xE2\x80\xA6");
  const auto& l = r->longest;
  fact(c, "Longest", "warp " + std::to_string(l.warp_front) + " front, " + std::to_string(l.warp_back) + " back",
       "Threads crossed, the cloth taken to repeat");
  fact(c, "", "weft " + std::to_string(l.weft_front) + " front, " + std::to_string(l.weft_back) + " back", nullptr);
  fact(c, "Too long", r->floats.count == 0 ? std::string("none") : plural(r->floats.count, "float", "floats"),
       "Beyond what is allowed; the longest first. A click shows one");
  c.map.add_item("floats.count");
  draw_float_list(c, *r);
}

void draw_heddles(PanelContext& c, const analysis::LoomUse& use) {
  const int most = use.heddles.empty() ? 1 : std::max(1, *std::max_element(use.heddles.begin(), use.heddles.end()));
  const float height = ImGui::GetTextLineHeight();
  for (size_t shaft = 0; shaft < std::min(kShownHeddles, use.heddles.size()); ++shaft) {
    row_label(c, ("Shaft " + std::to_string(shaft + 1)).c_str(), nullptr);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float figure = c.style.px(52), room = std::max(1.0f, ImGui::GetContentRegionAvail().x - figure);
    const float length = room * static_cast<float>(use.heddles[shaft]) / static_cast<float>(most);
    const float top = at.y + ImGui::GetStyle().FramePadding.y;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top + 2}, {at.x + std::max(1.0f, length), top + height - 2},
                                              blend(c.style.color.panel, c.style.color.accent, 0.6f), c.style.px(3));
    ImGui::SetCursorScreenPos({at.x + room + c.style.px(8), at.y});
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(std::to_string(use.heddles[shaft]).c_str());
  }
  if (use.unthreaded_ends > 0) muted_text(c, plural(use.unthreaded_ends, "end is", "ends are") + " on no shaft");
  if (use.empty_picks > 0) muted_text(c, plural(use.empty_picks, "pick lifts", "picks lift") + " nothing");
}

}  // namespace

std::string float_text(const analysis::Float& f, int threads) {
  const bool warp = f.system == System::kWarp;
  const int last = (f.first + f.length - 1) % std::max(1, threads);
  return std::string(warp ? "End " : "Pick ") + std::to_string(f.thread + 1) +
         (f.face == Face::kFront ? " over " : " under ") + (warp ? "picks " : "ends ") + std::to_string(f.first + 1) +
         "\xE2\x80\x93" + std::to_string(last + 1) + ": " + std::to_string(f.length);
}

void draw_report(PanelContext& c, const Report* r) {
  if (section(c, "section.floats", "Floats")) draw_floats(c, r);
  if (r == nullptr) return;
  if (section(c, "section.weave", "Weave")) {
    fact(c, "Repeat", plural(r->repeat.ends, "end", "ends") + " \xC3\x97 " + plural(r->repeat.picks, "pick", "picks"),
         "After which everything begins again, colours too");
  }
  if (section(c, "section.heddles", "Heddles")) draw_heddles(c, r->loom);
}

}  // namespace weftlight::views
