#pragma once
// Painting on the grids: cells, strokes, and the status line text of a cell.

#include <string>
#include <vector>

#include "design/edits.h"
#include "session/document/edit.h"
#include "session/editing/document_view.h"
#include "session/editing/mirror.h"

namespace weftlight::session {

using design::Design;
using draft::BitMatrix, draft::Draft, draft::LoomSize;

/// Cells on the straight line between two cells, both included; each is a neighbour of the one before.
std::vector<Cell> line_of_cells(Cell from, Cell to);

/// True if the cell is marked in its grid. False for the colour bars and outside the grid.
bool is_on(const Draft& draft, const BitMatrix& cells, GridId grid, Cell at);

/// Sets or clears one cell. `only`: removes other shafts or treadles of the thread.
Design with_cell(Design design, GridId grid, Cell at, bool on, bool only);

/// Begins a stroke at a cell. `only`: removes other shafts or treadles of the threads.
MaybeEdit begin_stroke(DocumentView& view, const Design& design, GridId grid, Cell at, bool on, bool only);
/// Extends the stroke to a cell: paints all crossings, marks or threads on the way. Nothing while it stays in its cell.
MaybeEdit go_on_with_stroke(DocumentView& view, const Design& design, Cell to, bool only);

/// The edit of a stroke from one cell to the next, with its mirror images. `given`: DocumentView::given.
Edit paint_edit(GridId grid, Cell from, Cell to, bool on, bool only, const Mirror& mirror = {}, LoomSize given = {});
/// The same on a colour bar: every thread passed gets the colour (or the yarn).
Edit bar_edit(GridId grid, Cell from, Cell to, BarPaint what, int index, const Mirror& mirror = {});

/// A sentence on the cell under the pointer: "End 12 on shaft 3". Empty when there is none.
std::string describe(const Design& design, const BitMatrix& cells, GridId grid, Cell at);

}  // namespace weftlight::session
