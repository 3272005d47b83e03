#include "session/editing/selection_state.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/crossings.h"
#include "design/loom.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using design::may_paint, design::painted_crossings, design::with_block, design::with_moved;
using draft::ShedControl, draft::Write, draft::cells_of, draft::clipped, draft::columns_of, draft::covered,
    draft::missed_cells, draft::rows_of, draft::turned_for;

namespace {

constexpr uint64_t kMoveStrokes = uint64_t{1} << 63;  // distinct from mouse strokes

Design moved_from(const MarksOnTheMove& m, int a, int b) {
  const bool at_home = a == m.from.a0 && b == m.from.b0;
  return at_home ? *m.base : with_moved(*m.base, m.from, a, b, m.copy);
}

/// True while the design is the result of the move, with no edit after it.
bool goes_on(const SelectState& s, const Design& design) {
  return s.move && moved_from(*s.move, s.selected.a0, s.selected.b0) == design;
}

/// True, with the reason, if the grid is locked.
bool is_refused(SelectState& s, const Design& design, BitGrid grid) {
  const auto open = may_paint(design, grid);
  if (!open) s.refusal = problem_of(open);
  return !open;
}

/// Why the loom cannot weave a block in the drawdown; empty if it can.
std::string why_unwoven(const Design& design, const ActiveBlock& held, const BitMatrix& cells, Write write) {
  if (held.grid != BitGrid::kDrawdown) return {};
  const Selection place = covered(design.draft, held.grid, held.at.a, held.at.b, cells);
  return place.empty() ? "" : problem_of(painted_crossings(design, place, held.at.a, held.at.b, cells, write));
}

/// "3 ends", for columns of a grid.
std::string columns_text(BitGrid grid, int count) {
  const char* text = nullptr;
  switch (grid) {
    case BitGrid::kThreading:
    case BitGrid::kDrawdown:
      text = tr_n("{count} end", "{count} ends", count);
      break;
    case BitGrid::kTieup:
    case BitGrid::kTreadling:
      text = tr_n("{count} treadle", "{count} treadles", count);
      break;
    case BitGrid::kLiftplan:
      text = tr_n("{count} shaft", "{count} shafts", count);
      break;
  }
  return fill(text, arg("count", count));
}

bool rows_are_shafts(BitGrid grid) { return grid == BitGrid::kThreading || grid == BitGrid::kTieup; }

std::string rows_text(BitGrid grid, int count) {
  return fill(rows_are_shafts(grid) ? tr_n("{count} shaft", "{count} shafts", count)
                                    : tr_n("{count} pick", "{count} picks", count),
              arg("count", count));
}

/// "end 3", "ends 3-10"; the range is half-open and counts from 0.
std::string column_range(BitGrid grid, int first, int end) {
  const int count = end - first;
  const char* text = nullptr;
  switch (grid) {
    case BitGrid::kThreading:
    case BitGrid::kDrawdown:
      text = tr_n("end {first}", "ends {first}\xE2\x80\x93{last}", count);
      break;
    case BitGrid::kTieup:
    case BitGrid::kTreadling:
      text = tr_n("treadle {first}", "treadles {first}\xE2\x80\x93{last}", count);
      break;
    case BitGrid::kLiftplan:
      text = tr_n("shaft {first}", "shafts {first}\xE2\x80\x93{last}", count);
      break;
  }
  return fill(text, arg("first", first + 1), arg("last", end));
}

std::string row_range(BitGrid grid, int first, int end) {
  return fill(rows_are_shafts(grid) ? tr_n("shaft {first}", "shafts {first}\xE2\x80\x93{last}", end - first)
                                    : tr_n("pick {first}", "picks {first}\xE2\x80\x93{last}", end - first),
              arg("first", first + 1), arg("last", end));
}

/// "Pasted 4 ends x 2 shafts; 1 shaft did not fit".
std::string pasted_text(const Selection& place, const Selection& within) {
  const int fit_columns = std::max(0, within.columns()), fit_rows = std::max(0, within.rows());
  std::string done = fill(tr("Pasted {size}"), arg("size", size_text(place.grid, fit_columns, fit_rows)));
  const int columns = place.columns() - fit_columns, rows = place.rows() - fit_rows;
  if (columns == 0 && rows == 0) return done;
  const std::string a = columns_text(place.grid, columns), b = rows_text(place.grid, rows);
  const std::string rest = rows == 0      ? a
                           : columns == 0 ? b
                                          : fill(tr("{columns} and {rows}"), arg("columns", a), arg("rows", b));
  return fill(tr("{pasted}; {rest} did not fit"), arg("pasted", done), arg("rest", rest));
}

std::string held_text(const ActiveBlock& held) {
  const BitMatrix cells = turned_for(held.block, held.grid);
  return fill(tr("Paste {size} from {column}, {row}: click or Enter places it, Shift+click places it and keeps it, Esc "
                 "cancels"),
              arg("size", size_text(held.grid, cells.cols(), cells.rows())),
              arg("column", column_range(held.grid, held.at.a, held.at.a + 1)),
              arg("row", row_range(held.grid, held.at.b, held.at.b + 1)));
}

}  // namespace

