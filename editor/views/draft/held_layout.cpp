#include "views/draft/held_layout.h"

#include <utility>

#include "ui/imgui_compat.h"

namespace weftlight::views {

using ui::Axis, ui::clamp_scroll;

namespace {

constexpr float kMove = 2;  // pixels at 96 dpi; less than that is the tremor of a hand that clicks

/// The cells of `now` on the pixels of `held`.
void put(Axis& now, const Axis& held) {
  const int count = now.count;
  now = held;
  now.count = count;
}

void put(GridPane& now, const GridPane& held) {
  put(now.x, held.x);
  put(now.y, held.y);
}

constexpr GridPane DraftLayout::*kPanes[] = {
    &DraftLayout::warp_bar,    &DraftLayout::threading,   &DraftLayout::tieup,
    &DraftLayout::drawdown,    &DraftLayout::lift,        &DraftLayout::weft_bar,
    &DraftLayout::warp_labels, &DraftLayout::weft_labels, &DraftLayout::tiled_drawdown};

/// Scrolled to where the view is, as far as there are cells.
void scroll(DraftLayout& l, const DraftView& v) {
  const Axis ends = l.drawdown.x, picks = l.drawdown.y, shafts = l.threading.y, treadles = l.lift.x;
  const auto scrolled = [&l](const Axis& axis, float to, Axis GridPane::*along, auto... panes) {
    const float by = clamp_scroll(axis, to) - axis.scroll;
    for (GridPane DraftLayout::*const pane : {panes...}) ((l.*pane).*along).scroll += by;
  };
  using L = DraftLayout;
  scrolled(ends, v.scroll_end, &GridPane::x, &L::warp_bar, &L::threading, &L::drawdown, &L::warp_labels,
           &L::tiled_drawdown);
  scrolled(picks, v.scroll_pick, &GridPane::y, &L::weft_bar, &L::lift, &L::drawdown, &L::weft_labels,
           &L::tiled_drawdown);
  scrolled(shafts, v.scroll_shaft, &GridPane::y, &L::threading, &L::tieup);
  scrolled(treadles, v.scroll_treadle, &GridPane::x, &L::lift, &L::tieup);
}

}  // namespace

ImVec2 hand_at(const Style& style) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const ImGuiMouseButton button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right})
    if (ImGui::IsMouseDown(button))
      return ImGui::IsMouseDragging(button, style.px(kMove)) ? io.MousePos : io.MouseClickedPos[button];
  return io.MousePos;
}

Hand hand_of_frame() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || io.MouseWheelH != 0;
  return {ImGui::IsAnyMouseDown(), moves || ui::any_key_down(), io.DisplaySize};
}

DraftLayout HeldLayout::of(const DraftLayout& now, const DraftView& view, Hand hand) {
  const bool scrolls = std::exchange(scrolls_, false);
  const ImVec2 before = std::exchange(window_, hand.window);
  const bool resized = before.x != hand.window.x || before.y != hand.window.y;
  if ((!hand.down && (hand.moves || resized)) || view_ != &view) held_.reset();
  if (!held_) return now;
  DraftLayout l = *held_;
  for (GridPane DraftLayout::*const pane : kPanes) {
    l.*pane = now.*pane;
    put(l.*pane, (*held_).*pane);
  }
  if (scrolls) scroll(l, view);
  return l;
}

void HeldLayout::hold(const DraftLayout& layout, const DraftView& view) {
  held_ = layout;
  view_ = &view;
}

}  // namespace weftlight::views
