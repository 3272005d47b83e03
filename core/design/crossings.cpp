#include "design/crossings.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/loom.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using base::tr;
using draft::BitGrid, draft::Draft, draft::Factored, draft::clipped, draft::drawdown, draft::lifts, draft::transposed,
    draft::with_drawdown, draft::with_lifts;

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

// Each crossing of the block that is to be written, as write(end, pick, up).
template <class Visit>
void for_each_crossing(const Selection& s, int a, int b, const BitMatrix& cells, Write write, Visit visit) {
  for (int pick = s.b0; pick < s.b1; ++pick)
    for (int end = s.a0; end < s.a1; ++end) {
      const bool up = cells.get(pick - b, end - a);
      const bool leaves = write == Write::kAdd || write == Write::kErase;
      if (up || !leaves) visit(end, pick, up && write != Write::kErase);
    }
}

Painted taken(Design design, Factored factored) {
  if (!factored.done()) return {std::move(design), std::move(factored.why)};
  design.draft = std::move(factored.draft);
  return {std::move(design), {}};
}

/// Of ends on one shaft each, a pick's last one on a shaft has the last word on it: those ends, in order. Empty where
/// an end hangs on several shafts or on none, or some crossings are left as they are: then all count.
std::vector<int> last_of_each_shaft(const BitMatrix& threading, const Selection& s, Write write) {
  if (write == Write::kAdd || write == Write::kErase) return {};
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

Painted lifted(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  const Draft& d = design.draft;
  BitMatrix lift = lifts(d);
  bool changed = false, bare = false;
  const auto paint = [&](int end, int pick, bool up) {
    if (d.threading.first(end) < 0) bare |= up;
    else changed |= lift_end(lift.row(pick), d.threading.row(end), up == d.rising);
  };
  const bool whole_rows = a == 0 && s.a0 == 0 && s.a1 == d.ends() && cells.cols() == d.ends();
  if (whole_rows && (write == Write::kAdd || write == Write::kErase) && !has_several_shafts(d.threading)) {
    changed = lift_rows(lift, d, s, b, cells, write == Write::kAdd);
    bare = !changed && write == Write::kAdd && asks_bare_end(d, s, b, cells);
  } else if (const std::vector<int> ends = last_of_each_shaft(d.threading, s, write); ends.empty()) {
    for_each_crossing(s, a, b, cells, write, paint);
  } else {
    for (int pick = s.b0; pick < s.b1; ++pick)
      for (const int end : ends) paint(end, pick, cells.get(pick - b, end - a));
  }
  if (!changed) return {std::move(design), bare ? tr("an end on no shaft cannot be lifted") : ""};
  Factored factored = with_lifts(d, lift, loom_size(design).treadles);
  return taken(std::move(design), std::move(factored));
}

Painted woven(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  BitMatrix all = drawdown(design.draft);
  bool changed = false;
  for_each_crossing(s, a, b, cells, write, [&](int end, int pick, bool up) {
    changed |= all.get(pick, end) != up;
    all.set(pick, end, up);
  });
  if (!changed) return {std::move(design), {}};
  Factored factored = with_drawdown(design.draft, all, loom_size(design));
  return taken(std::move(design), std::move(factored));
}

}  // namespace

Painted painted_crossings(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write) {
  if (std::string why = why_locked(design, BitGrid::kDrawdown); !why.empty())
    return {std::move(design), std::move(why)};
  const bool alone = design.loom.leading == Leading::kDrawdown;
  return alone ? woven(std::move(design), s, a, b, cells, write) : lifted(std::move(design), s, a, b, cells, write);
}

Painted painted_cell(Design design, int end, int pick, bool up) {
  const Selection s = clipped({BitGrid::kDrawdown, end, end + 1, pick, pick + 1}, design.draft);
  if (end < 0 || pick < 0 || s.empty()) return {std::move(design), {}};
  BitMatrix cell(1, 1);
  cell.set(0, 0, up);
  return painted_crossings(std::move(design), s, end, pick, cell, Write::kInside);
}

Design with_drawdown_cell(Design design, int end, int pick, bool up) {
  return painted_cell(std::move(design), end, pick, up).design;
}

}  // namespace weftlight::design
