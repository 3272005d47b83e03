#pragma once
// Drawing of the grids with ImDrawList: only what is in sight, on whole pixels.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// Threading, treadling, liftplan: filled cells. Tie-up: a ring for a rising shaft, a cross for a sinking.
void draw_bits(ImDrawList* dl, const PanelContext& c, const GridPane& pane);
/// A thread's colour a cell; in yarn mode the yarn's number on it.
void draw_color_bar(ImDrawList* dl, const PanelContext& c, const GridPane& pane, System system);
/// The drawdown, cell by cell, while cells are large enough (draws_cells).
void draw_drawdown_cells(ImDrawList* dl, const PanelContext& c, const GridPane& pane);
/// What floats further than is allowed, tinted.
void draw_long_floats(ImDrawList* dl, const PanelContext& c, const GridPane& pane);
/// What is another crossing in the draft that this one is held against.
void draw_differences(ImDrawList* dl, const PanelContext& c, const GridPane& pane);
bool draws_cells(const PanelContext& c, const GridPane& pane);

/// Numbers and ticks along a grid; `pane.x` for a ruler above, `pane.y` for one at its right.
void draw_ruler_above(ImDrawList* dl, const PanelContext& c, const Axis& axis, float top, float height, int lit);
void draw_ruler_beside(ImDrawList* dl, const PanelContext& c, const Axis& axis, float left, int lit);

/// The row and the column of the pointer, on every grid that shares the thread, shaft or treadle.
void draw_hover(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
