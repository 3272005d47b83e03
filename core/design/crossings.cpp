#include "design/crossings.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/loom.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using base::tr;
using draft::BitGrid, draft::Draft, draft::clipped, draft::drawdown_columns, draft::for_each_bit, draft::lifts,
    draft::transposed, draft::with_columns, draft::with_lifts;

namespace {

bool meets(std::span<const uint64_t> x, std::span<const uint64_t> y) {
  for (size_t w = 0; w < x.size(); ++w)
    if (x[w] & y[w]) return true;
  return false;
}

// Brings an end up or down in a pick; true when that changed the lift.
bool lift_end(std::span<uint64_t> lift, std::span<const uint64_t> shafts, bool named) {
  if (meets(shafts, lift) == named) return false;
  for (size_t w = 0; w < lift.size(); ++w) lift[w] = named ? lift[w] | shafts[w] : lift[w] & ~shafts[w];
  return true;
}

// Crossings that the block does not set stay as they are.
bool leaves_unset(Write write) { return write == Write::kAdd || write == Write::kErase; }

// Each crossing of the block that is to be written, as write(end, pick, up).
template <class Visit>
void for_each_crossing(const Selection& s, int a, int b, const BitMatrix& cells, Write write, Visit visit) {
  for (int pick = s.b0; pick < s.b1; ++pick) {
    if (leaves_unset(write)) {
      for_each_bit(cells.row(pick - b), [&](int column) {
        if (const int end = column + a; end >= s.a0 && end < s.a1) visit(end, pick, write == Write::kAdd);
      });
    } else {
      for (int end = s.a0; end < s.a1; ++end) visit(end, pick, cells.get(pick - b, end - a));
    }
  }
}

// The ends of those crossings, ascending.
std::vector<int> written_ends(const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  std::vector<char> written(static_cast<size_t>(s.a1), leaves_unset(write) ? 0 : 1);
  if (leaves_unset(write)) for_each_crossing(s, a, b, cells, write, [&](int end, int, bool) { written[end] = 1; });
  std::vector<int> ends;
  for (int end = s.a0; end < s.a1; ++end)
    if (written[end]) ends.push_back(end);
  return ends;
}

base::Result<Design> taken(Design design, base::Result<Draft> factored) {
  if (!factored) return failed(factored);
  design.draft = std::move(*factored);
  return design;
}

/// Of ends on one shaft each, a pick's last one on a shaft has the last word on it: those ends, in order. Empty where
/// an end hangs on several shafts or on none, or some crossings are left as they are: then all count.
std::vector<int> last_of_each_shaft(const BitMatrix& threading, const Selection& s, Write write) {
  if (leaves_unset(write)) return {};
  std::vector<int> last(static_cast<size_t>(threading.cols()), -1);
  for (int end = s.a0; end < s.a1; ++end) {
    if (threading.count(end) != 1) return {};
    last[static_cast<size_t>(threading.first(end))] = end;
  }
  std::erase(last, -1);
  std::ranges::sort(last);
  return last;
}

bool has_several_shafts(const BitMatrix& threading) {
  for (int end = 0; end < threading.rows(); ++end)
    if (threading.count(end) > 1) return true;
  return false;
}

// The same for whole rows at once: each shaft that an end of the row hangs on.
bool lift_rows(BitMatrix& lift, const Draft& d, const Selection& s, int b, const BitMatrix& cells, bool up) {
  const BitMatrix ends_of = transposed(d.threading);
  bool changed = false;
  for (int pick = s.b0; pick < s.b1; ++pick) {
    const std::span<const uint64_t> row = cells.row(pick - b);
    for (int shaft = 0; shaft < d.shafts; ++shaft) {
      if (lift.get(pick, shaft) == (up == d.rising) || !meets(ends_of.row(shaft), row)) continue;
      lift.set(pick, shaft, up == d.rising);
      changed = true;
    }
  }
  return changed;
}

// Whether a cell of whole rows is of an end on no shaft.
bool asks_bare_end(const Draft& d, const Selection& s, int b, const BitMatrix& cells) {
  for (int end = 0; end < d.ends(); ++end)
    for (int pick = s.b0; d.threading.first(end) < 0 && pick < s.b1; ++pick)
      if (cells.get(pick - b, end)) return true;
  return false;
}

base::Result<Design> lifted(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  const Draft& d = design.draft;
  BitMatrix lift = lifts(d);
  bool changed = false, bare = false;
  const auto paint = [&](int end, int pick, bool up) {
    if (d.threading.first(end) < 0) bare |= up;
    else changed |= lift_end(lift.row(pick), d.threading.row(end), up == d.rising);
  };
  const bool whole_rows = a == 0 && s.a0 == 0 && s.a1 == d.ends() && cells.cols() == d.ends();
  if (whole_rows && leaves_unset(write) && !has_several_shafts(d.threading)) {
    changed = lift_rows(lift, d, s, b, cells, write == Write::kAdd);
    bare = !changed && write == Write::kAdd && asks_bare_end(d, s, b, cells);
  } else if (const std::vector<int> ends = last_of_each_shaft(d.threading, s, write); ends.empty()) {
    for_each_crossing(s, a, b, cells, write, paint);
  } else {
    for (int pick = s.b0; pick < s.b1; ++pick)
      for (const int end : ends) paint(end, pick, cells.get(pick - b, end - a));
  }
  if (!changed && bare) return base::failure(base::ErrorKind::kInput, tr("an end on no shaft cannot be lifted"));
  if (!changed) return design;
  base::Result<Draft> factored = with_lifts(d, lift, loom_size(design).treadles);
  return taken(std::move(design), std::move(factored));
}

base::Result<Design> woven(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  const std::vector<int> ends = written_ends(s, a, b, cells, write);
  std::vector<int> row_of(static_cast<size_t>(s.a1), -1);
  for (size_t i = 0; i < ends.size(); ++i) row_of[ends[i]] = static_cast<int>(i);
  BitMatrix columns = drawdown_columns(design.draft, ends);
  bool changed = false;
  for_each_crossing(s, a, b, cells, write, [&](int end, int pick, bool up) {
    changed |= columns.get(row_of[end], pick) != up;
    columns.set(row_of[end], pick, up);
  });
  if (!changed) return design;
  base::Result<Draft> factored = with_columns(design.draft, ends, columns, loom_size(design));
  return taken(std::move(design), std::move(factored));
}

}  // namespace

base::Result<Design> painted_crossings(Design design, const Selection& s, int a, int b, const BitMatrix& cells,
                                       Write write) {
  if (const base::Result<void> open = may_paint(design, BitGrid::kDrawdown); !open) return failed(open);
  const bool alone = design.loom.leading == Leading::kDrawdown;
  return alone ? woven(std::move(design), s, a, b, cells, write) : lifted(std::move(design), s, a, b, cells, write);
}

base::Result<Design> painted_cell(Design design, int end, int pick, bool up) {
  const Selection s = clipped({BitGrid::kDrawdown, end, end + 1, pick, pick + 1}, design.draft);
  if (end < 0 || pick < 0 || s.empty()) return design;
  BitMatrix cell(1, 1);
  cell.set(0, 0, up);
  return painted_crossings(std::move(design), s, end, pick, cell, Write::kInside);
}

Design with_drawdown_cell(Design design, int end, int pick, bool up) {
  base::Result<Design> painted = painted_cell(design, end, pick, up);
  return painted ? std::move(*painted) : design;
}

}  // namespace weftlight::design
