#include "session/editing/paint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/text.h"
#include "design/crossings.h"
#include "design/loom.h"
#include "session/editing/selection_state.h"

namespace weftlight::session {

using base::arg, base::fill, base::mark, base::tr, base::tr_n;
using design::Yarn, design::painted_crossings, design::may_paint, design::with_drawdown_cell, design::with_liftplan,
    design::with_thread_color, design::with_thread_yarn, design::with_threading, design::with_tieup,
    design::with_treadling;
using draft::BitGrid, draft::Selection, draft::ShedControl, draft::System, draft::Threads, draft::Write, draft::clipped,
    draft::without_spare;

namespace {

std::string number(int index) { return std::to_string(index + 1); }

/// "3", "3 and 5", "1, 2 and 4": the set columns of a row, counted from 1.
std::string listed(const std::vector<int>& columns) {
  std::string out;
  for (size_t i = 0; i < columns.size(); ++i) {
    if (i == 0) out = number(columns[i]);
    else
      out = fill(i + 1 == columns.size() ? tr("{first} and {last}") : tr("{first}, {last}"), arg("first", out),
                 arg("last", number(columns[i])));
  }
  return out;
}

std::vector<int> set_columns(const BitMatrix& m, int row) {
  std::vector<int> out;
  for (int col = 0; row >= 0 && row < m.rows() && col < m.cols(); ++col)
    if (m.get(row, col)) out.push_back(col);
  return out;
}

std::string shafts_of_end(const Draft& d, int end) {
  const std::vector<int> on = set_columns(d.threading, end);
  const char* text = on.empty() ? tr("End {end} on no shaft")
                                : tr_n("End {end} on shaft {shafts}", "End {end} on shafts {shafts}",
                                       static_cast<long long>(on.size()));
  return fill(text, arg("end", number(end)), arg("shafts", listed(on)));
}

/// Which shafts or treadles a pick uses.
std::string shed_of_pick(const Draft& d, int pick) {
  const bool plan = d.shed_control == ShedControl::kLiftplan;
  const std::vector<int> used = set_columns(plan ? d.liftplan : d.treadling, pick);
  const auto count = static_cast<long long>(used.size());
  const char* text = nullptr;
  if (!plan)
    text = used.empty() ? tr("Pick {pick}: no treadle")
                        : tr_n("Pick {pick}: treadle {list}", "Pick {pick}: treadles {list}", count);
  else if (d.rising)
    text = used.empty() ? tr("Pick {pick} lifts no shaft")
                        : tr_n("Pick {pick} lifts shaft {list}", "Pick {pick} lifts shafts {list}", count);
  else
    text = used.empty() ? tr("Pick {pick} lowers no shaft")
                        : tr_n("Pick {pick} lowers shaft {list}", "Pick {pick} lowers shafts {list}", count);
  return fill(text, arg("pick", number(pick)), arg("list", listed(used)));
}

std::string thread_facts(const Design& design, System system, int thread) {
  const Threads& t = design.draft.threads(system);
  if (thread >= t.size()) return {};
  const Yarn& yarn = design.yarns[static_cast<size_t>(t.yarn[static_cast<size_t>(thread)])];
  const float given = t.thickness_mm[static_cast<size_t>(thread)];
  const char* text = system == System::kWarp ? tr("End {thread}: colour {color}, {yarn}, {thickness:.2f} mm")
                                             : tr("Pick {thread}: colour {color}, {yarn}, {thickness:.2f} mm");
  return fill(text, arg("thread", number(thread)), arg("color", number(t.color[static_cast<size_t>(thread)])),
              arg("yarn", yarn.name), arg("thickness", given < 0 ? yarn.diameter_mm : given));
}

std::vector<Cell> with_images(const std::vector<Cell>& cells, GridId grid, const Mirror& mirror) {
  std::vector<Cell> all;
  for (const Cell& at : cells)
    for (const Cell& image : images_of(mirror, grid, at)) all.push_back(image);
  return all;
}

/// Paints all the crossings, or none if the loom cannot weave them.
base::Result<Design> painted_cells(const Design& design, const std::vector<Cell>& all, bool on, LoomSize given) {
  const auto [left, right] = std::ranges::minmax(all, {}, &Cell::a);
  const auto [top, bottom] = std::ranges::minmax(all, {}, &Cell::b);
  const Selection s = clipped({BitGrid::kDrawdown, left.a, right.a + 1, top.b, bottom.b + 1}, design.draft);
  if (s.empty()) return design;
  BitMatrix cells(s.rows(), s.columns());
  for (const Cell& at : all)
    if (holds(s, BitGrid::kDrawdown, at)) cells.set(at.b - s.b0, at.a - s.a0, true);
  base::Result<Design> painted = painted_crossings(design, s, s.a0, s.b0, cells, on ? Write::kAdd : Write::kErase);
  if (painted) painted->draft = without_spare(std::move(painted->draft), design.draft, given);
  return painted;
}

/// Paints all crossings of the stroke on the design before it. Crossings that the loom cannot weave are left out: then
/// `step`, for the last crossings alone, gives the reason, or its result becomes the new start of the stroke.
Edit crossings_edit(Stroke& s, const Design& design, LoomSize given, const std::vector<Cell>& cells, Edit step) {
  if (!s.reached || *s.reached != design) {
    s.base = s.reached = std::make_shared<const Design>(design);
    s.cells.clear();
  }
  std::vector<Cell> all = s.cells;
  all.insert(all.end(), cells.begin(), cells.end());
  base::Result<Design> painted = painted_cells(*s.base, all, s.on, given);
  if (!painted) return step;
  s.cells = std::move(all);
  s.reached = std::make_shared<const Design>(std::move(*painted));
  step.anew = std::exchange(step.apply, [next = s.reached](const Design&) { return *next; });
  return step;
}

}  // namespace

std::vector<Cell> line_of_cells(Cell from, Cell to) {
  const int da = to.a - from.a, db = to.b - from.b;
  const int steps = std::max(std::abs(da), std::abs(db));
  std::vector<Cell> line;
  line.reserve(static_cast<size_t>(steps) + 1);
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0 : static_cast<double>(i) / steps;
    line.push_back({from.a + static_cast<int>(std::lround(t * da)), from.b + static_cast<int>(std::lround(t * db))});
  }
  return line;
}

