#include "session/editing/typing.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/loom.h"
#include "session/editing/mirror.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr;
using design::may_paint;
using draft::BitGrid, draft::Selection, draft::columns_of, draft::drawdown, draft::kMaxThreads, draft::rows_of;

namespace {

bool along_ends(GridId grid) { return grid == GridId::kThreading || grid == GridId::kTieup; }

/// True if each end or pick has one shaft or treadle.
bool holds_one(GridId grid) { return grid == GridId::kThreading || grid == GridId::kTreadling; }

struct Size {
  int columns, rows;
};
Size size_of(const Draft& d, GridId grid) {
  const BitGrid bits = *bit_grid_of(grid);
  return {columns_of(d, bits), rows_of(d, bits)};
}

/// The largest number that can be typed.
int most(const Draft& d, GridId grid) {
  if (grid == GridId::kDrawdown) return 0;
  const Size size = size_of(d, grid);
  return along_ends(grid) ? size.rows : size.columns;
}

/// The cell of a number on the thread of the cursor.
Cell numbered(const TypeCursor& c, int number) {
  return along_ends(c.grid) ? Cell{c.at.a, number - 1} : Cell{number - 1, c.at.b};
}

void go(DocumentView& v, const Draft& d, int da, int db) {
  TypeCursor& c = v.drawing.cursor;
  const Size size = size_of(d, c.grid);
  c.at = {std::clamp(c.at.a + da, 0, std::max(0, size.columns - 1)),
          std::clamp(c.at.b + db, 0, std::max(0, size.rows - 1))};
  bring_into_sight(v.draft, c.grid, c.at);
}

void go_on(DocumentView& v, const Draft& d) {
  const bool columns = along_ends(v.drawing.cursor.grid);
  go(v, d, columns ? 1 : 0, columns ? 0 : 1);
}

Edit number_edit(const TypeCursor& c, const Design& design, int number) {
  const Cell at = numbered(c, number);
  const bool on = holds_one(c.grid) || !is_on(design.draft, {}, c.grid, at);
  const std::string label = fill(c.grid == GridId::kTreadling ? tr("Type treadle {number}") : tr("Type shaft {number}"),
                                 arg("number", number));
  return unless_locked(*bit_grid_of(c.grid), {label, [grid = c.grid, at, on](Design d) {
                                                return with_cell(std::move(d), grid, at, on, true);
                                              }});
}

/// Clears all marks of the thread (or treadle) at the cursor.
Edit clear_edit(const TypeCursor& c, const Draft& d) {
  const int cells = most(d, c.grid);
  return unless_locked(*bit_grid_of(c.grid), {tr("Clear typed"), [c, cells](Design design) {
                                                for (int i = 1; i <= cells; ++i)
                                                  if (is_on(design.draft, {}, c.grid, numbered(c, i)))
                                                    design = with_cell(std::move(design), c.grid, numbered(c, i), false,
                                                                       false);
                                                return design;
                                              }});
}

}  // namespace

MaybeEdit accept_number(DocumentView& v, const Design& design) {
  const int number = std::exchange(v.drawing.cursor.typed, 0);
  if (number == 0) return {};
  if (const auto open = may_paint(design, *bit_grid_of(v.drawing.cursor.grid)); !open) {
    v.select.refusal = problem_of(open);
    return {};
  }
  if (holds_one(v.drawing.cursor.grid)) v.drawing.cursor.at = numbered(v.drawing.cursor, number);
  return number_edit(v.drawing.cursor, design, number);
}

