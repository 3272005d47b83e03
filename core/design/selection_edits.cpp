#include "design/selection_edits.h"

#include <algorithm>
#include <utility>

#include "design/crossings.h"
#include "design/edits.h"
#include "design/loom.h"
#include "draft/factor.h"

namespace weftlight::design {

using draft::System, draft::cells_of, draft::clipped, draft::covered, draft::whole_grid, draft::with_cells,
    draft::without_spare;

namespace {

int wrapped(int64_t i, int n) { return static_cast<int>(((i % n) + n) % n); }

/// A block whose cell (r, c) is `cell(r, c)`.
template <class Cell>
BitMatrix block_of(int rows, int columns, Cell cell) {
  BitMatrix out(rows, columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      if (cell(r, c)) out.set(r, c, true);
  return out;
}

/// Replaces the selection's cells by `map` of them.
template <class Map>
Design mapped(Design design, const Selection& s, Map map) {
  const BitMatrix next = map(cells_of(design.draft, s));
  return with_block(std::move(design), s.grid, s.a0, s.b0, next, Write::kInside);
}

/// Whether the selection is of whole ends (along a) or whole picks (along b).
bool whole_along_a(const Draft& d, const Selection& s) {
  return s.grid == BitGrid::kThreading && holds_whole_threads(d, s);
}
bool whole_along_b(const Draft& d, const Selection& s) {
  return s.grid != BitGrid::kThreading && holds_whole_threads(d, s);
}

Selection repeat_target(const Draft& d, const Selection& s, RepeatExtent extent) {
  Selection to = whole_grid(d, s.grid);
  if (s.grid == BitGrid::kLiftplan) to.a0 = s.a0, to.a1 = s.a1;
  if (extent == RepeatExtent::kToEnd) to.a0 = s.a0, to.b0 = s.b0;
  return to;
}

}  // namespace

Design with_block(Design design, BitGrid grid, int a, int b, const BitMatrix& cells, Write write) {
  const Selection s = covered(design.draft, grid, a, b, cells);
  if (s.empty()) return design;
  if (grid == BitGrid::kDrawdown) return painted_crossings(design, s, a, b, cells, write).value_or(design);
  if (!may_paint(design, grid)) return design;
  if (grid == BitGrid::kLiftplan) design = to_liftplan(std::move(design));
  design.draft = with_cells(std::move(design.draft), grid, a, b, cells, write);
  return design;
}

BitMatrix mirrored_across(const BitMatrix& m) {
  return block_of(m.rows(), m.cols(), [&](int r, int c) { return m.get(r, m.cols() - 1 - c); });
}

BitMatrix mirrored_down(const BitMatrix& m) {
  return block_of(m.rows(), m.cols(), [&](int r, int c) { return m.get(m.rows() - 1 - r, c); });
}

BitMatrix half_turned(const BitMatrix& m) {
  return block_of(m.rows(), m.cols(), [&](int r, int c) { return m.get(m.rows() - 1 - r, m.cols() - 1 - c); });
}

BitMatrix inverted(const BitMatrix& m) {
  BitMatrix out = m;
  for (int r = 0; r < out.rows(); ++r) {
    for (uint64_t& word : out.row(r)) word = ~word;
    if (out.words() > 0) out.row(r).back() &= out.last_word_mask();
  }
  return out;
}

BitMatrix shifted(const BitMatrix& m, int da, int db) {
  return block_of(m.rows(), m.cols(), [&](int r, int c) {
    return m.get(wrapped(int64_t{r} - db, m.rows()), wrapped(int64_t{c} - da, m.cols()));
  });
}

std::optional<ThreadRange> threads_of(const Selection& s) {
  if (s.empty()) return {};
  switch (s.grid) {
    case BitGrid::kThreading:
      return ThreadRange{System::kWarp, s.a0, s.a1};
    case BitGrid::kTreadling:
    case BitGrid::kLiftplan:
      return ThreadRange{System::kWeft, s.b0, s.b1};
    default:
      return {};
  }
}

bool holds_whole_threads(const Draft& d, const Selection& s) {
  const std::optional<ThreadRange> threads = threads_of(s);
  if (!threads) return false;
  const Selection all = whole_grid(d, s.grid);
  return threads->system == System::kWarp ? s.b0 <= 0 && s.b1 >= all.b1 : s.a0 <= 0 && s.a1 >= all.a1;
}

PlacedBlock cleared_block(const Draft& draft, const Selection& selection) {
  const Selection s = clipped(selection, draft);
  return {s, BitMatrix(s.rows(), s.columns())};
}

PlacedBlock repeated_block(const Draft& draft, const Selection& selection, RepeatExtent extent) {
  const Selection s = clipped(selection, draft);
  if (s.empty()) return {};
  const BitMatrix one = cells_of(draft, s);
  const Selection to = repeat_target(draft, s, extent);
  return {to, block_of(to.rows(), to.columns(), [&](int r, int c) {
            return one.get(wrapped(int64_t{r} + to.b0 - s.b0, one.rows()),
                           wrapped(int64_t{c} + to.a0 - s.a0, one.cols()));
          })};
}

Design with_cleared(Design design, const Selection& selection) {
  const PlacedBlock none = cleared_block(design.draft, selection);
  if (none.at.empty()) return design;
  return with_block(std::move(design), none.at.grid, none.at.a0, none.at.b0, none.cells, Write::kInside);
}

Design with_inverted(Design design, const Selection& selection) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  return mapped(std::move(design), s, inverted);
}

Design with_moved(Design design, const Selection& selection, int a, int b, bool copy) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  const BitMatrix block = cells_of(design.draft, s);
  if (copy) return with_block(std::move(design), s.grid, a, b, block, Write::kThreads);
  const Draft before = design.draft;
  design = with_block(with_cleared(std::move(design), s), s.grid, a, b, block, Write::kThreads);
  // What the cleared crossings asked of the loom may no longer be needed.
  if (s.grid == BitGrid::kDrawdown)
    design.draft = without_spare(std::move(design.draft), before, {before.shafts, before.treadles});
  return design;
}

