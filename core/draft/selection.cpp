#include "draft/selection.h"

#include <algorithm>
#include <span>
#include <utility>

#include "draft/drawdown.h"

namespace weftlight::draft {
namespace {

/// Threading and tie-up have one matrix row per column a, the other grids one per row b.
bool stored_by_column(BitGrid grid) { return grid == BitGrid::kThreading || grid == BitGrid::kTieup; }

const BitMatrix& stored(const Draft& d, BitGrid grid) {
  switch (grid) {
    case BitGrid::kThreading:
      return d.threading;
    case BitGrid::kTieup:
      return d.tieup;
    case BitGrid::kTreadling:
      return d.treadling;
    default:
      return d.liftplan;
  }
}
BitMatrix& stored(Draft& d, BitGrid grid) { return const_cast<BitMatrix&>(stored(std::as_const(d), grid)); }

BitMatrix rows_between(const BitMatrix& m, int first, int end) {
  BitMatrix out(end - first, m.cols());
  for (int r = first; r < end; ++r) std::ranges::copy(m.row(r), out.row(r - first).begin());
  return out;
}

/// The crossings of the selection, computed from its ends and picks alone.
BitMatrix crossings(const Draft& d, const Selection& s) {
  Draft part;
  part.shafts = d.shafts;
  part.treadles = d.treadles;
  part.rising = d.rising;
  part.shed_control = d.shed_control;
  part.threading = rows_between(d.threading, s.a0, s.a1);
  part.tieup = d.tieup;
  part.treadling = rows_between(d.treadling, s.b0, s.b1);
  part.liftplan = rows_between(d.liftplan, s.b0, s.b1);
  part.warp.resize(s.columns());
  part.weft.resize(s.rows());
  return drawdown(part);
}

void clear_marked_threads(BitMatrix& m, const Selection& s, int a, int b, const BitMatrix& cells) {
  const bool by_column = stored_by_column(s.grid);
  for (int y = s.b0; y < s.b1; ++y)
    for (int x = s.a0; x < s.a1; ++x)
      if (cells.get(y - b, x - a)) std::ranges::fill(m.row(by_column ? x : y), 0);
}

void write_bits(BitMatrix& m, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  const bool by_column = stored_by_column(s.grid);
  const bool by_threads = s.grid == BitGrid::kThreading || s.grid == BitGrid::kTreadling;
  if (write == Write::kThreads && by_threads) clear_marked_threads(m, s, a, b, cells);
  for (int y = s.b0; y < s.b1; ++y)
    for (int x = s.a0; x < s.a1; ++x) {
      const bool on = cells.get(y - b, x - a);
      const bool marks_only = write == Write::kAdd || write == Write::kErase;
      if (on || !marks_only) m.set(by_column ? x : y, by_column ? y : x, on && write != Write::kErase);
    }
}

}  // namespace

int columns_of(const Draft& d, BitGrid grid) {
  switch (grid) {
    case BitGrid::kThreading:
    case BitGrid::kDrawdown:
      return d.ends();
    case BitGrid::kTieup:
    case BitGrid::kTreadling:
      return d.treadles;
    case BitGrid::kLiftplan:
      return d.shafts;
  }
  return 0;
}

int rows_of(const Draft& d, BitGrid grid) {
  return grid == BitGrid::kThreading || grid == BitGrid::kTieup ? d.shafts : d.picks();
}

Selection whole_grid(const Draft& d, BitGrid grid) { return {grid, 0, columns_of(d, grid), 0, rows_of(d, grid)}; }

Selection clipped(const Selection& s, const Draft& d) {
  return {s.grid, std::max(s.a0, 0), std::min(s.a1, columns_of(d, s.grid)), std::max(s.b0, 0),
          std::min(s.b1, rows_of(d, s.grid))};
}

BitMatrix cells_of(const Draft& d, const Selection& selection) {
  const Selection s = clipped(selection, d);
  if (s.empty()) return {};
  if (s.grid == BitGrid::kDrawdown) return crossings(d, s);
  const BitMatrix& m = stored(d, s.grid);
  const bool by_column = stored_by_column(s.grid);
  BitMatrix out(s.rows(), s.columns());
  for (int y = s.b0; y < s.b1; ++y)
    for (int x = s.a0; x < s.a1; ++x)
      if (m.get(by_column ? x : y, by_column ? y : x)) out.set(y - s.b0, x - s.a0, true);
  return out;
}

Selection covered(const Draft& d, BitGrid grid, int a, int b, const BitMatrix& cells) {
  return clipped({grid, a, a + cells.cols(), b, b + cells.rows()}, d);
}

Draft with_cells(Draft draft, BitGrid grid, int a, int b, const BitMatrix& cells, Write write) {
  const Selection s = covered(draft, grid, a, b, cells);
  if (!s.empty() && grid != BitGrid::kDrawdown) write_bits(stored(draft, grid), s, a, b, cells, write);
  return draft;
}

int64_t missed_cells(const Draft& d, BitGrid grid, int a, int b, const BitMatrix& cells) {
  const Selection s = covered(d, grid, a, b, cells);
  const BitMatrix shown = cells_of(d, s);
  int64_t missed = 0;
  for (int y = s.b0; y < s.b1; ++y)
    for (int x = s.a0; x < s.a1; ++x) missed += shown.get(y - s.b0, x - s.a0) != cells.get(y - b, x - a);
  return missed;
}

BitMatrix turned_for(const CellBlock& block, BitGrid to) {
  const auto threads_across = [](BitGrid g) { return g == BitGrid::kThreading; };
  const auto threads_down = [](BitGrid g) { return g == BitGrid::kTreadling || g == BitGrid::kLiftplan; };
  const bool turn =
      (threads_across(block.from) && threads_down(to)) || (threads_down(block.from) && threads_across(to));
  return turn ? transposed(block.cells) : block.cells;
}

}  // namespace weftlight::draft