namespace {

/// The number is complete.
MaybeEdit finish_number(DocumentView& v, const Design& design) {
  MaybeEdit edit = accept_number(v, design);
  if (edit && holds_one(v.drawing.cursor.grid)) go_on(v, design.draft);
  v.drawing.cursor.fresh = edit && holds_one(v.drawing.cursor.grid);
  return edit;
}

void add_to(std::vector<Edit>& all, MaybeEdit edit) {
  if (edit) all.push_back(std::move(*edit));
}

std::string why_no_number(GridId grid, int number, int limit) {
  if (limit == 0) return tr("The drawdown has no numbers to type; Space toggles the cell");
  return fill(grid == GridId::kTreadling ? tr("There is no treadle {number}: the last is {last}")
                                         : tr("There is no shaft {number}: the last is {last}"),
              arg("number", number), arg("last", limit));
}

std::vector<Edit> type_digit(DocumentView& v, const Design& design, int digit, double now_s) {
  TypeCursor& c = v.drawing.cursor;
  const int limit = most(design.draft, c.grid);
  std::vector<Edit> edits;
  if (c.typed > 0 && c.typed * 10 + digit > limit) add_to(edits, finish_number(v, design));
  const int number = c.typed * 10 + digit;
  if (number == 0 && limit > 0) {
    edits.push_back(clear_edit(c, design.draft));
    go_on(v, design.draft);
  } else if (number == 0 || number > limit) {
    v.select.refusal = why_no_number(c.grid, number, limit);
  } else {
    c.typed = number;
    c.until_s = now_s + kDigitWaitS;
    if (number * 10 > limit) add_to(edits, finish_number(v, design));
  }
  return edits;
}

MaybeEdit turn_cell(DocumentView& v, const Design& design) {
  const TypeCursor& c = v.drawing.cursor;
  const BitMatrix cells = c.grid == GridId::kDrawdown ? drawdown(design.draft) : BitMatrix();
  return paint_edit(c.grid, c.at, c.at, !is_on(design.draft, cells, c.grid, c.at), true, {}, v.drawing.given);
}

/// Moves to the next shown grid, on the same thread if both have it.
void next_grid(DocumentView& v, const Draft& d) {
  constexpr GridId kRound[] = {GridId::kThreading, GridId::kTieup, GridId::kTreadling, GridId::kLiftplan,
                               GridId::kDrawdown};
  const auto* at = std::find(std::begin(kRound), std::end(kRound), v.drawing.cursor.grid);
  do at = at + 1 >= std::end(kRound) ? std::begin(kRound) : at + 1;
  while (!is_shown(d, *bit_grid_of(*at)));
  put_cursor(v.drawing.cursor, *at, v.drawing.cursor.at);
  follow_draft(v.drawing.cursor, d);
  go(v, d, 0, 0);
}

struct Way {
  const char* key;
  int dx, dy;
};
constexpr Way kWays[] = {{"Left", -1, 0}, {"Right", 1, 0}, {"Up", 0, -1}, {"Down", 0, 1}};

/// Moves the cursor if the key is a cursor key; true if it is.
bool move_by(DocumentView& v, const Draft& d, const Settings& settings, const std::string& key) {
  const TypeCursor& c = v.drawing.cursor;
  for (const Way& way : kWays)
    if (key == way.key) {
      const Cell by = screen_step(*bit_grid_of(c.grid), settings, way.dx, way.dy);
      go(v, d, by.a, by.b);
      return true;
    }
  if (key != "Home" && key != "End") return false;
  const int far = key == "Home" ? -kMaxThreads : kMaxThreads;
  go(v, d, along_ends(c.grid) || c.grid == GridId::kDrawdown ? far : 0, along_ends(c.grid) ? 0 : far);
  return true;
}

}  // namespace