std::optional<BitGrid> bit_grid_of(GridId grid) {
  switch (grid) {
    case GridId::kThreading:
      return BitGrid::kThreading;
    case GridId::kTieup:
      return BitGrid::kTieup;
    case GridId::kTreadling:
      return BitGrid::kTreadling;
    case GridId::kLiftplan:
      return BitGrid::kLiftplan;
    case GridId::kDrawdown:
      return BitGrid::kDrawdown;
    default:
      return {};
  }
}

GridId grid_id_of(BitGrid grid) {
  constexpr GridId kIds[] = {GridId::kThreading, GridId::kTieup, GridId::kTreadling, GridId::kLiftplan,
                             GridId::kDrawdown};
  return kIds[static_cast<int>(grid)];
}

bool is_shown(const Draft& d, BitGrid grid) {
  if (grid == BitGrid::kTieup || grid == BitGrid::kTreadling) return d.shed_control == ShedControl::kTreadling;
  return grid != BitGrid::kLiftplan || d.shed_control == ShedControl::kLiftplan;
}

Selection selection_between(BitGrid grid, Cell one, Cell other) {
  return {grid, std::min(one.a, other.a), std::max(one.a, other.a) + 1, std::min(one.b, other.b),
          std::max(one.b, other.b) + 1};
}

bool holds(const Selection& s, BitGrid grid, Cell at) {
  return s.grid == grid && at.a >= s.a0 && at.a < s.a1 && at.b >= s.b0 && at.b < s.b1;
}

Cell screen_step(BitGrid grid, const Settings& settings, int dx, int dy) {
  const bool ends = grid == BitGrid::kThreading || grid == BitGrid::kDrawdown;
  const bool shafts_up = !settings.threading_below && (grid == BitGrid::kThreading || grid == BitGrid::kTieup);
  const bool picks_up = settings.pick1_bottom && grid != BitGrid::kThreading && grid != BitGrid::kTieup;
  return {ends && settings.end1_right ? -dx : dx, shafts_up || picks_up ? -dy : dy};
}

void select_cells(SelectState& state, const Selection& selection) {
  state.selected = selection;
  state.move.reset();
}

void follow_design(SelectState& s, const Design& design, uint64_t revision) {
  if (s.held && !is_shown(design.draft, s.held->grid)) s.held->grid = BitGrid::kThreading;
  if (std::exchange(s.revision, revision) == revision) return;
  if (s.move && *s.move->base == design) select_cells(s, s.move->from);
  if (s.selected.empty()) return;
  const Selection now = is_shown(design.draft, s.selected.grid) ? clipped(s.selected, design.draft) : Selection{};
  if (now != s.selected) select_cells(s, now);
}