Design with_mirrored_across(Design design, const Selection& selection, bool with_properties) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  if (whole_along_a(design.draft, s)) return with_reversed_threads(std::move(design), *threads_of(s), with_properties);
  return mapped(std::move(design), s, mirrored_across);
}

Design with_mirrored_down(Design design, const Selection& selection, bool with_properties) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  if (whole_along_b(design.draft, s)) return with_reversed_threads(std::move(design), *threads_of(s), with_properties);
  return mapped(std::move(design), s, mirrored_down);
}

Design with_half_turn(Design design, const Selection& selection, bool with_properties) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  if (!holds_whole_threads(design.draft, s)) return mapped(std::move(design), s, half_turned);
  return with_mirrored_down(with_mirrored_across(std::move(design), s, with_properties), s, with_properties);
}

Design with_shifted(Design design, const Selection& selection, int da, int db, bool with_properties) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  int& along_threads = s.grid == BitGrid::kThreading ? da : db;
  if (holds_whole_threads(design.draft, s))
    design = with_rotated_threads(std::move(design), *threads_of(s), std::exchange(along_threads, 0), with_properties);
  if (da == 0 && db == 0) return design;
  return mapped(std::move(design), s, [da, db](const BitMatrix& cells) { return shifted(cells, da, db); });
}

Design with_repeated(Design design, const Selection& selection, RepeatExtent extent, bool with_properties) {
  const Selection s = clipped(selection, design.draft);
  if (s.empty()) return design;
  const auto threads = threads_of(s);
  if (threads && (s.grid != BitGrid::kLiftplan || holds_whole_threads(design.draft, s)))
    return with_repeated_threads(std::move(design), *threads, extent, with_properties);
  const PlacedBlock many = repeated_block(design.draft, s, extent);
  return with_block(std::move(design), s.grid, many.at.a0, many.at.b0, many.cells, Write::kInside);
}

}  // namespace weftlight::design
