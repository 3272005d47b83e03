#include "views/draft/drawing_tools.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "session/editing/mirror.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"
#include "session/editing/shapes.h"
#include "ui/imgui_compat.h"
#include "ui/pixel_rect.h"
#include "views/draft/held_layout.h"

namespace weftlight::views {

using base::tr;
using design::Design;
using draft::Face;
using session::ActiveShape, session::BarPaint, session::Cell, session::CellMask, session::DocumentView,
    session::DrawingState, session::GridId, session::Mirror, session::TypeCursor, session::cells_of_shape,
    session::constrained, session::fill_bar_edit, session::fill_region, session::finish_shape, session::has_ends,
    session::has_picks, session::images_of, session::is_on, session::is_shape, session::leaves_others,
    session::mirror_of, session::region_about;
using ui::PixelRect, ui::Axis, ui::Colors, ui::Style, ui::blend, ui::font_size, ui::reading_color, ui::with_alpha;

namespace {

// Pixels per cell from which a preview is drawn cell by cell; a filled rectangle has many cells.
constexpr float kCellsFrom = 2, kFilledFrom = 4;

bool is_bar(GridId id) { return id == GridId::kWarpColors || id == GridId::kWeftColors; }

void begin_shape(DraftContext& c, GridId grid, Cell at) {
  if (!at.valid()) return;
  const bool on = !ImGui::IsMouseDown(ImGuiMouseButton_Right) && !is_on(c.design.draft, c.cells, grid, at);
  c.wanted.change_view([s = ActiveShape{c.select.tool, grid, at, at, on}](DocumentView& v) { v.drawing.shape = s; });
}

void continue_shape(DraftContext& c, const GridPane& pane) {
  const ActiveShape& s = *c.drawing.shape;
  Cell to = pane.nearest(hand_at(c.style));
  if (!to.valid()) return;
  if (ImGui::GetIO().KeyShift) to = constrained(s.tool, s.from, to, pane.x.count, pane.y.count);
  if (to == s.to) return;
  c.wanted.change_view([to](DocumentView& v) {
    if (v.drawing.shape) v.drawing.shape->to = to;
  });
}

void flood_fill(DraftContext& c, GridId grid, Cell at) {
  if (!at.valid()) return;
  const DrawingState& v = c.drawing;
  if (is_bar(grid))
    return c.wanted.add(
        fill_bar_edit(c.design.draft, grid, at, v.bar_paint, v.bar_paint == BarPaint::kColor ? v.color : v.yarn));
  const bool on = is_on(c.design.draft, c.cells, grid, at);
  const bool erase = ImGui::IsMouseDown(ImGuiMouseButton_Right);
  if (erase && !on) return;
  c.wanted.gesture([grid, on, region = region_about(c.design.draft, c.cells, grid, at)](
                       DocumentView& view, const Design& d) { return fill_region(view, d, grid, region, !on); });
}

const GridPane* pane_of(const DraftLayout& l, GridId grid) {
  for (const GridPane* pane : l.panes())
    if (pane->id == grid) return pane;
  return nullptr;
}

/// The pixels from one cell to another, inclusive.
PixelRect rect_between(const GridPane& p, Cell one, Cell other) {
  const auto low = [](const Axis& x, int i, int j) { return std::min(x.low(i), x.low(j)); };
  const auto high = [](const Axis& x, int i, int j) { return std::max(x.high(i), x.high(j)); };
  return {{low(p.x, one.a, other.a), low(p.y, one.b, other.b)}, {high(p.x, one.a, other.a), high(p.y, one.b, other.b)}};
}

/// Colours of the preview of a shape.
struct Preview {
  ImU32 cell, edge, cleared;  // cells and their border; what a line clears on its threads
};

Preview preview_of(const DraftContext& c, const ActiveShape& s) {
  const Colors& k = c.style.color;
  const bool inverted = s.grid == GridId::kDrawdown && c.view.face == Face::kBack;  // the back shows the other system
  const bool filled = s.on != inverted;
  return {filled ? blend(k.accent, k.ink, 0.25f) : k.paper, filled ? k.paper : k.accent, with_alpha(k.paper, 0.7f)};
}

void draw_cell(ImDrawList* dl, const GridPane& p, const Preview& g, Cell at) {
  const float gap = std::min(p.x.pitch, p.y.pitch) >= 5 ? 1.0f : 0.0f;
  const ImVec2 a{p.x.low(at.a) + gap, p.y.low(at.b) + gap}, b{p.x.high(at.a), p.y.high(at.b)};
  dl->AddRectFilled(a, b, g.cell);
  // The outline is visible on threads of any colour.
  if (gap > 0) dl->AddRect(a, b, with_alpha(g.edge, 0.8f));
}

void draw_cells(ImDrawList* dl, const GridPane& p, const CellMask& mask, const Preview& g) {
  const int a0 = std::max(mask.at.a, p.x.first_visible()), b0 = std::max(mask.at.b, p.y.first_visible());
  const int a1 = std::min(mask.at.a + mask.cells.cols(), p.x.end_visible()),
            b1 = std::min(mask.at.b + mask.cells.rows(), p.y.end_visible());
  for (int b = b0; b < b1; ++b)
    for (int a = a0; a < a1; ++a)
      if (mask.cells.get(b - mask.at.b, a - mask.at.a)) draw_cell(dl, p, g, {a, b});
}

/// For small cells: the outline of the shape.
void draw_far(ImDrawList* dl, const GridPane& p, const ActiveShape& s, Cell from, Cell to, ImU32 color) {
  const PixelRect box = rect_between(p, from, to);
  const ImVec2 b{std::max(box.max.x, box.min.x + 1), std::max(box.max.y, box.min.y + 1)};
  if (s.tool == Tool::kFilledRectangle) return dl->AddRectFilled(box.min, b, with_alpha(color, 0.8f));
  const float thick = std::max(1.5f, p.x.pitch);
  if (s.tool == Tool::kRectangle) return dl->AddRect(box.min, b, color, 0, 0, thick);
  const auto middle = [](const Axis& x, int i) { return (x.low(i) + x.high(i)) / 2; };
  dl->AddLine({middle(p.x, from.a), middle(p.y, from.b)}, {middle(p.x, to.a), middle(p.y, to.b)}, color, thick);
}

/// Fades the other cells of the threads that a line sets, because it clears them.
void fade_threads(ImDrawList* dl, const GridPane& p, Cell from, Cell to, ImU32 color) {
  const PixelRect box = rect_between(p, from, to);
  const ImVec2 a = p.min(), b = p.max();
  if (p.id == GridId::kThreading) dl->AddRectFilled({box.min.x, a.y}, {box.max.x, b.y}, color);
  else dl->AddRectFilled({a.x, box.min.y}, {b.x, box.max.y}, color);
}

/// Pixel of a mirror axis.
float axis_pixel(const Axis& axis, int sum) {
  const auto middle = [&](int i) { return (axis.low(i) + axis.high(i)) / 2; };
  return std::round((middle(sum / 2) + middle(sum - sum / 2)) / 2) - 1;
}

/// Dashes on a line in the paper colour are visible on threads of any colour.
void draw_axis(ImDrawList* dl, const DraftContext& c, ImVec2 a, ImVec2 b) {
  const bool upright = a.x == b.x;
  const float dash = c.style.px(6), gap = c.style.px(4), length = upright ? b.y - a.y : b.x - a.x;
  const auto stroke = [&](float from, float to, float halo, ImU32 color) {
    if (upright) dl->AddRectFilled({a.x - halo, a.y + from}, {a.x + 2 + halo, a.y + to}, color);
    else dl->AddRectFilled({a.x + from, a.y - halo}, {a.x + to, a.y + 2 + halo}, color);
  };
  stroke(0, length, 1, with_alpha(c.style.color.paper, 0.8f));
  const int dashes = static_cast<int>(std::ceil(length / (dash + gap)));
  for (int i = 0; i < dashes; ++i) {
    const float from = static_cast<float>(i) * (dash + gap);
    stroke(from, std::min(from + dash, length), 0, c.style.color.accent);
  }
}

void draw_axes(ImDrawList* dl, const DraftContext& c, const GridPane& p, const Mirror& m) {
  const ImVec2 a = p.min(), b = p.max();
  if (m.ends && has_ends(p.id)) {
    const float x = axis_pixel(p.x, *m.ends);
    if (x >= a.x && x <= b.x) draw_axis(dl, c, {x, a.y}, {x, b.y});
  }
  if (m.picks && has_picks(p.id)) {
    const float y = axis_pixel(p.y, *m.picks);
    if (y >= a.y && y <= b.y) draw_axis(dl, c, {a.x, y}, {b.x, y});
  }
}

/// True while the active tool is mirrored.
bool pen_is_mirrored(const DraftContext& c) {
  const Tool tool = c.select.tool;
  return (c.drawing.mirror_ends || c.drawing.mirror_picks) && (tool == Tool::kPaint || is_shape(tool));
}

}  // namespace

bool draws_shapes(const DraftContext& c, const GridPane& pane) {
  const Tool tool = c.select.tool;
  return tool == Tool::kFill || (is_shape(tool) && !is_bar(pane.id));
}

void draw_with_tool(DraftContext& c, const GridPane& pane) {
  const bool active = ImGui::IsItemActive(), mine = c.drawing.shape && c.drawing.shape->grid == pane.id;
  if (ImGui::IsItemHovered() || active) c.frame.crosshair = true;
  const Cell at = pane.at(hand_at(c.style));
  if (c.select.tool == Tool::kFill) {
    if (ImGui::IsItemActivated()) flood_fill(c, pane.id, at);
  } else if (ImGui::IsItemActivated()) {
    begin_shape(c, pane.id, at);
  } else if (active && mine) {
    continue_shape(c, pane);
  } else if (mine) {
    c.wanted.gesture([](DocumentView& v, const Design& design) { return finish_shape(v, design); });
  }
}

const char* tool_hint(Tool tool) {
  switch (tool) {
    case Tool::kLine:
      return tr("Drag: draw a line; Shift: straight or at 45 degrees; from a filled cell or right: clear; Esc: cancel");
    case Tool::kRectangle:
    case Tool::kFilledRectangle:
      return tr("Drag: draw a rectangle; Shift: square; from a filled cell or right: clear; Esc: cancel");
    case Tool::kFill:
      return tr("Click: invert all connected cells like this one; right: clear them");
    case Tool::kType:
      return tr("Click: type numbers from here");
    default:
      return "";
  }
}

void draw_shape(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  const GridPane* pane = c.drawing.shape ? pane_of(l, c.drawing.shape->grid) : nullptr;
  if (pane == nullptr) return;
  const ActiveShape& s = *c.drawing.shape;
  const Mirror mirror = mirror_of(c.drawing, c.select.selected, c.design.draft);
  const Preview preview = preview_of(c, s);
  const float from_pitch = s.tool == Tool::kFilledRectangle ? kFilledFrom : kCellsFrom;
  const std::vector<Cell> from = images_of(mirror, s.grid, s.from), to = images_of(mirror, s.grid, s.to);
  dl->PushClipRect(pane->min(), {pane->max().x + 1, pane->max().y + 1}, true);
  for (size_t i = 0; i < from.size(); ++i) {
    if (leaves_others(s)) fade_threads(dl, *pane, from[i], to[i], preview.cleared);
    if (std::min(pane->x.pitch, pane->y.pitch) < from_pitch) draw_far(dl, *pane, s, from[i], to[i], preview.cell);
    else draw_cells(dl, *pane, cells_of_shape(s.tool, s.grid, from[i], to[i]), preview);
  }
  dl->PopClipRect();
}

void draw_mirrors(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  if (!pen_is_mirrored(c)) return;
  const Mirror mirror = mirror_of(c.drawing, c.select.selected, c.design.draft);
  for (const GridPane* pane : l.panes()) draw_axes(dl, c, *pane, mirror);
  const GridPane* over = c.frame.hover.cell.valid() ? pane_of(l, c.frame.hover.grid) : nullptr;
  if (over == nullptr) return;
  dl->PushClipRect(over->min(), {over->max().x + 1, over->max().y + 1}, true);
  const std::vector<Cell> images = images_of(mirror, over->id, c.frame.hover.cell);
  for (size_t i = 1; i < images.size(); ++i) {
    const PixelRect box = rect_between(*over, images[i], images[i]);
    dl->AddRect(box.min, {box.max.x + 1, box.max.y + 1}, with_alpha(c.style.color.accent, 0.75f), 0, 0, 1.5f);
  }
  dl->PopClipRect();
}

void draw_type_cursor(ImDrawList* dl, DraftContext& c, const DraftLayout& l) {
  const TypeCursor& cursor = c.drawing.cursor;
  const GridPane* pane = c.select.tool == Tool::kType ? pane_of(l, cursor.grid) : nullptr;
  if (pane == nullptr) return;
  const Style& s = c.style;
  const PixelRect cell = rect_between(*pane, cursor.at, cursor.at);
  const ImVec2 min = pane->min(), max = pane->max();
  const float thick = s.px(2);
  dl->PushClipRect({min.x - thick, min.y - thick}, {max.x + 1 + thick, max.y + 1 + thick}, true);
  const ImU32 band = with_alpha(s.color.accent, 0.13f);
  const bool along_ends = cursor.grid == GridId::kThreading || cursor.grid == GridId::kTieup;
  if (along_ends) dl->AddRectFilled({cell.min.x, min.y}, {cell.max.x + 1, max.y}, band);
  else dl->AddRectFilled({min.x, cell.min.y}, {max.x, cell.max.y + 1}, band);
  dl->AddRect({cell.min.x - 1, cell.min.y - 1}, {cell.max.x + 2, cell.max.y + 2}, s.color.accent, s.px(2), 0, thick);
  dl->PopClipRect();
  c.map.add("type.cursor", cell.min.x, cell.min.y, cell.max.x - cell.min.x, cell.max.y - cell.min.y);
  if (cursor.typed == 0) return;
  // The typed digits, on top of everything, above the cell.
  const std::string text = std::to_string(cursor.typed) + "\xE2\x80\xA6";
  const ImVec2 size = s.font.bold->CalcTextSizeA(font_size(s.font.bold), FLT_MAX, 0, text.c_str());
  const ImVec2 at{std::round((cell.min.x + cell.max.x - size.x) / 2), std::round(cell.min.y - size.y - s.px(9))};
  const float pad = s.px(5);
  dl->AddRectFilled({at.x - pad, at.y - pad / 2}, {at.x + size.x + pad, at.y + size.y + pad / 2}, s.color.accent,
                    s.px(4));
  dl->AddText(s.font.bold, font_size(s.font.bold), at, reading_color(s.color.accent), text.c_str());
}

}  // namespace weftlight::views