bool escape(SelectState& s) {
  if (s.held) {
    s.held.reset();
    return true;
  }
  const bool selected = !s.selected.empty();
  select_cells(s, {});
  s.drag = SelectDrag::kNone;
  return selected;
}

Edit unless_locked(BitGrid grid, Edit edit) {
  edit.why = [grid](const Design& d) { return problem_of(may_paint(d, grid)); };
  return edit;
}

MaybeEdit move_selection(SelectState& s, const Design& design, int a, int b, bool copy) {
  if (s.selected.empty()) return {};
  const Selection& at = s.selected;
  if (is_refused(s, design, at.grid)) return {};
  a = std::clamp(a, 0, columns_of(design.draft, at.grid) - at.columns());
  b = std::clamp(b, 0, rows_of(design.draft, at.grid) - at.rows());
  if (copy || !goes_on(s, design))
    s.move = MarksOnTheMove{std::make_shared<const Design>(design), at, copy, kMoveStrokes | ++s.moves};
  if (a == at.a0 && b == at.b0) return {};
  s.selected = {at.grid, a, a + at.columns(), b, b + at.rows()};
  return Edit{s.move->copy ? tr("Copy selection") : tr("Move selection"),
              [move = *s.move, a, b](const Design&) { return moved_from(move, a, b); }, s.move->stroke};
}

std::string missed_by_move(const SelectState& s, const Design& design) {
  if (s.selected.grid != BitGrid::kDrawdown || !goes_on(s, design)) return {};
  const Selection &from = s.move->from, &to = s.selected;
  if (from == to) return {};
  int64_t missed = missed_crossings(design.draft, to.grid, to.a0, to.b0, cells_of(s.move->base->draft, from));
  const BitMatrix left = cells_of(design.draft, from);
  for (int b = from.b0; b < from.b1 && !s.move->copy; ++b)
    for (int a = from.a0; a < from.a1; ++a)
      if (!holds(to, to.grid, {a, b})) missed += left.get(b - from.b0, a - from.a0);
  return missed > 0 ? missed_text(s.move->copy ? tr("Copy selection") : tr("Move selection"), missed) : "";
}

void end_drag(DocumentView& view, const Design& design) {
  const bool moved = std::exchange(view.select.drag, SelectDrag::kNone) == SelectDrag::kMove;
  if (moved && !view.rejected_edit) view.select.refusal = missed_by_move(view.select, design);
}

MaybeEdit cancel_drag(SelectState& s, const Design& design) {
  if (std::exchange(s.drag, SelectDrag::kNone) != SelectDrag::kMove || !goes_on(s, design)) return {};
  const Selection home = s.move->from;
  return move_selection(s, design, home.a0, home.b0, false);
}

void extend_selection(SelectState& s, const Draft& d, int da, int db) {
  if (s.selected.empty()) return;
  const Selection& now = s.selected;
  // The far corner is opposite to the one where the selection began.
  const Cell near = holds(now, now.grid, s.anchor) ? s.anchor : Cell{now.a0, now.b0};
  const Cell far{near.a == now.a0 ? now.a1 - 1 : now.a0, near.b == now.b0 ? now.b1 - 1 : now.b0};
  const Cell to{std::clamp(far.a + da, 0, columns_of(d, now.grid) - 1),
                std::clamp(far.b + db, 0, rows_of(d, now.grid) - 1)};
  s.anchor = near;
  select_cells(s, selection_between(now.grid, near, to));
}

void hold_block(SelectState& s, const Draft& d, CellBlock block, bool add) {
  BitGrid grid = block.from;
  if (!is_shown(d, grid)) grid = s.selected.empty() ? BitGrid::kDrawdown : s.selected.grid;
  Cell at{0, 0};
  if (s.selected.grid == grid && !s.selected.empty()) at = {s.selected.a0, s.selected.b0};
  s.held = ActiveBlock{std::move(block), grid, at, add};
  s.drag = SelectDrag::kNone;
  s.tool = Tool::kSelect;
}

