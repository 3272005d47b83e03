#include "session/editing/shapes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>

#include "base/text.h"
#include "design/loom.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;
using design::Leading, design::inverted, design::may_paint, design::with_block;
using draft::BitGrid, draft::Selection, draft::System, draft::Write, draft::cells_of, draft::clipped, draft::whole_grid,
    draft::without_spare;

namespace {

bool by_end(GridId grid) { return grid == GridId::kThreading; }
bool by_pick(GridId grid) { return grid == GridId::kTreadling; }

const char* shape_name(Tool tool) {
  return tool == Tool::kLine ? tr("Line") : tool == Tool::kRectangle ? tr("Rectangle") : tr("Filled rectangle");
}

const char* shape_label(Tool tool) {
  return tool == Tool::kLine        ? tr("Draw line")
         : tool == Tool::kRectangle ? tr("Draw rectangle")
                                    : tr("Draw filled rectangle");
}

/// Index at `step` of `steps` equal steps between two indices.
int between(int from, int to, int step, int steps) {
  const double t = steps == 0 ? 1 : static_cast<double>(step) / steps;
  return from + static_cast<int>(std::lround(t * (to - from)));
}

std::vector<Cell> cells_of_line(GridId grid, Cell from, Cell to) {
  if (!by_end(grid) && !by_pick(grid)) return line_of_cells(from, to);
  const int da = to.a - from.a, db = to.b - from.b, steps = std::abs(by_end(grid) ? da : db);
  std::vector<Cell> line;
  for (int i = 0; i <= steps; ++i) line.push_back({between(from.a, to.a, i, steps), between(from.b, to.b, i, steps)});
  return line;
}

CellMask blank_mask(Cell one, Cell other) {
  const int a = std::min(one.a, other.a), b = std::min(one.b, other.b);
  return {{a, b}, BitMatrix(std::abs(one.b - other.b) + 1, std::abs(one.a - other.a) + 1)};
}

CellMask cells_of_rectangle(bool filled, Cell from, Cell to) {
  CellMask mask = blank_mask(from, to);
  BitMatrix& m = mask.cells;
  for (int r = 0; r < m.rows(); ++r)
    for (int c = 0; c < m.cols(); ++c)
      if (filled || r == 0 || c == 0 || r == m.rows() - 1 || c == m.cols() - 1) m.set(r, c, true);
  return mask;
}

/// Number of cells that did not get the wanted value.
int64_t missed_by(const Draft& d, const CellMask& mask, bool on) {
  const Selection place{BitGrid::kDrawdown, mask.at.a, mask.at.a + mask.cells.cols(), mask.at.b,
                        mask.at.b + mask.cells.rows()};
  const Selection s = clipped(place, d);
  const BitMatrix shown = cells_of(d, s);
  int64_t missed = 0;
  if (mask.at.a == 0 && mask.cells.cols() == shown.cols()) {
    for (int b = s.b0; b < s.b1; ++b)
      for (size_t w = 0; w < shown.row(0).size(); ++w) {
        const uint64_t as_it_is = shown.row(b - s.b0)[w];
        missed += std::popcount(mask.cells.row(b - mask.at.b)[w] & (on ? ~as_it_is : as_it_is));
      }
    return missed;
  }
  for (int b = s.b0; b < s.b1; ++b)
    for (int a = s.a0; a < s.a1; ++a)
      missed += mask.cells.get(b - mask.at.b, a - mask.at.a) && shown.get(b - s.b0, a - s.a0) != on;
  return missed;
}

uint64_t ones_between(int from, int to) { return (~uint64_t{0} >> (64 - (to - from))) << from; }

/// The run of ones around a set bit, as columns [first, end).
std::pair<int, int> run_about(std::span<const uint64_t> row, int at) {
  size_t low = static_cast<size_t>(at) / 64, high = low;
  const int bit = at % 64;
  int first = at + 1 - std::countl_one(row[low] << (63 - bit)), end = at + std::countr_one(row[high] >> bit);
  while (first == static_cast<int>(low) * 64 && low > 0) first -= std::countl_one(row[--low]);
  while (end == static_cast<int>(high + 1) * 64 && high + 1 < row.size()) end += std::countr_one(row[++high]);
  return {first, end};
}

/// A flood fill by runs of equal cells, word by word.
class Flood {
 public:
  Flood(const Draft& d, const BitMatrix& cells, GridId grid, Cell at) {
    const BitGrid bits = *bit_grid_of(grid);
    left_ = bits == BitGrid::kDrawdown ? cells : cells_of(d, whole_grid(d, bits));
    if (!is_on(d, cells, grid, at)) left_ = inverted(left_);
    seen_ = BitMatrix(left_.rows(), left_.cols());
    take_run(at);
    while (!runs_.empty()) spread();
  }
  BitMatrix seen() && { return std::move(seen_); }

