#pragma once
// Lines, rectangles and fills on the grids: which cells they take, and the edits that they become. No drawing here:
// shape_input.h sees to the screen.

#include <string>
#include <utility>
#include <vector>

#include "session/document_view.h"
#include "session/edit.h"
#include "session/mirror.h"
#include "session/names.h"

namespace weftlight::session {

/// Cells of a grid: row r, column c of `cells` is cell (at.a + c, at.b + r).
struct CellMask {
  Cell at;
  BitMatrix cells;
};

/// Drawn from one cell to another.
bool is_shape(Tool tool);

/// Where a shape ends while Shift is held, in a grid of that size: a line along one of eight directions, a rectangle
/// with equal sides.
Cell constrained(Tool tool, Cell from, Cell to, int columns, int rows);

/// The cells of a shape. A line in the threading is on one shaft of each end, in the treadling on one treadle of each
/// pick; elsewhere it has no gaps.
CellMask cells_of_shape(Tool tool, GridId grid, Cell from, Cell to);
/// A shape and its images.
std::vector<CellMask> cells_of_shapes(const ActiveShape& shape, const Mirror& mirror);
/// A line there leaves each end or pick on one shaft or treadle.
bool leaves_others(const ActiveShape& shape);

/// All cells like the one at `at` that can be reached from it sideways, up and down. `cells`: the drawdown.
CellMask region_about(const Draft& draft, const BitMatrix& cells, GridId grid, Cell at);
/// The threads beside one that have its colour (or yarn): half-open.
std::pair<int, int> threads_about(const Threads& threads, BarPaint what, int thread);

/// What the hand lets go becomes an edit; `notice` says what could not follow.
MaybeEdit finish_shape(DocumentView& view, const Design& design);
/// A region set or cleared.
MaybeEdit fill_region(DocumentView& view, const Design& design, GridId grid, const CellMask& region, bool on);
/// The threads about one on a colour bar.
Edit fill_bar_edit(const Draft& draft, GridId grid, Cell at, BarPaint what, int index);

/// "Line: 12 ends x 4 shafts" and what keys do meanwhile.
std::string shape_text(const ActiveShape& shape);

}  // namespace weftlight::session