void hold_block_over(SelectState& s, BitGrid grid, Cell at) {
  if (!s.held || !at.valid()) return;
  s.held->grid = grid;
  s.held->at = at;
}

void turn_held_block(SelectState& s, BitMatrix (*turn)(const BitMatrix&)) {
  if (s.held) s.held->block = {s.held->grid, turn(turned_for(s.held->block, s.held->grid))};
}

MaybeEdit drop_block(SelectState& s, const Design& design, bool keep) {
  if (!s.held) return {};
  const ActiveBlock held = *s.held;
  if (is_refused(s, design, held.grid)) return {};
  if (!keep) s.held.reset();
  const BitMatrix cells = turned_for(held.block, held.grid);
  const Selection place{held.grid, held.at.a, held.at.a + cells.cols(), held.at.b, held.at.b + cells.rows()};
  const Write write = held.add ? Write::kAdd : Write::kThreads;
  Design next = with_block(design, held.grid, held.at.a, held.at.b, cells, write);
  s.notice = with_added(pasted_text(place, clipped(place, next.draft)), design.draft, next.draft);
  const int64_t missed = held.add ? 0 : missed_crossings(next.draft, held.grid, held.at.a, held.at.b, cells);
  if (missed > 0) s.notice = missed_text(s.notice, missed);
  if (std::string why = next.draft == design.draft ? why_unwoven(design, held, cells, write) : ""; !why.empty()) {
    s.refusal = std::move(why);
    s.notice.clear();
  }
  select_cells(s, clipped(place, next.draft));
  s.anchor = held.at;
  Edit edit{tr("Paste"), [next = std::make_shared<const Design>(std::move(next))](const Design&) { return *next; }};
  edit.anew = [held, cells, write](Design d) {
    return with_block(std::move(d), held.grid, held.at.a, held.at.b, cells, write);
  };
  return edit;
}

int64_t missed_crossings(const Draft& d, BitGrid grid, int a, int b, const BitMatrix& cells) {
  return grid == BitGrid::kDrawdown ? missed_cells(d, grid, a, b, cells) : 0;
}

std::string missed_text(const std::string& done, int64_t missed) {
  const std::string problem =
      fill(tr_n("{count} crossing could not follow, because ends on the same shafts rise together",
                "{count} crossings could not follow, because ends on the same shafts rise together", missed),
           arg("count", missed));
  return fill(tr("{edit}: {problem}"), arg("edit", done), arg("problem", problem));
}

std::string with_added(std::string done, const Draft& before, const Draft& after) {
  const int shafts = after.shafts - before.shafts, treadles = after.treadles - before.treadles;
  if (shafts > 0)
    done = fill(tr_n("{edit}; {count} shaft added", "{edit}; {count} shafts added", shafts), arg("edit", done),
                arg("count", shafts));
  if (treadles > 0 && after.shed_control == ShedControl::kTreadling)
    done = fill(tr_n("{edit}; {count} treadle added", "{edit}; {count} treadles added", treadles), arg("edit", done),
                arg("count", treadles));
  return done;
}

std::string size_text(BitGrid grid, int columns, int rows) {
  return columns_text(grid, columns) + " \xC3\x97 " + rows_text(grid, rows);
}

std::string selection_text(const SelectState& s) {
  if (s.held) return held_text(*s.held);
  if (s.selected.empty()) return {};
  const Selection& at = s.selected;
  std::string size =
      fill(tr("{size}: {columns}, {rows}"), arg("size", size_text(at.grid, at.columns(), at.rows())),
           arg("columns", column_range(at.grid, at.a0, at.a1)), arg("rows", row_range(at.grid, at.b0, at.b1)));
  if (s.drag == SelectDrag::kBand) return size;
  if (s.drag == SelectDrag::kMove)
    return fill(s.move && s.move->copy ? tr("Copy {size}") : tr("Move {size}"), arg("size", size));
  return fill(tr("{size}    drag to move, Ctrl+drag to copy, right-click for more"), arg("size", size));
}

}  // namespace weftlight::session