 private:
  struct Run {
    int b, a0, a1;
  };
  /// Moves the run at `at` from the unseen cells to the seen ones.
  Run take_run(Cell at) {
    const auto left = left_.row(at.b), seen = seen_.row(at.b);
    const auto [a0, a1] = run_about(left, at.a);
    for (int a = a0; a < a1;) {
      const int next = std::min(a1, (a / 64 + 1) * 64);
      const uint64_t ones = ones_between(a % 64, a % 64 + next - a);
      left[static_cast<size_t>(a) / 64] &= ~ones, seen[static_cast<size_t>(a) / 64] |= ones;
      a = next;
    }
    runs_.push_back({at.b, a0, a1});
    return runs_.back();
  }
  void spread() {
    const Run run = runs_.back();
    runs_.pop_back();
    for (const int b : {run.b - 1, run.b + 1}) {
      if (b < 0 || b >= left_.rows()) continue;
      for (int a = run.a0; a < run.a1;) {
        const uint64_t rest = left_.row(b)[static_cast<size_t>(a) / 64] >> (a % 64);
        a = rest != 0 ? a + std::countr_zero(rest) : (a / 64 + 1) * 64;
        if (rest != 0 && a < run.a1) a = take_run({a, b}).a1;
      }
    }
  }

  BitMatrix left_, seen_;  // equal cells not seen yet; seen cells
  std::vector<Run> runs_;
};

struct Drawing {
  std::string name, label;
  GridId grid;
  bool on;
  Write write;
};

MaybeEdit drawn(DocumentView& view, const Design& design, const Drawing& what, const std::vector<CellMask>& masks) {
  const auto bits = bit_grid_of(what.grid);
  if (!bits) return {};
  const auto drawn_on = [bits = *bits, write = what.write, masks, given = view.drawing.given](const Design& before) {
    Design d = before;
    for (const CellMask& m : masks) d = with_block(std::move(d), bits, m.at.a, m.at.b, m.cells, write);
    if (bits == BitGrid::kDrawdown) d.draft = without_spare(std::move(d.draft), before.draft, given);
    return d;
  };
  Design next = drawn_on(design);
  int64_t missed = 0;
  if (*bits == BitGrid::kDrawdown && may_paint(design, *bits))
    for (const CellMask& m : masks) missed += missed_by(next.draft, m, what.on);
  // With the drawdown leading only the loom limits it: then nothing is drawn rather than a part.
  if (missed > 0 && design.loom.leading == Leading::kDrawdown) next = design;
  const std::string done = with_added(what.name, design.draft, next.draft);
  if (missed > 0 && design.loom.leading != Leading::kDrawdown) view.select.notice = missed_text(done, missed);
  else if (done != what.name) view.select.notice = done;
  Edit edit{what.label, [next = std::make_shared<const Design>(std::move(next))](const Design&) { return *next; }};
  edit.by_painting = *bits == BitGrid::kDrawdown;
  edit.anew = drawn_on;
  edit.why = [bits](const Design& d) { return problem_of(may_paint(d, *bits)); };
  return edit;
}

}  // namespace

bool is_shape(Tool tool) { return tool == Tool::kLine || tool == Tool::kRectangle || tool == Tool::kFilledRectangle; }

