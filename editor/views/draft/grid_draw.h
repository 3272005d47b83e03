#pragma once
// Draws the visible part of the grids with ImDrawList, on whole pixels.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using draft::System;
using ui::Axis;

/// Threading, treadling, liftplan: filled cells. Tie-up: a ring for a rising shaft, a cross for a sinking.
void draw_bits(ImDrawList* dl, const DraftContext& c, const GridPane& pane);
/// One cell per thread in its colour; in yarn mode with the number of its yarn.
void draw_color_bar(ImDrawList* dl, const DraftContext& c, const GridPane& pane, System system);
/// The drawdown, cell by cell, if cells are large enough (draws_cells).
void draw_drawdown_cells(ImDrawList* dl, const DraftContext& c, const GridPane& pane);
/// Tints floats over the maximum.
void draw_long_floats(ImDrawList* dl, const DraftContext& c, const GridPane& pane);
/// Marks crossings that differ from the draft it is compared to, or from the closest weave.
void draw_differences(ImDrawList* dl, const DraftContext& c, const GridPane& pane);
bool draws_cells(const DraftContext& c, const GridPane& pane);

/// Numbers along a grid: the axis `pane.x` for a ruler above, `pane.y` for one at the right. `lit`: the hovered one.
void draw_ruler_above(ImDrawList* dl, const DraftContext& c, const Axis& axis, float top, float height, int lit);
void draw_ruler_beside(ImDrawList* dl, const DraftContext& c, const Axis& axis, float left, int lit);

/// The row and the column under the pointer, on every grid that has that thread, shaft or treadle.
void draw_hover(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
