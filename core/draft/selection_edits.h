#pragma once
// Pure edits of a selection: Design -> Design. Left, right, up and down are along a and b (low a is left, low
// b is up), whichever way a window draws them. Where a selection holds whole ends or picks of the threading,
// treadling or liftplan, what moves along the threads moves the threads themselves, `with_properties` with their
// colour, yarn, spacing and thickness. An empty selection changes nothing; others are clipped to their grid.

#include <optional>

#include "draft/selection.h"
#include "draft/thread_order.h"

namespace weftlight::draft {

// What the edits below make of the cells of a block.
BitMatrix mirrored_across(const BitMatrix& cells);  // left to right: the columns change places
BitMatrix mirrored_down(const BitMatrix& cells);    // top to bottom
BitMatrix half_turned(const BitMatrix& cells);
BitMatrix inverted(const BitMatrix& cells);
BitMatrix shifted(const BitMatrix& cells, int da, int db);

/// The ends or picks that a selection touches; none in the tie-up and the drawdown.
std::optional<ThreadRange> threads_of(const Selection& selection);
/// True when they are whole: every shaft (treadle) of them is selected.
bool holds_whole_threads(const Draft& draft, const Selection& selection);

Design with_cleared(Design design, const Selection& s);
Design with_inverted(Design design, const Selection& s);
/// The marks to (a, b); `copy`: they also stay. Threads keep their place and colour.
Design with_moved(Design design, const Selection& s, int a, int b, bool copy = false);
Design with_mirrored_across(Design design, const Selection& s, bool with_properties = true);  // left to right
Design with_mirrored_down(Design design, const Selection& s, bool with_properties = true);    // top to bottom
Design with_half_turn(Design design, const Selection& s, bool with_properties = true);
/// By da columns and db rows inside the selection: what leaves at one side comes in at the other.
Design with_shifted(Design design, const Selection& s, int da, int db, bool with_properties = true);
/// Threading and treadling: the threads, whole. Else the block, over and over, in both directions (liftplan
/// of not all shafts: along the picks).
Design with_repeated(Design design, const Selection& s, Reach reach, bool with_properties = true);

}  // namespace weftlight::draft
