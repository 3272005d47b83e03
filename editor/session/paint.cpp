#include "session/paint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "draft/crossings.h"
#include "session/selection_state.h"

namespace weftlight::session {
namespace {

std::string number(int index) { return std::to_string(index + 1); }

/// "3", "3 and 5", "1, 2 and 4": the set columns of a row, counted from 1.
std::string listed(const BitMatrix& m, int row) {
  std::vector<std::string> names;
  for (int col = 0; row >= 0 && row < m.rows() && col < m.cols(); ++col)
    if (m.get(row, col)) names.push_back(number(col));
  std::string out;
  for (size_t i = 0; i < names.size(); ++i) out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return out;
}

std::string plural(const std::string& list, const char* one) {
  return std::string(one) + (list.find_first_of(",a") == std::string::npos ? " " : "s ") + list;
}

std::string shafts_of_end(const Draft& d, int end) {
  const std::string list = listed(d.threading, end);
  return "End " + number(end) + (list.empty() ? " on no shaft" : " on " + plural(list, "shaft"));
}

std::string lift_of_pick(const Draft& d, int pick) {
  const bool plan = d.drive == ShedControl::kLiftplan;
  const std::string list = listed(plan ? d.liftplan : d.treadling, pick);
  const char* verb = !plan ? "" : d.rising ? "lifts " : "lowers ";
  const char* nothing = plan ? (d.rising ? "lifts no shaft" : "lowers no shaft") : "no treadle";
  return "Pick " + number(pick) + (plan ? " " : ": ") +
         (list.empty() ? nothing : verb + plural(list, plan ? "shaft" : "treadle"));
}

std::string thread_facts(const Design& design, System system, int thread) {
  const Threads& t = design.draft.threads(system);
  if (thread >= t.size()) return {};
  const Yarn& yarn = design.yarns[static_cast<size_t>(t.yarn[static_cast<size_t>(thread)])];
  const float given = t.thickness_mm[static_cast<size_t>(thread)];
  char size[32];
  std::snprintf(size, sizeof size, "%.2f mm", static_cast<double>(given < 0 ? yarn.diameter_mm : given));
  return std::string(system == System::kWarp ? "End " : "Pick ") + number(thread) + ": colour " +
         number(t.color[static_cast<size_t>(thread)]) + ", " + yarn.name + ", " + size;
}

/// The crossings of a line and its images, all of them or, where the loom cannot weave them, none.
Painted painted_line(Design design, Cell from, Cell to, bool on, const Mirror& mirror) {
  std::vector<Cell> all;
  for (const Cell& at : line_of_cells(from, to))
    for (const Cell& image : images_of(mirror, GridId::kDrawdown, at)) all.push_back(image);
  const auto [left, right] = std::ranges::minmax(all, {}, &Cell::a);
  const auto [top, bottom] = std::ranges::minmax(all, {}, &Cell::b);
  const Selection s = clipped({BitGrid::kDrawdown, left.a, right.a + 1, top.b, bottom.b + 1}, design.draft);
  if (s.empty()) return {std::move(design), {}};
  BitMatrix cells(s.rows(), s.columns());
  for (const Cell& at : all)
    if (holds(s, BitGrid::kDrawdown, at)) cells.set(at.b - s.b0, at.a - s.a0, true);
  return painted_crossings(std::move(design), s, s.a0, s.b0, cells, on ? Write::kAdd : Write::kErase);
}

}  // namespace

const char* grid_name(GridId grid) {
  constexpr const char* kNames[] = {"",         "threading", "tieup",       "treadling",
                                    "liftplan", "drawdown",  "warp_colors", "weft_colors"};
  return kNames[static_cast<int>(grid)];
}

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

Edit paint_edit(GridId grid, Cell from, Cell to, bool on, bool only, const Mirror& mirror) {
  constexpr const char* kSpoken[] = {"", "threading", "tie-up", "treadling", "liftplan", "drawdown", "", ""};
  Edit edit{std::string("Paint ") + kSpoken[static_cast<int>(grid)], [=](Design design) {
              if (grid == GridId::kDrawdown) return painted_line(std::move(design), from, to, on, mirror).design;
              for (const Cell& at : line_of_cells(from, to))
                for (const Cell& image : images_of(mirror, grid, at))
                  design = with_cell(std::move(design), grid, image, on, only);
              return design;
            }};
  edit.why = [=](const Design& design) {
    constexpr BitGrid kGrids[] = {BitGrid::kThreading, BitGrid::kThreading, BitGrid::kTieup,
                                  BitGrid::kTreadling, BitGrid::kLiftplan,  BitGrid::kDrawdown};
    if (grid == GridId::kDrawdown) return painted_line(design, from, to, on, mirror).why;
    if (grid == GridId::kNone || grid > GridId::kDrawdown) return std::string();
    return why_locked(design, kGrids[static_cast<int>(grid)]);
  };
  return edit;
}

Edit bar_edit(GridId grid, Cell from, Cell to, BarPaint what, int index, const Mirror& mirror) {
  const System system = grid == GridId::kWarpColors ? System::kWarp : System::kWeft;
  const std::string label = what == BarPaint::kColor ? "Colour threads" : "Choose yarn of threads";
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
      return lift_of_pick(d, at.b);
    case GridId::kTieup:
      return "Treadle " + number(at.a) + (is_on(d, cells, grid, at) ? " tied to shaft " : " not tied to shaft ") +
             number(at.b);
    case GridId::kDrawdown:
      return "End " + number(at.a) + (is_on(d, cells, grid, at) ? " over pick " : " under pick ") + number(at.b) +
             "    " + shafts_of_end(d, at.a) + "    " + lift_of_pick(d, at.b);
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