bool is_on(const Draft& d, const BitMatrix& cells, GridId grid, Cell at) {
  const auto bit = [](const BitMatrix& m, int row, int col) {
    return row >= 0 && row < m.rows() && col >= 0 && col < m.cols() && m.get(row, col);
  };
  switch (grid) {
    case GridId::kThreading:
      return bit(d.threading, at.a, at.b);
    case GridId::kTieup:
      return bit(d.tieup, at.a, at.b);
    case GridId::kTreadling:
      return bit(d.treadling, at.b, at.a);
    case GridId::kLiftplan:
      return bit(d.liftplan, at.b, at.a);
    case GridId::kDrawdown:
      return bit(cells, at.b, at.a);
    default:
      return false;
  }
}

Design with_cell(Design design, GridId grid, Cell at, bool on, bool only) {
  switch (grid) {
    case GridId::kThreading:
      return with_threading(std::move(design), at.a, at.b, on, only);
    case GridId::kTieup:
      return with_tieup(std::move(design), at.a, at.b, on);
    case GridId::kTreadling:
      return with_treadling(std::move(design), at.b, at.a, on, only);
    case GridId::kLiftplan:
      return with_liftplan(std::move(design), at.b, at.a, on);
    case GridId::kDrawdown:
      return with_drawdown_cell(std::move(design), at.a, at.b, on);
    default:
      return design;
  }
}