Cell constrained(Tool tool, Cell from, Cell to, int columns, int rows) {
  const int da = to.a - from.a, db = to.b - from.b;
  const int wide = std::abs(da), high = std::abs(db);
  // Half way between two directions: the tangent of 22.5 degrees.
  constexpr double kHalfWay = 0.41421356;
  if (tool == Tool::kLine && high <= kHalfWay * wide) return {to.a, from.b};
  if (tool == Tool::kLine && wide <= kHalfWay * high) return {from.a, to.b};
  const int way_a = da < 0 ? -1 : 1, way_b = db < 0 ? -1 : 1;
  const int room_a = way_a > 0 ? columns - 1 - from.a : from.a, room_b = way_b > 0 ? rows - 1 - from.b : from.b;
  const int side = std::min({std::max(wide, high), room_a, room_b});
  return {from.a + way_a * side, from.b + way_b * side};
}

CellMask cells_of_shape(Tool tool, GridId grid, Cell from, Cell to) {
  if (tool != Tool::kLine) return cells_of_rectangle(tool == Tool::kFilledRectangle, from, to);
  const std::vector<Cell> line = cells_of_line(grid, from, to);
  CellMask mask = blank_mask(line.front(), line.back());
  for (const Cell& at : line) mask.cells.set(at.b - mask.at.b, at.a - mask.at.a, true);
  return mask;
}

std::vector<CellMask> cells_of_shapes(const ActiveShape& s, const Mirror& mirror) {
  const std::vector<Cell> from = images_of(mirror, s.grid, s.from), to = images_of(mirror, s.grid, s.to);
  std::vector<CellMask> all;
  for (size_t i = 0; i < from.size(); ++i) all.push_back(cells_of_shape(s.tool, s.grid, from[i], to[i]));
  return all;
}

bool leaves_others(const ActiveShape& s) {
  return s.on && s.tool == Tool::kLine && (by_end(s.grid) || by_pick(s.grid));
}

CellMask region_about(const Draft& draft, const BitMatrix& cells, GridId grid, Cell at) {
  return {{0, 0}, Flood(draft, cells, grid, at).seen()};
}

std::pair<int, int> threads_about(const Threads& t, BarPaint what, int thread) {
  const std::vector<int>& all = what == BarPaint::kColor ? t.color : t.yarn;
  const auto like = [&](int i) { return all[static_cast<size_t>(i)] == all[static_cast<size_t>(thread)]; };
  int first = thread, end = thread + 1;
  while (first > 0 && like(first - 1)) --first;
  while (end < t.size() && like(end)) ++end;
  return {first, end};
}

MaybeEdit finish_shape(DocumentView& view, const Design& design) {
  if (!view.drawing.shape) return {};
  const ActiveShape s = *std::exchange(view.drawing.shape, {});
  const Write write = !s.on ? Write::kErase : leaves_others(s) ? Write::kThreads : Write::kAdd;
  return drawn(view, design, {shape_name(s.tool), shape_label(s.tool), s.grid, s.on, write},
               cells_of_shapes(s, mirror_of(view.drawing, view.select.selected, design.draft)));
}

MaybeEdit fill_region(DocumentView& view, const Design& design, GridId grid, const CellMask& region, bool on) {
  return drawn(view, design, {tr("Fill"), tr("Fill"), grid, on, on ? Write::kAdd : Write::kErase}, {region});
}

Edit fill_bar_edit(const Draft& draft, GridId grid, Cell at, BarPaint what, int index) {
  const bool warp = grid == GridId::kWarpColors;
  const auto [first, end] =
      threads_about(draft.threads(warp ? System::kWarp : System::kWeft), what, warp ? at.a : at.b);
  const auto cell = [warp](int thread) { return warp ? Cell{thread, 0} : Cell{0, thread}; };
  return bar_edit(grid, cell(first), cell(end - 1), what, index);
}

std::string shape_text(const ActiveShape& s) {
  const auto bits = bit_grid_of(s.grid);
  if (!bits) return {};
  const std::string size = size_text(*bits, std::abs(s.to.a - s.from.a) + 1, std::abs(s.to.b - s.from.b) + 1);
  const char* text =
      s.on ? tr("{shape}: {size}    {shift}; Esc cancels") : tr("{shape} cleared: {size}    {shift}; Esc cancels");
  return fill(text, arg("shape", shape_name(s.tool)), arg("size", size),
              arg("shift", s.tool == Tool::kLine ? tr("Shift: straight or at 45 degrees") : tr("Shift: a square")));
}

}  // namespace weftlight::session
