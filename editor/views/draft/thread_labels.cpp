#include "views/draft/thread_labels.h"

#include <algorithm>

#include "ui/imgui_compat.h"
#include "ui/widgets.h"

namespace weftlight::views {
namespace {

System system_of(const GridPane& pane) { return pane.id == GridId::kWarpColors ? System::kWarp : System::kWeft; }

const Axis& threads_along(const GridPane& pane) { return pane.id == GridId::kWarpColors ? pane.x : pane.y; }

int thread_at(const GridPane& pane) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  return threads_along(pane).nearest(system_of(pane) == System::kWarp ? mouse.x : mouse.y);
}

/// The ImGui item drawn last lies over `pane`.
void take_gesture(PanelContext& c, const GridPane& pane) {
  const ImGuiIO& io = ImGui::GetIO();
  const int thread = thread_at(pane);
  if (thread < 0) return;
  const System system = system_of(pane);
  const Choose how = io.KeyShift ? Choose::kRange : io.KeyCtrl ? Choose::kAlso : Choose::kOnly;
  if (ImGui::IsItemActivated())
    c.wanted.change_view([=](DocumentView& v) { begin_choice(v.chosen, system, thread, how); });
  else if (ImGui::IsItemActive()) c.wanted.change_view([=](DocumentView& v) { drag_choice(v.chosen, thread); });
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    c.wanted.gesture([=](DocumentView& v, const Design& design) {
      v.chosen.threads = threads_alike(design.draft, system, {thread});
      v.chosen.dragging = false;
      return MaybeEdit();
    });
}

void head_input(PanelContext& c, const GridPane& heads, const char* name) {
  const ImVec2 a = heads.min(), b = heads.max();
  if (b.x - a.x < 1 || b.y - a.y < 1) return;
  ImGui::SetCursorScreenPos(a);
  hit_area(name, {b.x - a.x, b.y - a.y});
  take_gesture(c, heads);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    const bool warp = system_of(heads) == System::kWarp;
    c.frame.hover = {heads.id, warp ? Cell{thread_at(heads), 0} : Cell{0, thread_at(heads)}};
  }
  // Once something is chosen, it would only cover the bars.
  if (c.view.chosen.threads.empty())
    tooltip(c,
            "Click or drag along the numbers to choose threads for the Threads panel. Shift: up to here. "
            "Ctrl: this "
            "one too. Double-click: all of the same colour and yarn. Esc: none");
  UiGrid grid = map_of(heads);
  grid.name = name;
  c.map.grids.push_back(std::move(grid));
}

/// Calls use(low, high) with the pixels of each row of neighbours that are chosen and in sight.
template <class Use>
void each_run(const ThreadChoice& choice, const Axis& axis, Use use) {
  const auto& all = choice.threads;
  const int stop = axis.end_visible();
  for (auto at = std::lower_bound(all.begin(), all.end(), axis.first_visible()); at != all.end() && *at < stop;) {
    auto last = at;
    while (std::next(last) != all.end() && *std::next(last) == *last + 1 && *std::next(last) < stop) ++last;
    use(std::min(axis.low(*at), axis.low(*last)), std::max(axis.high(*at), axis.high(*last)));
    at = std::next(last);
  }
}

/// A frame that shows on any colour: the accent, and paper within.
void draw_frame(ImDrawList* dl, const PanelContext& c, ImVec2 a, ImVec2 b) {
  const float thick = c.style.px(2), half = thick / 2;
  dl->AddRect({a.x - half, a.y - half}, {b.x + 1 + half, b.y + 1 + half}, c.style.color.accent, 0, 0, thick);
  dl->AddRect({a.x + half, a.y + half}, {b.x + 1 - half, b.y + 1 - half}, c.style.color.paper);
}

}  // namespace

bool chooses_on_bar(const PanelContext& c, GridId bar) {
  if (bar != GridId::kWarpColors && bar != GridId::kWeftColors) return false;
  const ImGuiIO& io = ImGui::GetIO();
  return c.view.chosen.dragging ||
         (c.view.stroke.grid == GridId::kNone && (c.view.select.tool == Tool::kSelect || io.KeyShift || io.KeyCtrl));
}

void choose_on_bar(PanelContext& c, const GridPane& bar) { take_gesture(c, bar); }

void choose_by_labels(PanelContext& c, const DraftLayout& l) {
  const ThreadChoice& choice = c.view.chosen;
  head_input(c, l.warp_labels, "warp_numbers");
  head_input(c, l.weft_labels, "weft_numbers");
  if (!ImGui::IsAnyMouseDown() && choice.dragging)
    c.wanted.change_view([](DocumentView& v) { v.chosen.dragging = false; });
  const bool busy = ImGui::GetIO().WantTextInput ||
                    ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  if (!busy && key_pressed(ImGuiKey_Escape, false))
    c.wanted.change_view([](DocumentView& v) { v.chosen.threads.clear(); });
}

void draw_chosen(ImDrawList* dl, const PanelContext& c, const DraftLayout& l) {
  const bool warp = c.view.chosen.system == System::kWarp;
  const GridPane& heads = warp ? l.warp_labels : l.weft_labels;
  const GridPane& bar = warp ? l.warp_bar : l.weft_bar;
  const GridPane& marks = warp ? l.threading : l.lift;
  const ImU32 soft = c.style.color.accent_soft, band = with_alpha(c.style.color.accent, 0.13f);
  const float r = c.style.px(3), thick = c.style.px(2);
  const ImVec2 a{std::min(heads.min().x, bar.min().x), std::min(heads.min().y, bar.min().y)};
  const ImVec2 b{std::max(heads.max().x, bar.max().x), std::max(heads.max().y, bar.max().y)};
  const ImDrawFlags outer = l.threading_below ? ImDrawFlags_RoundCornersBottom : ImDrawFlags_RoundCornersTop;
  dl->PushClipRect({a.x - thick, a.y - thick}, {b.x + thick + 1, b.y + thick + 1}, true);
  each_run(c.view.chosen, threads_along(bar), [&](float low, float high) {
    if (warp) {
      dl->AddRectFilled({low, heads.min().y}, {high + 1, heads.max().y}, soft, r, outer);
      draw_frame(dl, c, {low, bar.min().y}, {high, bar.max().y});
    } else {
      dl->AddRectFilled({heads.min().x, low}, {heads.max().x, high + 1}, soft, r, ImDrawFlags_RoundCornersRight);
      draw_frame(dl, c, {bar.min().x, low}, {bar.max().x, high});
    }
  });
  dl->PopClipRect();
  dl->PushClipRect(marks.min(), marks.max(), true);
  each_run(c.view.chosen, threads_along(bar), [&](float low, float high) {
    if (warp) dl->AddRectFilled({low, marks.min().y}, {high + 1, marks.max().y}, band);
    else dl->AddRectFilled({marks.min().x, low}, {marks.max().x, high + 1}, band);
  });
  dl->PopClipRect();
}

}  // namespace weftlight::views