TypedKey type_key(DocumentView& v, const Design& design, const Settings& settings, const std::string& key,
                  double now_s) {
  const Draft& d = design.draft;
  const bool waiting = v.drawing.cursor.typed > 0, fresh = std::exchange(v.drawing.cursor.fresh, false);
  const bool parts = key == "Enter" || key == "," || key == "Space";
  TypedKey typed{true};
  if (key.size() == 1 && key[0] >= '0' && key[0] <= '9') {
    typed.edits = type_digit(v, design, key[0] - '0', now_s);
  } else if (key == "Escape") {
    if (!waiting) v.select.tool = Tool::kPaint;
    v.drawing.cursor.typed = 0;
  } else if (parts && waiting) {
    add_to(typed.edits, finish_number(v, design));
    v.drawing.cursor.fresh = false;
  } else if (parts && !fresh) {
    if (key == "Space") add_to(typed.edits, turn_cell(v, design));
    else go_on(v, d);
  } else if (key == "Delete") {
    if (std::exchange(v.drawing.cursor.typed, 0) == 0) typed.edits.push_back(clear_edit(v.drawing.cursor, d));
  } else if (!parts) {
    add_to(typed.edits, accept_number(v, design));
    if (key == "Tab") next_grid(v, d);
    else typed.taken = move_by(v, d, settings, key);
  }
  return typed;
}

TypedKey type_after_wait(DocumentView& v, const Design& design, double now_s) {
  if (!waits_until(v) || now_s < v.drawing.cursor.until_s) return {};
  TypedKey typed{true};
  add_to(typed.edits, finish_number(v, design));
  return typed;
}

std::optional<double> waits_until(const DocumentView& v) {
  if (v.select.tool != Tool::kType || v.drawing.cursor.typed == 0) return {};
  return v.drawing.cursor.until_s;
}

void put_cursor(TypeCursor& cursor, GridId grid, Cell at) { cursor = {grid, at, 0, 0, false}; }

void begin_typing(DocumentView& v, const Draft& d, Hover hover) {
  const Selection& s = v.select.selected;
  if (!s.empty()) put_cursor(v.drawing.cursor, grid_id_of(s.grid), {s.a0, s.b0});
  else if (bit_grid_of(hover.grid) && hover.cell.valid()) put_cursor(v.drawing.cursor, hover.grid, hover.cell);
  v.select.tool = Tool::kType;
  follow_draft(v.drawing.cursor, d);
  go(v, d, 0, 0);
}

void follow_draft(TypeCursor& c, const Draft& d) {
  if (!is_shown(d, *bit_grid_of(c.grid)))
    c.grid = c.grid == GridId::kLiftplan    ? GridId::kTreadling
             : c.grid == GridId::kTreadling ? GridId::kLiftplan
                                            : GridId::kThreading;
  const Size size = size_of(d, c.grid);
  c.at = {std::clamp(c.at.a, 0, std::max(0, size.columns - 1)), std::clamp(c.at.b, 0, std::max(0, size.rows - 1))};
}

std::string typing_text(const TypeCursor& c, const Design& design, const BitMatrix& cells) {
  if (c.typed > 0)
    return fill(c.grid == GridId::kTreadling
                    ? tr("treadle {number}\xE2\x80\xA6    type another digit; Enter or a comma accepts, Esc cancels")
                    : tr("shaft {number}\xE2\x80\xA6    type another digit; Enter or a comma accepts, Esc cancels"),
                arg("number", c.typed));
  const std::string here = describe(design, cells, c.grid, c.at);
  const char* text = nullptr;
  if (c.grid == GridId::kDrawdown) text = tr("{cell}    Space toggles the cell; arrows, Tab: next grid; Esc ends");
  else if (c.grid == GridId::kTreadling)
    text =
        tr("{cell}    type a treadle, 1 to {last}, 0 clears; Space toggles the cell; arrows, Home, End, Tab: next "
           "grid; Esc ends");
  else if (holds_one(c.grid))
    text =
        tr("{cell}    type a shaft, 1 to {last}, 0 clears; Space toggles the cell; arrows, Home, End, Tab: next "
           "grid; Esc ends");
  else
    text =
        tr("{cell}    type a shaft, 1 to {last}; Space toggles the cell; arrows, Home, End, Tab: next grid; Esc "
           "ends");
  return fill(text, arg("cell", here), arg("last", most(design.draft, c.grid)));
}

}  // namespace weftlight::session
