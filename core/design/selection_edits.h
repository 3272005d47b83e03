#pragma once
// Pure edits of a selection: Design -> Design. Low a is left and low b is up, however a window draws the grid. If a
// selection holds whole ends or picks of the threading, treadling or liftplan, edits along the threads move the threads
// themselves and, if `with_properties`, their colour, yarn, spacing and thickness. Selections are clipped to their
// grid; an empty one changes nothing.

#include <optional>

#include "design/thread_order.h"
#include "draft/selection.h"

namespace weftlight::design {

using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::Selection, draft::Write;

/// Puts a block with its first cell at (a, b), clipped to the grid. A block in the liftplan makes the liftplan the shed
/// control; crossings are painted as in crossings.h. A locked grid is unchanged.
Design with_block(Design design, BitGrid grid, int a, int b, const BitMatrix& cells, Write write);

// The edits below, for a block of cells.
BitMatrix mirrored_across(const BitMatrix& cells);  // left to right
BitMatrix mirrored_down(const BitMatrix& cells);    // top to bottom
BitMatrix half_turned(const BitMatrix& cells);
BitMatrix inverted(const BitMatrix& cells);
BitMatrix shifted(const BitMatrix& cells, int da, int db);

/// The ends or picks that a selection touches; none in the tie-up and the drawdown.
std::optional<ThreadRange> threads_of(const Selection& selection);
/// True if every shaft (treadle) of them is selected.
bool holds_whole_threads(const Draft& draft, const Selection& selection);

/// A block of cells and where it goes.
struct PlacedBlock {
  Selection at;
  BitMatrix cells;
};
/// What the edits below ask of the selection's grid: no cell of it; it in both directions.
PlacedBlock cleared_block(const Draft& draft, const Selection& s);
PlacedBlock repeated_block(const Draft& draft, const Selection& s, RepeatExtent extent);

Design with_cleared(Design design, const Selection& s);
Design with_inverted(Design design, const Selection& s);
/// Moves the marks to (a, b); `copy` keeps the original, too. Threads keep their position and colour.
Design with_moved(Design design, const Selection& s, int a, int b, bool copy = false);
Design with_mirrored_across(Design design, const Selection& s, bool with_properties = true);  // left to right
Design with_mirrored_down(Design design, const Selection& s, bool with_properties = true);    // top to bottom
Design with_half_turn(Design design, const Selection& s, bool with_properties = true);
/// Shifts by da columns and db rows within the selection, cyclically.
Design with_shifted(Design design, const Selection& s, int da, int db, bool with_properties = true);
/// In threading and treadling repeats whole threads; elsewhere the block in both directions (part of a liftplan's
/// shafts: along the picks only).
Design with_repeated(Design design, const Selection& s, RepeatExtent extent, bool with_properties = true);

}  // namespace weftlight::design
