#pragma once
// Lines, rectangles and fills on the grids: their cells and their edits. shape_input.h handles input and drawing.

#include <string>
#include <utility>
#include <vector>

#include "session/document/edit.h"
#include "session/editing/document_view.h"
#include "session/editing/mirror.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::Draft, draft::Threads;

/// Cells of a grid: row r, column c of `cells` is cell (at.a + c, at.b + r).
struct CellMask {
  Cell at;
  BitMatrix cells;
};

/// True for tools that draw from one cell to another.
bool is_shape(Tool tool);

/// The end of a shape while Shift is held, in a grid of that size: lines keep to eight directions, rectangles become
/// squares.
Cell constrained(Tool tool, Cell from, Cell to, int columns, int rows);

/// The cells of a shape. A line in the threading has one shaft per end, in the treadling one treadle per pick;
/// elsewhere it has no gaps.
CellMask cells_of_shape(Tool tool, GridId grid, Cell from, Cell to);
/// The cells of a shape and of its mirror images.
std::vector<CellMask> cells_of_shapes(const ActiveShape& shape, const Mirror& mirror);
/// True for a line that removes the other shafts or treadles of its ends or picks.
bool leaves_others(const ActiveShape& shape);

/// Flood fill: the connected region (4 neighbours) of cells equal to the one at `at`. `cells` is the drawdown.
CellMask region_about(const Draft& draft, const BitMatrix& cells, GridId grid, Cell at);
/// The run of threads around one with the same colour (or yarn), half-open.
std::pair<int, int> threads_about(const Threads& threads, BarPaint what, int thread);

/// Turns the finished shape into an edit; `notice` reports crossings that could not follow.
MaybeEdit finish_shape(DocumentView& view, const Design& design);
/// Sets or clears a region.
MaybeEdit fill_region(DocumentView& view, const Design& design, GridId grid, const CellMask& region, bool on);
/// Fills the run of threads around one on a colour bar.
Edit fill_bar_edit(const Draft& draft, GridId grid, Cell at, BarPaint what, int index);

/// "Line: 12 ends x 4 shafts" and its keys.
std::string shape_text(const ActiveShape& shape);

}  // namespace weftlight::session
