#pragma once
// Painting on the grids: what a cell is, what a stroke makes of it, and what the status line says of it.

#include <string>
#include <vector>

#include "draft/edits.h"
#include "session/document_view.h"
#include "session/edit.h"
#include "session/mirror.h"
#include "session/names.h"

namespace weftlight::session {

/// Cells on the straight line between two, both included, each a neighbour of the one before.
std::vector<Cell> line_of_cells(Cell from, Cell to);

/// Whether a cell is filled: a bit of its grid. False for the colour bars and outside the grid.
bool is_on(const Draft& draft, const BitMatrix& cells, GridId grid, Cell at);

/// One cell of a grid set. `only`: a thread keeps no other shaft or treadle.
Design with_cell(Design design, GridId grid, Cell at, bool on, bool only);

/// A stroke begins at a cell. `only`: a thread keeps no other shaft or treadle.
MaybeEdit begin_stroke(DocumentView& view, const Design& design, GridId grid, Cell at, bool on, bool only);
/// The stroke has come to a cell: all crossings on its way, or marks, or threads. Nothing while it stays in its cell.
MaybeEdit go_on_with_stroke(DocumentView& view, const Design& design, Cell to, bool only);

/// The edit of a stroke that moved from one cell to the next, and of its images. `given`: DocumentView::given.
Edit paint_edit(GridId grid, Cell from, Cell to, bool on, bool only, const Mirror& mirror = {}, LoomSize given = {});
/// The same on a colour bar: every thread passed takes the colour (or the yarn).
Edit bar_edit(GridId grid, Cell from, Cell to, BarPaint what, int index, const Mirror& mirror = {});

/// A sentence on the cell under the pointer: "End 12 on shaft 3". Empty when there is none.
std::string describe(const Design& design, const BitMatrix& cells, GridId grid, Cell at);

}  // namespace weftlight::session
