#pragma once
// A rectangle of cells of one grid, and a block of cells apart from any draft (what is copied, moved and
// pasted). Edits of a whole selection are in selection_edits.h, those of whole threads in thread_order.h.

#include "draft/design.h"

namespace weftlight::draft {

/// The grids of bits. Each is seen as columns a and rows b: threading (end, shaft), tie-up (treadle, shaft),
/// treadling (treadle, pick), liftplan (shaft, pick), drawdown (end, pick).
enum class BitGrid { kThreading, kTieup, kTreadling, kLiftplan, kDrawdown };

/// Half-open on both sides; a valid one is not empty and lies in its grid.
struct Selection {
  BitGrid grid = BitGrid::kThreading;
  int a0 = 0, a1 = 0, b0 = 0, b1 = 0;
  int columns() const { return a1 - a0; }
  int rows() const { return b1 - b0; }
  bool empty() const { return a0 >= a1 || b0 >= b1; }
  bool operator==(const Selection&) const = default;
};

/// Row r, column c of `cells` is cell (a + c, b + r) of the grid that it is put into.
struct CellBlock {
  BitGrid from = BitGrid::kThreading;
  BitMatrix cells;
  bool operator==(const CellBlock&) const = default;
};

/// How a block meets what is there.
enum class Write {
  kInside,   // its rectangle becomes the block, and nothing else changes
  kThreads,  // also an end (pick) that gets a mark leaves the shafts (treadles) outside: as painting does
  kAdd,      // only marks are added
  kErase,    // where the block has marks, those that are there go
};

int columns_of(const Draft& draft, BitGrid grid);
int rows_of(const Draft& draft, BitGrid grid);
Selection whole_grid(const Draft& draft, BitGrid grid);
/// The part inside its grid; empty when nothing is.
Selection clipped(const Selection& selection, const Draft& draft);

/// The cells of a selection (clipped). Of the drawdown: those crossings alone are computed.
BitMatrix cells_of(const Draft& draft, const Selection& selection);
/// The block with its first cell at (a, b); what lies outside the grid is left out. A liftplan block turns a
/// treadled draft into one driven by its liftplan; crossings are painted as crossings.h says. A grid that is locked
/// stays as it is.
Design with_block(Design design, BitGrid grid, int a, int b, const BitMatrix& cells, Write write);

/// How many cells of a block the design does not show at that place (of those inside the grid).
int64_t missed_cells(const Draft& draft, BitGrid grid, int a, int b, const BitMatrix& cells);

/// The block as it goes into another grid: between threading, treadling and liftplan, threads stay threads
/// (a threading becomes the treadling that weaves as drawn in); else the cells as they are seen.
BitMatrix turned_for(const CellBlock& block, BitGrid to);

}  // namespace weftlight::draft
