#include "views/draft/leading_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "design/loom.h"
#include "session/editing/selection_state.h"
#include "ui/widgets.h"

namespace weftlight::views {

using base::tr;
using draft::BitGrid;
using ui::Colors, ui::hit_area, ui::with_alpha;

namespace {

// Pixels at 96 dpi.
constexpr float kArea = 14, kBeside = 7, kBodyWidth = 8, kBodyHeight = 6, kShackle = 2.6f, kStem = 2.5f;
constexpr float kPi = 3.14159265f;

/// The left edge of a grid, beside which its padlock stands. The drawdown has it in the margin of the pane.
float lock_x(const DraftLayout& l, const GridPane& pane, const Style& s) {
  return pane.id == GridId::kDrawdown || pane.id == GridId::kThreading ? l.min.x + s.px(kBeside)
                                                                       : pane.min().x - s.px(kBeside + 2);
}

/// A padlock; open, its shackle is lifted and stands on one side.
void draw_padlock(ImDrawList* dl, ImVec2 middle, const Style& s, bool closed, ImU32 color) {
  const float w = s.px(kBodyWidth) / 2, h = s.px(kBodyHeight), r = s.px(kShackle), stem = s.px(kStem);
  const float top = std::floor(middle.y), x = std::floor(middle.x) + 0.5f;
  dl->AddRectFilled({x - w, top}, {x + w, top + h}, color, s.px(1.5f));
  const float lift = closed ? 0 : s.px(1.5f), arc = top - stem - lift;
  dl->PathLineTo({x - r, closed ? top : arc + stem / 2});
  dl->PathArcTo({x, arc}, r, kPi, 2 * kPi, 10);
  dl->PathLineTo({x + r, top});
  dl->PathStroke(color, 0, std::max(1.2f, s.px(1.4f)));
}

/// The tie-up has none beside the shaft numbers: it follows with the treadling.
bool has_lock(const DraftContext& c, const GridPane& pane) {
  const std::optional<BitGrid> grid = bit_grid_of(pane.id);
  return grid && pane.id != GridId::kTieup && !leads(c.design, *grid);
}

void draw_lock(ImDrawList* dl, DraftContext& c, const DraftLayout& l, const GridPane& pane) {
  if (pane.max().y - pane.min().y < 1 || pane.max().x - pane.min().x < 1) return;
  const bool locked = c.design.loom.locked;
  const float x = lock_x(l, pane, c.style), area = c.style.px(kArea), y = pane.min().y + c.style.px(2);
  const std::string id = std::string("lock:") + grid_name(pane.id);
  ImGui::SetCursorScreenPos({x - area / 2, y});
  if (hit_area(id.c_str(), {area, c.style.pressed_px(kArea)})) c.wanted.add_action("rules.lock");
  c.map.add_item(id);
  const bool hovered = ImGui::IsItemHovered();
  tooltip(c, locked ? tr("This grid follows the framed ones and is locked. Click to unlock the grids that follow.")
                    : tr("This grid follows the framed ones. Click to lock the grids that follow."));
  const Colors& k = c.style.color;
  const ImU32 color = hovered ? k.accent : locked ? k.text : with_alpha(k.muted, 0.55f);
  draw_padlock(dl, {x, y + c.style.px(7)}, c.style, locked, color);
}

}  // namespace

bool is_locked(const DraftContext& c, GridId id) {
  const std::optional<BitGrid> grid = bit_grid_of(id);
  return grid && !may_paint(c.design, *grid).has_value();
}

void draw_leading(ImDrawList* dl, const DraftContext& c, const DraftLayout& l) {
  for (const GridPane* pane : l.panes()) {
    const std::optional<BitGrid> grid = bit_grid_of(pane->id);
    const ImVec2 a = pane->min(), b = pane->max();
    if (!grid || !leads(c.design, *grid) || b.x - a.x < 1 || b.y - a.y < 1) continue;
    const float out = pane->id == GridId::kDrawdown ? 1.0f : 0.0f;
    dl->AddRect({a.x - out, a.y - out}, {b.x + 1, b.y + 1}, c.style.color.accent);
  }
}

void draw_locks(ImDrawList* dl, DraftContext& c, const DraftLayout& l) {
  for (const GridPane* pane : l.panes())
    if (has_lock(c, *pane)) draw_lock(dl, c, l, *pane);
}

}  // namespace weftlight::views
