#include "views/draft/drag_scroll.h"

#include <algorithm>
#include <cmath>

#include "session/editing/mirror.h"
#include "session/editing/selection_state.h"
#include "views/draft/held_layout.h"

namespace weftlight::views {

using draft::System;
using session::DocumentView, session::DraftView, session::GridId, session::SelectDrag, session::grid_id_of,
    session::has_ends, session::has_picks;
using ui::clamp_scroll;

namespace {

// Pixels per second, and the increase per pixel of distance.
constexpr float kSlowest = 160, kFaster = 14, kFastest = 4000;
constexpr float kLongestFrameS = 0.05f;

/// The grid of the active drag.
GridId dragged_grid(const DraftContext& c) {
  if (c.drawing.stroke.grid != GridId::kNone) return c.drawing.stroke.grid;
  if (c.drawing.shape) return c.drawing.shape->grid;
  if (c.select.drag != SelectDrag::kNone) return grid_id_of(c.select.selected.grid);
  if (!c.chosen.dragging) return GridId::kNone;
  return c.chosen.system == System::kWarp ? GridId::kWarpColors : GridId::kWeftColors;
}

bool follow(DraftContext& c, float DraftView::*scroll, const Axis& axis, float pixel) {
  if (axis.count < 2) return false;  // across a colour bar
  const float to = dragged_scroll(axis, pixel, std::min(ImGui::GetIO().DeltaTime, kLongestFrameS));
  if (to == axis.scroll) return false;
  c.wanted.change_view([scroll, to](DocumentView& v) { v.draft.*scroll = to; });
  c.frame.again = true;
  return true;
}

}  // namespace

float dragged_scroll(const Axis& axis, float pixel, float seconds) {
  const float end = axis.start + axis.length;
  const float out = pixel < axis.start ? pixel - axis.start : pixel >= end ? pixel - end + 1 : 0;
  if (out == 0) return axis.scroll;
  const float direction = (out < 0) != axis.reversed ? -1.0f : 1.0f;
  const float speed = std::min(kSlowest + kFaster * std::abs(out), kFastest);
  return clamp_scroll(axis, axis.scroll + direction * speed * seconds / axis.pitch);
}

bool scroll_with_drag(DraftContext& c, const DraftLayout& l) {
  const GridId grid = ImGui::IsAnyMouseDown() ? dragged_grid(c) : GridId::kNone;
  if (grid == GridId::kNone) return false;
  const ImVec2 hand = hand_at(c.style);
  bool scrolled = false;
  for (const GridPane* pane : l.panes()) {
    if (pane->id != grid) continue;
    scrolled |= follow(c, has_ends(grid) ? &DraftView::scroll_end : &DraftView::scroll_treadle, pane->x, hand.x);
    scrolled |= follow(c, has_picks(grid) ? &DraftView::scroll_pick : &DraftView::scroll_shaft, pane->y, hand.y);
  }
  return scrolled;
}

}  // namespace weftlight::views
