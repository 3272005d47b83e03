#pragma once
// The grids of a draft as they are drawn, and a cell of one.

namespace weftlight::session {

enum class GridId { kNone, kThreading, kTieup, kTreadling, kLiftplan, kDrawdown, kWarpColors, kWeftColors };
/// Name in the --ui-map.
const char* grid_name(GridId grid);

/// A cell: a is along the screen's x, b along its y. threading (end, shaft), tieup (treadle, shaft),
/// treadling (treadle, pick), liftplan (shaft, pick), drawdown (end, pick), warp_colors (end, 0),
/// weft_colors (0, pick). -1: none.
struct Cell {
  int a = -1, b = -1;
  bool valid() const { return a >= 0 && b >= 0; }
  bool operator==(const Cell&) const = default;
};

/// The cell under the pointer.
struct Hover {
  GridId grid = GridId::kNone;
  Cell cell;
};

/// True if the columns of the grid are ends, and if its rows are picks.
bool has_ends(GridId grid);
bool has_picks(GridId grid);

}  // namespace weftlight::session
