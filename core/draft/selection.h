#pragma once
// A rectangle of cells of one grid, and a block of cells that is copied, moved or pasted. Edits of a whole selection
// are in design/selection_edits.h, those of whole threads in design/thread_order.h.

#include "draft/draft.h"

namespace weftlight::draft {

/// The grids of a draft. Each has columns a and rows b: threading (end, shaft), tie-up (treadle, shaft),
/// treadling (treadle, pick), liftplan (shaft, pick), drawdown (end, pick).
enum class BitGrid { kThreading, kTieup, kTreadling, kLiftplan, kDrawdown };

/// Half-open in both directions; a valid one is not empty and lies inside its grid.
struct Selection {
  BitGrid grid = BitGrid::kThreading;
  int a0 = 0, a1 = 0, b0 = 0, b1 = 0;
  int columns() const { return a1 - a0; }
  int rows() const { return b1 - b0; }
  bool empty() const { return a0 >= a1 || b0 >= b1; }
  bool operator==(const Selection&) const = default;
};

/// Put at (a, b), row r and column c of `cells` is cell (a + c, b + r) of the grid.
struct CellBlock {
  BitGrid from = BitGrid::kThreading;
  BitMatrix cells;
  bool operator==(const CellBlock&) const = default;
};

/// How a block is combined with the cells of the grid.
enum class Write {
  kInside,   // replaces the cells of its rectangle
  kThreads,  // also clears the other marks of each end (pick) that gets one, as painting does
  kAdd,      // adds the marks of the block
  kErase,    // removes the marks of the block
};

int columns_of(const Draft& draft, BitGrid grid);
int rows_of(const Draft& draft, BitGrid grid);
Selection whole_grid(const Draft& draft, BitGrid grid);
/// The part of the selection inside its grid; may be empty.
Selection clipped(const Selection& selection, const Draft& draft);

/// The cells of the clipped selection. In the drawdown only those crossings are computed.
BitMatrix cells_of(const Draft& draft, const Selection& selection);
/// The block written at (a, b) into the stored grid (not the drawdown), clipped to it.
Draft with_cells(Draft draft, BitGrid grid, int a, int b, const BitMatrix& cells, Write write);
/// The part of a block at (a, b) that lies inside the grid; may be empty.
Selection covered(const Draft& draft, BitGrid grid, int a, int b, const BitMatrix& cells);

/// Number of cells of a block at (a, b), inside the grid, that differ from the draft.
int64_t missed_cells(const Draft& draft, BitGrid grid, int a, int b, const BitMatrix& cells);

/// The block as it is pasted into another grid. Between threading and treadling or liftplan it is transposed, so that
/// threads stay threads (a threading becomes the treadling woven as drawn in).
BitMatrix turned_for(const CellBlock& block, BitGrid to);

}  // namespace weftlight::draft