Edit paint_edit(GridId grid, Cell from, Cell to, bool on, bool only, const Mirror& mirror, LoomSize given) {
  constexpr const char* kLabels[] = {"",
                                     mark("Paint threading"),
                                     mark("Paint tie-up"),
                                     mark("Paint treadling"),
                                     mark("Paint liftplan"),
                                     mark("Paint drawdown"),
                                     "",
                                     ""};
  const bool crossings = grid == GridId::kDrawdown;
  Edit edit{tr(kLabels[static_cast<int>(grid)]),
            [=, all = with_images(line_of_cells(from, to), grid, mirror)](Design design) {
              if (crossings) return painted_cells(design, all, on, given).value_or(design);
              for (const Cell& at : all) design = with_cell(std::move(design), grid, at, on, only);
              return design;
            }};
  edit.by_painting = crossings;
  edit.why = [=, all = with_images(line_of_cells(from, to), grid, mirror)](const Design& design) {
    constexpr BitGrid kGrids[] = {BitGrid::kThreading, BitGrid::kThreading, BitGrid::kTieup,
                                  BitGrid::kTreadling, BitGrid::kLiftplan,  BitGrid::kDrawdown};
    if (crossings) return problem_of(painted_cells(design, all, on, given));
    if (grid == GridId::kNone || grid > GridId::kDrawdown) return std::string();
    return problem_of(may_paint(design, kGrids[static_cast<int>(grid)]));
  };
  return edit;
}

MaybeEdit begin_stroke(DocumentView& v, const Design& design, GridId grid, Cell at, bool on, bool only) {
  v.drawing.stroke = {grid, on, {}, {}, {}, {}};
  return go_on_with_stroke(v, design, at, only);
}

MaybeEdit go_on_with_stroke(DocumentView& v, const Design& design, Cell to, bool only) {
  Stroke& s = v.drawing.stroke;
  if (s.grid == GridId::kNone || !to.valid() || to == s.last) return {};
  const Cell from = s.last.valid() ? s.last : to;
  s.last = to;
  const Mirror mirror = mirror_of(v.drawing, v.select.selected, design.draft);
  if (s.grid == GridId::kWarpColors || s.grid == GridId::kWeftColors)
    return bar_edit(s.grid, from, to, v.drawing.bar_paint,
                    v.drawing.bar_paint == BarPaint::kColor ? v.drawing.color : v.drawing.yarn, mirror);
  Edit step = paint_edit(s.grid, from, to, s.on, only, mirror, v.drawing.given);
  if (s.grid != GridId::kDrawdown) return step;
  // The start cell was already painted, rejected or undone.
  std::vector<Cell> line = line_of_cells(from, to);
  if (line.size() > 1) line.erase(line.begin());
  return crossings_edit(s, design, v.drawing.given, with_images(line, s.grid, mirror), std::move(step));
}

Edit bar_edit(GridId grid, Cell from, Cell to, BarPaint what, int index, const Mirror& mirror) {
  const System system = grid == GridId::kWarpColors ? System::kWarp : System::kWeft;
  const std::string label = what == BarPaint::kColor ? tr("Colour threads") : tr("Set yarn of threads");
  return {label, [=](Design design) {
            for (const Cell& at : line_of_cells(from, to))
              for (const Cell& image : images_of(mirror, grid, at)) {
                const int thread = system == System::kWarp ? image.a : image.b;
                design = what == BarPaint::kColor ? with_thread_color(std::move(design), system, thread, index)
                                                  : with_thread_yarn(std::move(design), system, thread, index);
              }
            return design;
          }};
}

std::string describe(const Design& design, const BitMatrix& cells, GridId grid, Cell at) {
  if (!at.valid()) return {};
  const Draft& d = design.draft;
  switch (grid) {
    case GridId::kThreading:
      return shafts_of_end(d, at.a);
    case GridId::kTreadling:
    case GridId::kLiftplan:
      return shed_of_pick(d, at.b);
    case GridId::kTieup:
      return fill(is_on(d, cells, grid, at) ? tr("Treadle {treadle} tied to shaft {shaft}")
                                            : tr("Treadle {treadle} not tied to shaft {shaft}"),
                  arg("treadle", number(at.a)), arg("shaft", number(at.b)));
    case GridId::kDrawdown:
      return fill(is_on(d, cells, grid, at) ? tr("End {end} over pick {pick}") : tr("End {end} under pick {pick}"),
                  arg("end", number(at.a)), arg("pick", number(at.b))) +
             "    " + shafts_of_end(d, at.a) + "    " + shed_of_pick(d, at.b);
    case GridId::kWarpColors:
      return thread_facts(design, System::kWarp, at.a);
    case GridId::kWeftColors:
      return thread_facts(design, System::kWeft, at.b);
    case GridId::kNone:
      break;
  }
  return {};
}

}  // namespace weftlight::session
