#include "views/draft/selection_draw.h"

#include <algorithm>

#include "session/editing/selection_state.h"
#include "ui/pixel_rect.h"

namespace weftlight::views {

using draft::BitGrid, draft::BitMatrix, draft::Face, draft::Selection, draft::turned_for;
using session::ActiveBlock, session::Cell, session::grid_id_of;
using ui::PixelRect, ui::Axis, ui::blend, ui::with_alpha;

namespace {

constexpr float kDash = 5;       // pixels
constexpr float kCellsFrom = 2;  // pixels per cell from which the cells of a block are drawn
constexpr float kOverhang = 8;   // pixels: rectangles are clipped this far outside the pane

const GridPane* pane_of(const DraftLayout& l, BitGrid grid) {
  for (const GridPane* pane : l.panes())
    if (pane->id == grid_id_of(grid)) return pane;
  return nullptr;
}

/// The pixels of a range of cells, which may extend beyond the grid.
PixelRect rect_of(const GridPane& p, int a0, int a1, int b0, int b1) {
  const auto low = [](const Axis& x, int first, int end) { return std::min(x.low(first), x.low(end - 1)); };
  const auto high = [](const Axis& x, int first, int end) { return std::max(x.high(first), x.high(end - 1)); };
  PixelRect box{{low(p.x, a0, a1), low(p.y, b0, b1)}, {high(p.x, a0, a1) + 1, high(p.y, b0, b1) + 1}};
  const ImVec2 min = p.min(), max = p.max();
  box.min = {std::max(box.min.x, min.x - kOverhang), std::max(box.min.y, min.y - kOverhang)};
  box.max = {std::min(box.max.x, max.x + kOverhang), std::min(box.max.y, max.y + kOverhang)};
  return box;
}

void draw_dashes(ImDrawList* dl, ImVec2 a, ImVec2 b, float dash, float thick) {
  const bool across = a.y == b.y;
  const float length = across ? b.x - a.x : b.y - a.y;
  for (float t = 0; t < length; t += 2 * dash) {
    const float end = std::min(t + dash, length);
    if (across) dl->AddRectFilled({a.x + t, a.y}, {a.x + end, a.y + thick}, IM_COL32_WHITE);
    else dl->AddRectFilled({a.x, a.y + t}, {a.x + thick, a.y + end}, IM_COL32_WHITE);
  }
}

/// White dashes on a dark line: one of the two is visible on any background.
void draw_outline(ImDrawList* dl, const DraftContext& c, PixelRect box) {
  if (box.min.x >= box.max.x || box.min.y >= box.max.y) return;
  const float t = c.style.px(2), dash = c.style.px(kDash);
  const ImU32 dark = IM_COL32(18, 24, 40, 255);
  const ImVec2 a{box.min.x - t / 2, box.min.y - t / 2}, b{box.max.x + t / 2, box.max.y + t / 2};
  dl->AddRectFilled(a, {b.x, a.y + t}, dark);
  dl->AddRectFilled({a.x, b.y - t}, b, dark);
  dl->AddRectFilled(a, {a.x + t, b.y}, dark);
  dl->AddRectFilled({b.x - t, a.y}, b, dark);
  draw_dashes(dl, a, {b.x, a.y}, dash, t);
  draw_dashes(dl, {a.x, b.y - t}, {b.x, b.y - t}, dash, t);
  draw_dashes(dl, a, {a.x, b.y}, dash, t);
  draw_dashes(dl, {b.x - t, a.y}, {b.x - t, b.y}, dash, t);
}

void push_clip(ImDrawList* dl, const DraftContext& c, const GridPane& p) {
  const float room = c.style.px(2);
  const ImVec2 a = p.min(), b = p.max();
  dl->PushClipRect({a.x - room, a.y - room}, {b.x + 1 + room, b.y + 1 + room}, true);
}

void draw_cells(ImDrawList* dl, const DraftContext& c, const GridPane& p, const ActiveBlock& held,
                const BitMatrix& cells) {
  const bool crossings = held.grid == BitGrid::kDrawdown;
  const bool inverted = crossings && c.view.face == Face::kBack;  // the back shows the other system
  const ImU32 mark = blend(c.style.color.accent, c.style.color.ink, 0.25f),
              empty = with_alpha(c.style.color.paper, 0.8f);
  const int a1 = std::min(held.at.a + cells.cols(), p.x.end_visible()),
            b1 = std::min(held.at.b + cells.rows(), p.y.end_visible());
  for (int b = std::max(held.at.b, p.y.first_visible()); b < b1; ++b)
    for (int a = std::max(held.at.a, p.x.first_visible()); a < a1; ++a) {
      const bool on = cells.get(b - held.at.b, a - held.at.a) != inverted;
      if (!on && held.add) continue;
      const float gap = p.x.pitch >= 5 ? 1.0f : 0.0f;
      dl->AddRectFilled({p.x.low(a) + gap, p.y.low(b) + gap}, {p.x.high(a), p.y.high(b)}, on ? mark : empty);
    }
}

}  // namespace

void draw_selection(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  const Selection& s = c.select.selected;
  const GridPane* pane = s.empty() ? nullptr : pane_of(l, s.grid);
  if (pane == nullptr) return;
  const PixelRect box = rect_of(*pane, s.a0, s.a1, s.b0, s.b1);
  push_clip(dl, c, *pane);
  dl->AddRectFilled(box.min, box.max, with_alpha(c.style.color.accent, 0.26f));
  draw_outline(dl, c, box);
  dl->PopClipRect();
}

void draw_active_block(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  if (!c.select.held) return;
  const ActiveBlock& held = *c.select.held;
  const GridPane* pane = pane_of(l, held.grid);
  if (pane == nullptr) return;
  const BitMatrix cells = turned_for(held.block, held.grid);
  const Cell at = held.at;
  push_clip(dl, c, *pane);
  const PixelRect box = rect_of(*pane, at.a, at.a + cells.cols(), at.b, at.b + cells.rows());
  if (std::min(pane->x.pitch, pane->y.pitch) >= kCellsFrom) draw_cells(dl, c, *pane, held, cells);
  else dl->AddRectFilled(box.min, box.max, with_alpha(c.style.color.accent, 0.5f));
  draw_outline(dl, c, box);
  const ImVec2 first{(pane->x.low(at.a) + pane->x.high(at.a)) / 2, (pane->y.low(at.b) + pane->y.high(at.b)) / 2};
  dl->AddCircleFilled(first, c.style.px(4), IM_COL32_WHITE);
  dl->AddCircleFilled(first, c.style.px(3), c.style.color.accent);
  dl->PopClipRect();
}

}  // namespace weftlight::views
