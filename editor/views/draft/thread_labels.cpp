#include "views/draft/thread_labels.h"

#include <algorithm>

#include "base/text.h"
#include "ui/widgets.h"
#include "views/draft/held_layout.h"

namespace weftlight::views {

using base::tr;
using design::Design;
using draft::System;
using session::Cell, session::Choose, session::DocumentView, session::MaybeEdit, session::ThreadChoice, session::Tool,
    session::begin_choice, session::drag_choice, session::threads_alike;
using ui::Axis, ui::UiGrid, ui::hit_area, ui::tooltip, ui::with_alpha;

namespace {

System system_of(const GridPane& pane) { return pane.id == GridId::kWarpColors ? System::kWarp : System::kWeft; }

const Axis& threads_along(const GridPane& pane) { return pane.id == GridId::kWarpColors ? pane.x : pane.y; }

int thread_at(const DraftContext& c, const GridPane& pane) {
  const ImVec2 hand = hand_at(c.style);
  return threads_along(pane).nearest(system_of(pane) == System::kWarp ? hand.x : hand.y);
}

/// The ImGui item drawn last lies over `pane`.
void handle_gesture(DraftContext& c, const GridPane& pane) {
  const ImGuiIO& io = ImGui::GetIO();
  const int thread = thread_at(c, pane);
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

/// True while a button that went down on the numbers is down.
bool label_input(DraftContext& c, const GridPane& labels, const char* name) {
  const ImVec2 a = labels.min(), b = labels.max();
  if (b.x - a.x < 1 || b.y - a.y < 1) return false;
  ImGui::SetCursorScreenPos(a);
  hit_area(name, {b.x - a.x, b.y - a.y});
  const bool active = ImGui::IsItemActive();
  handle_gesture(c, labels);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    const bool warp = system_of(labels) == System::kWarp;
    c.frame.hover = {labels.id, warp ? Cell{thread_at(c, labels), 0} : Cell{0, thread_at(c, labels)}};
  }
  // With a selection the tip would only cover the bars.
  if (c.chosen.threads.empty())
    tooltip(c, tr("Click or drag along the numbers to select threads for the Threads panel. Shift: extend. Ctrl: add. "
                  "Double-click: all with the same colour and yarn. Esc: none"));
  UiGrid grid = map_of(labels);
  grid.name = name;
  c.map.grids.push_back(std::move(grid));
  return active;
}

/// Calls use(low, high) with the pixels of each run of visible selected neighbours.
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

/// A frame that is visible on any colour: accent outside, paper inside.
void draw_frame(ImDrawList* dl, const DraftContext& c, ImVec2 a, ImVec2 b) {
  const float thick = c.style.px(2), half = thick / 2;
  dl->AddRect({a.x - half, a.y - half}, {b.x + 1 + half, b.y + 1 + half}, c.style.color.accent, 0, 0, thick);
  dl->AddRect({a.x + half, a.y + half}, {b.x + 1 - half, b.y + 1 - half}, c.style.color.paper);
}

}  // namespace

bool chooses_on_bar(const DraftContext& c, GridId bar) {
  if (bar != GridId::kWarpColors && bar != GridId::kWeftColors) return false;
  const ImGuiIO& io = ImGui::GetIO();
  return c.chosen.dragging ||
         (c.drawing.stroke.grid == GridId::kNone && (c.select.tool == Tool::kSelect || io.KeyShift || io.KeyCtrl));
}

void choose_on_bar(DraftContext& c, const GridPane& bar) { handle_gesture(c, bar); }

bool choose_by_labels(DraftContext& c, const DraftLayout& l) {
  const ThreadChoice& choice = c.chosen;
  bool pressed = label_input(c, l.warp_labels, "warp_numbers");
  pressed |= label_input(c, l.weft_labels, "weft_numbers");
  if (!ImGui::IsAnyMouseDown() && choice.dragging)
    c.wanted.change_view([](DocumentView& v) { v.chosen.dragging = false; });
  return pressed;
}

void draw_chosen(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  const bool warp = c.chosen.system == System::kWarp;
  const GridPane& labels = warp ? l.warp_labels : l.weft_labels;
  const GridPane& bar = warp ? l.warp_bar : l.weft_bar;
  const GridPane& marks = warp ? l.threading : l.lift;
  const ImU32 soft = c.style.color.accent_soft, band = with_alpha(c.style.color.accent, 0.13f);
  const float r = c.style.px(3), thick = c.style.px(2);
  const ImVec2 a{std::min(labels.min().x, bar.min().x), std::min(labels.min().y, bar.min().y)};
  const ImVec2 b{std::max(labels.max().x, bar.max().x), std::max(labels.max().y, bar.max().y)};
  const ImDrawFlags outer = l.threading_below ? ImDrawFlags_RoundCornersBottom : ImDrawFlags_RoundCornersTop;
  dl->PushClipRect({a.x - thick, a.y - thick}, {b.x + thick + 1, b.y + thick + 1}, true);
  each_run(c.chosen, threads_along(bar), [&](float low, float high) {
    if (warp) {
      dl->AddRectFilled({low, labels.min().y}, {high + 1, labels.max().y}, soft, r, outer);
      draw_frame(dl, c, {low, bar.min().y}, {high, bar.max().y});
    } else {
      dl->AddRectFilled({labels.min().x, low}, {labels.max().x, high + 1}, soft, r, ImDrawFlags_RoundCornersRight);
      draw_frame(dl, c, {bar.min().x, low}, {bar.max().x, high});
    }
  });
  dl->PopClipRect();
  dl->PushClipRect(marks.min(), marks.max(), true);
  each_run(c.chosen, threads_along(bar), [&](float low, float high) {
    if (warp) dl->AddRectFilled({low, marks.min().y}, {high + 1, marks.max().y}, band);
    else dl->AddRectFilled({marks.min().x, low}, {marks.max().x, high + 1}, band);
  });
  dl->PopClipRect();
}

}  // namespace weftlight::views
