// Actions on the selection. The edits themselves are in core/draft.

#include <algorithm>

#include "actions/action_parts.h"
#include "design/loom.h"
#include "draft/block_text.h"
#include "session/editing/selection_state.h"
#include "session/editing/typing.h"

namespace weftlight::actions {

using base::fill, base::mark, base::message, base::tr;
using design::Design, design::PlacedBlock, design::RepeatExtent, design::ThreadRange, design::cleared_block,
    design::half_turned, design::inverted, design::may_paint, design::mirrored_across, design::mirrored_down,
    design::repeated_block, design::shifted, design::threads_of, design::with_advancing_repeat,
    design::with_bare_threads, design::with_block, design::with_cleared, design::with_doubled_threads,
    design::with_half_turn, design::with_inverted, design::with_mirrored_across, design::with_mirrored_down,
    design::with_point_repeat, design::with_repeated, design::with_reversed_threads, design::with_shifted,
    design::without_threads;
using draft::BitGrid, draft::BitMatrix, draft::CellBlock, draft::Draft, draft::Selection, draft::System, draft::Write,
    draft::block_text, draft::cells_of, draft::clipped, draft::columns_of, draft::for_each_bit, draft::kMaxBlockCells,
    draft::read_block_text, draft::rows_of, draft::whole_grid;
using session::Cell, session::DrawingState, session::MaybeEdit, session::SelectDrag, session::SelectState,
    session::Tool, session::accept_number, session::begin_typing, session::bit_grid_of, session::cancel_drag,
    session::drop_block, session::escape, session::extend_selection, session::hold_block, session::hold_block_over,
    session::missed_by_move, session::missed_crossings, session::missed_text, session::move_selection,
    session::screen_step, session::select_cells, session::size_text, session::turn_held_block, session::unless_locked;

namespace {

using SelectionEdit = Design (*)(Design, const Selection&, bool with_properties);
using BlockWanted = PlacedBlock (*)(const Draft&, const Selection&);
using ThreadEdit = Design (*)(Design, const ThreadRange&, bool with_properties);
constexpr const char* kTurn = mark("Mirror and rotate");
constexpr const char* kShift = mark("Shift by one");
constexpr const char* kRepeat = mark("Repeat");
constexpr const char* kThreads = mark("Threads");

const Selection& selected(const SelectionSubjects& e) { return e.draft.view().select.selected; }
bool has_selection(const SelectionSubjects& e) { return !selected(e).empty(); }
bool has_threads(const SelectionSubjects& e) { return threads_of(selected(e)).has_value(); }
bool has_block(const SelectionSubjects& e) { return e.draft.view().select.held.has_value(); }

Action& on_selection(const SelectionSubjects& e, Action& a, const char* submenu = "") {
  a.item.submenu = submenu;
  a.item.on_selection = true;
  a.enabled = [e] { return has_selection(e); };
  return a;
}

/// `wanted` of a block in the drawdown. A locked grid, and a loom that is too small, have given their own reason.
void tell_missed(const SelectionSubjects& e, const std::string& done, const PlacedBlock& wanted) {
  const Design& now = e.draft.document().now();
  const Selection& s = wanted.at;
  if (s.empty() || !may_paint(now, s.grid) || e.draft.view().rejected_edit) return;
  const int64_t missed = missed_crossings(now.draft, s.grid, s.a0, s.b0, wanted.cells);
  if (missed > 0) e.window.refuse(missed_text(done, missed));
}

Action& add_edit(Actions& all, const SelectionSubjects& e, const char* submenu, const char* id, const char* label,
                 const char* key, SelectionEdit edit, BlockWanted wanted_by) {
  return on_selection(
      e,
      add(all, "Edit", id, label, key,
          [=] {
            const bool properties = e.draft.view().select.with_properties;
            const Selection s = selected(e);
            const PlacedBlock wanted =
                s.grid == BitGrid::kDrawdown ? wanted_by(e.draft.document().now().draft, s) : PlacedBlock();
            e.draft.commit(unless_locked(
                s.grid, {label, [s, edit, properties](Design d) { return edit(std::move(d), s, properties); }}));
            tell_missed(e, label, wanted);
          }),
      submenu);
}

Action& add_thread_edit(Actions& all, const SelectionSubjects& e, const char* submenu, const char* id,
                        const char* label, const char* key, ThreadEdit edit) {
  Action& a = on_selection(e,
                           add(all, "Edit", id, label, key,
                               [=] {
                                 const bool properties = e.draft.view().select.with_properties;
                                 e.draft.commit({label, [t = *threads_of(selected(e)), edit, properties](Design d) {
                                                   return edit(std::move(d), t, properties);
                                                 }});
                               }),
                           submenu);
  a.enabled = [e] { return has_threads(e); };
  return a;
}

/// False, with a message, if there are too many cells.
bool copy_selection(const SelectionSubjects& e) {
  const Selection s = selected(e);
  const std::string size = size_text(s.grid, s.columns(), s.rows());
  if (int64_t{s.columns()} * s.rows() > kMaxBlockCells) {
    e.window.refuse(fill(tr("{size} is too much to copy. Move or repeat it instead."), arg("size", size)));
    return false;
  }
  e.clipboard.set_text(block_text({s.grid, cells_of(e.draft.document().now().draft, s)}));
  e.window.say(fill(tr("Copied {text}"), arg("text", size)));
  return true;
}

void cut_selection(const SelectionSubjects& e) {
  if (!copy_selection(e)) return;
  const Selection s = selected(e);
  const PlacedBlock wanted = cleared_block(e.draft.document().now().draft, s);
  e.draft.commit(unless_locked(s.grid, {tr("Cut"), [s](Design d) { return with_cleared(std::move(d), s); }}));
  tell_missed(e, tr("Cut"), wanted);
}

void paste(const SelectionSubjects& e, bool as_marks) {
  base::Result<CellBlock> read = read_block_text(e.clipboard.text());
  if (!read) return e.window.refuse(message(read.error()));
  hold_block(e.draft.view().select, e.draft.document().now().draft, std::move(*read), as_marks);
  if (const auto grid = bit_grid_of(e.window.hover().grid))
    hold_block_over(e.draft.view().select, *grid, e.window.hover().cell);
}

void select_all(const SelectionSubjects& e) {
  SelectState& s = e.draft.view().select;
  const auto hovered = bit_grid_of(e.window.hover().grid);
  const BitGrid grid = hovered ? *hovered : s.selected.empty() ? BitGrid::kThreading : s.selected.grid;
  select_cells(s, whole_grid(e.draft.document().now().draft, grid));
  s.anchor = {0, 0};
  s.tool = Tool::kSelect;
}

void select_whole_threads(const SelectionSubjects& e) {
  Selection s = selected(e);
  const Selection all = whole_grid(e.draft.document().now().draft, s.grid);
  if (s.grid == BitGrid::kThreading) s.b0 = all.b0, s.b1 = all.b1;
  else s.a0 = all.a0, s.a1 = all.a1;
  select_cells(e.draft.view().select, s);
}

void insert_threads(const SelectionSubjects& e) {
  const ThreadRange t = *threads_of(selected(e));
  e.draft.commit({tr("Insert threads"), [t, properties = e.draft.view().select.with_properties](Design d) {
                    return with_bare_threads(std::move(d), t.system, t.first, t.count(), properties);
                  }});
}

void delete_threads(const SelectionSubjects& e) {
  const ThreadRange t = *threads_of(selected(e));
  const bool all = t.count() >= e.draft.document().now().draft.threads(t.system).size();
  if (all)
    return e.window.refuse(t.system == System::kWarp ? tr("A draft keeps at least one end.")
                                                     : tr("A draft keeps at least one pick."));
  e.draft.commit({tr("Delete threads"), [t, properties = e.draft.view().select.with_properties](Design d) {
                    return without_threads(std::move(d), t, properties);
                  }});
  select_cells(e.draft.view().select, {});
}

bool has_chosen_threads(const SelectionSubjects& e) { return !e.draft.view().chosen.threads.empty(); }

/// Cancels one thing per call: the rejected edit, the shape being drawn, the drag or active block, the selection of
/// cells and threads.
void cancel_one(const SelectionSubjects& e) {
  if (e.draft.view().rejected_edit) return e.draft.view().rejected_edit.reset();
  if (e.draft.view().drawing.shape) return e.draft.view().drawing.shape.reset();
  SelectState& s = e.draft.view().select;
  if (s.drag == SelectDrag::kNone) {
    if (!s.held) e.draft.view().chosen.threads.clear();
    escape(s);
  } else if (const MaybeEdit back = cancel_drag(s, e.draft.document().now())) {
    e.draft.commit(*back);
  }
}

void add_clipboard(Actions& all, const SelectionSubjects& e) {
  new_group(on_selection(e, add(all, "Edit", "cut", tr("Cut"), "Ctrl+X", [e] { cut_selection(e); })));
  on_selection(e, add(all, "Edit", "copy", tr("Copy"), "Ctrl+C", [e] { copy_selection(e); }));
  on_selection(e, add(all, "Edit", "paste", tr("Paste"), "Ctrl+V", [e] { paste(e, false); })).enabled = nullptr;
  on_selection(e, add(all, "Edit", "paste_add", tr("Paste marks on top"), "Ctrl+Shift+V", [e] { paste(e, true); }))
      .enabled = nullptr;
  add_edit(
      all, e, "", "clear", tr("Delete"), "Delete",
      [](Design d, const Selection& s, bool) { return with_cleared(std::move(d), s); }, cleared_block);
  new_group(add(all, "Edit", "select_all", tr("Select the whole grid"), "Ctrl+A", [e] { select_all(e); }));
  on_selection(e, add(all, "Edit", "select_threads", tr("Select whole threads"), "Ctrl+Shift+A",
                      [e] { select_whole_threads(e); }))
      .enabled = [e] { return has_threads(e); };
  add(all, "Edit", "select_none", tr("Deselect"), "Escape", [e] { cancel_one(e); }).enabled = [e] {
    return has_selection(e) || has_block(e) || has_chosen_threads(e) || e.draft.view().drawing.shape ||
           e.draft.view().rejected_edit;
  };
}

using BlockTurn = BitMatrix (*)(const BitMatrix&);

/// Mirrors or rotates the active block, else the selection.
void turn(const SelectionSubjects& e, const char* label, SelectionEdit edit, BlockTurn of_block) {
  if (has_block(e)) return turn_held_block(e.draft.view().select, of_block);
  const Selection s = selected(e);
  const bool crossings = s.grid == BitGrid::kDrawdown;
  const BitMatrix wanted = crossings ? of_block(cells_of(e.draft.document().now().draft, s)) : BitMatrix();
  e.draft.commit(unless_locked(s.grid, {label, [s, edit, properties = e.draft.view().select.with_properties](Design d) {
                                          return edit(std::move(d), s, properties);
                                        }}));
  tell_missed(e, label, {s, wanted});
}

/// Row 0 becomes the last column.
BitMatrix turned_on(const BitMatrix& cells) {
  BitMatrix out(cells.cols(), cells.rows());
  for (int r = 0; r < cells.rows(); ++r)
    for_each_bit(cells.row(r), [&](int c) { out.set(c, cells.rows() - 1 - r, true); });
  return out;
}

BitMatrix turned_back(const BitMatrix& cells) { return half_turned(turned_on(cells)); }

/// Clockwise as seen on the screen: a grid that is drawn mirrored rotates the other way.
void quarter_turn(const SelectionSubjects& e) {
  const SelectState& state = e.draft.view().select;
  const BitGrid grid = state.held ? state.held->grid : selected(e).grid;
  const Cell right = screen_step(grid, e.settings, 1, 0);
  const Cell down = screen_step(grid, e.settings, 0, 1);
  const BlockTurn turned = (right.a > 0) == (down.b > 0) ? turned_on : turned_back;
  if (has_block(e)) return turn_held_block(e.draft.view().select, turned);
  const Draft& draft = e.draft.document().now().draft;
  const Selection s = clipped(selected(e), draft);
  const BitMatrix block = turned(cells_of(draft, s));
  const int columns = std::min(block.cols(), columns_of(draft, grid)),
            rows = std::min(block.rows(), rows_of(draft, grid));
  const int a = std::min(s.a0, columns_of(draft, grid) - columns), b = std::min(s.b0, rows_of(draft, grid) - rows);
  // Old and new position are one block, so that the crossings of both are solved together.
  const Selection both{grid, std::min(a, s.a0), std::max(a + columns, s.a1), std::min(b, s.b0),
                       std::max(b + rows, s.b1)};
  BitMatrix cells = cells_of(draft, both);
  for (int y = 0; y < s.rows(); ++y)
    for (int x = 0; x < s.columns(); ++x) cells.set(s.b0 - both.b0 + y, s.a0 - both.a0 + x, false);
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) cells.set(b - both.b0 + y, a - both.a0 + x, block.get(y, x));
  e.draft.commit(unless_locked(grid, {tr("Rotate by a quarter turn"), [both, cells](Design d) {
                                        return with_block(std::move(d), both.grid, both.a0, both.b0, cells,
                                                          Write::kInside);
                                      }}));
  tell_missed(e, tr("Rotate by a quarter turn"), {both, cells});
  select_cells(e.draft.view().select, {grid, a, a + columns, b, b + rows});
}

void add_turns(Actions& all, const SelectionSubjects& e) {
  const auto add_turn = [&all, &e](const char* id, const char* label, const char* key, SelectionEdit edit,
                                   BlockTurn of_block) {
    Action& a = on_selection(e, add(all, "Edit", id, label, key, [=] { turn(e, label, edit, of_block); }), kTurn);
    a.enabled = [e] { return has_selection(e) || has_block(e); };
    return &a;
  };
  new_group(*add_turn("mirror_across", tr("Mirror left to right"), "Shift+H", with_mirrored_across, mirrored_across));
  add_turn("mirror_down", tr("Mirror top to bottom"), "Shift+V", with_mirrored_down, mirrored_down);
  on_selection(e, add(all, "Edit", "quarter_turn", tr("Rotate by a quarter turn"), "R", [e] { quarter_turn(e); }),
               kTurn)
      .enabled = [e] { return has_selection(e) || has_block(e); };
  add_turn("half_turn", tr("Rotate by a half turn"), "Shift+R", with_half_turn, half_turned);
  add_turn(
      "invert", tr("Invert"), "Ctrl+I",
      [](Design d, const Selection& s, bool) { return with_inverted(std::move(d), s); }, inverted);
}

void add_repeats(Actions& all, const SelectionSubjects& e) {
  add_edit(
      all, e, kRepeat, "repeat_end", tr("Repeat to the end"), "Ctrl+R",
      [](Design d, const Selection& s, bool properties) {
        return with_repeated(std::move(d), s, RepeatExtent::kToEnd, properties);
      },
      [](const Draft& d, const Selection& s) { return repeated_block(d, s, RepeatExtent::kToEnd); });
  add_edit(
      all, e, kRepeat, "repeat_all", tr("Repeat over the whole grid"), "Ctrl+Shift+R",
      [](Design d, const Selection& s, bool properties) {
        return with_repeated(std::move(d), s, RepeatExtent::kAll, properties);
      },
      [](const Draft& d, const Selection& s) { return repeated_block(d, s, RepeatExtent::kAll); });
  add_thread_edit(all, e, kRepeat, "point_end", tr("Point repeat to the end"), "Ctrl+M",
                  [](Design d, const ThreadRange& t, bool properties) {
                    return with_point_repeat(std::move(d), t, RepeatExtent::kToEnd, properties);
                  });
  add_thread_edit(all, e, kRepeat, "advance_up", tr("Advancing repeat to the end, one up each time"), "Ctrl+.",
                  [](Design d, const ThreadRange& t, bool properties) {
                    return with_advancing_repeat(std::move(d), t, 1, properties);
                  });
  add_thread_edit(all, e, kRepeat, "advance_down", tr("Advancing repeat to the end, one down each time"), "Ctrl+,",
                  [](Design d, const ThreadRange& t, bool properties) {
                    return with_advancing_repeat(std::move(d), t, -1, properties);
                  });
}

void add_threads(Actions& all, const SelectionSubjects& e) {
  on_selection(
      e, add(all, "Edit", "insert_threads", tr("Insert empty threads before"), "Insert", [e] { insert_threads(e); }),
      kThreads)
      .enabled = [e] { return has_threads(e); };
  on_selection(e, add(all, "Edit", "delete_threads", tr("Delete threads"), "Ctrl+Delete", [e] { delete_threads(e); }),
               kThreads)
      .enabled = [e] { return has_threads(e); };
  add_thread_edit(all, e, kThreads, "reverse_threads", tr("Reverse the order"), "Ctrl+Shift+M", with_reversed_threads);
  add_thread_edit(all, e, kThreads, "double_threads", tr("Insert a copy after"), "Ctrl+D",
                  [](Design d, const ThreadRange& t, bool properties) {
                    return with_doubled_threads(std::move(d), t, false, properties);
                  });
  add_thread_edit(all, e, kThreads, "double_mirrored", tr("Insert a mirrored copy after (shared point)"),
                  "Ctrl+Shift+D", [](Design d, const ThreadRange& t, bool properties) {
                    return with_doubled_threads(std::move(d), t, true, properties);
                  });
  Action& properties =
      on_selection(e,
                   add(all, "Edit", "with_looks", tr("Threads keep their colours and yarns"), "",
                       [e] { e.draft.view().select.with_properties = !e.draft.view().select.with_properties; }),
                   kThreads);
  properties.enabled = nullptr;
  properties.checked = [e] { return e.draft.view().select.with_properties; };
}

/// An arrow key moves the active block, or the selected marks, by one cell.
void step(const SelectionSubjects& e, int dx, int dy) {
  SelectState& s = e.draft.view().select;
  const Design& design = e.draft.document().now();
  const BitGrid grid = s.held ? s.held->grid : s.selected.grid;
  const Cell by = screen_step(grid, e.settings, dx, dy);
  if (s.held) {
    const Cell at{std::clamp(s.held->at.a + by.a, 0, columns_of(design.draft, grid) - 1),
                  std::clamp(s.held->at.b + by.b, 0, rows_of(design.draft, grid) - 1)};
    return hold_block_over(s, grid, at);
  }
  const MaybeEdit edit = move_selection(s, design, s.selected.a0 + by.a, s.selected.b0 + by.b, false);
  if (!edit) return;
  e.draft.commit(*edit);
  if (e.draft.view().rejected_edit) return;
  if (const std::string missed = missed_by_move(s, e.draft.document().now()); !missed.empty()) e.window.refuse(missed);
}

void shift_by_one(const SelectionSubjects& e, const char* label, int dx, int dy) {
  const Selection s = selected(e);
  const Cell by = screen_step(s.grid, e.settings, dx, dy);
  const bool crossings = s.grid == BitGrid::kDrawdown;
  const BitMatrix wanted = crossings ? shifted(cells_of(e.draft.document().now().draft, s), by.a, by.b) : BitMatrix();
  e.draft.commit(unless_locked(s.grid, {label, [s, by, properties = e.draft.view().select.with_properties](Design d) {
                                          return with_shifted(std::move(d), s, by.a, by.b, properties);
                                        }}));
  tell_missed(e, label, {s, wanted});
}

struct Arrow {
  const char *key, *name;
  const char *shift, *move, *extend;  // labels
  int dx, dy;
};
constexpr Arrow kArrows[] = {
    {"Left", "left", mark("Shift left, wrapping"), mark("Move the selection left"), mark("Extend the selection left"),
     -1, 0},
    {"Right", "right", mark("Shift right, wrapping"), mark("Move the selection right"),
     mark("Extend the selection right"), 1, 0},
    {"Up", "up", mark("Shift up, wrapping"), mark("Move the selection up"), mark("Extend the selection up"), 0, -1},
    {"Down", "down", mark("Shift down, wrapping"), mark("Move the selection down"), mark("Extend the selection down"),
     0, 1}};

void add_shifts(Actions& all, const SelectionSubjects& e) {
  for (const Arrow& way : kArrows)
    on_selection(
        e,
        add(all, "Edit", (std::string("shift_") + way.name).c_str(), tr(way.shift),
            (std::string("Alt+") + way.key).c_str(), [way, e] { shift_by_one(e, tr(way.shift), way.dx, way.dy); }),
        kShift);
}

/// Actions without a menu item; the command palette lists them.
void add_keys(Actions& all, const SelectionSubjects& e) {
  for (const Arrow& way : kArrows) {
    const std::string name = way.name, key = way.key;
    add(all, "", ("move_" + name).c_str(), tr(way.move), key.c_str(), [way, e] { step(e, way.dx, way.dy); }).enabled =
        [e] { return has_selection(e) || has_block(e); };
    add(all, "", ("extend_" + name).c_str(), tr(way.extend), ("Shift+" + key).c_str(), [way, e] {
      const Cell by = screen_step(selected(e).grid, e.settings, way.dx, way.dy);
      extend_selection(e.draft.view().select, e.draft.document().now().draft, by.a, by.b);
    }).enabled = [e] { return has_selection(e); };
  }
  add(all, "", "drop", tr("Place what is being pasted"), "Enter", [e] {
    if (const MaybeEdit edit = drop_block(e.draft.view().select, e.draft.document().now(), false))
      e.draft.commit(*edit);
  }).enabled = [e] { return has_block(e); };
}

/// A number that was typed so far is kept.
void change_tool(const SelectionSubjects& e, Tool to) {
  if (const MaybeEdit typed = accept_number(e.draft.view(), e.draft.document().now())) e.draft.commit(*typed);
  e.draft.view().select.tool = to;
  e.draft.view().drawing.shape.reset();
}

void add_tools(Actions& all, const SelectionSubjects& e) {
  const auto tool = [&all, &e](const char* id, const char* label, const char* key, Tool to) {
    Action& a = add(all, "Edit", id, label, key, [to, e] { change_tool(e, to); });
    a.checked = [to, e] { return e.draft.view().select.tool == to; };
    a.item.submenu = mark("Tools");
    return &a;
  };
  tool("tool_paint", tr("Paint tool"), "P", Tool::kPaint)->item.group = true;
  tool("tool_select", tr("Select tool"), "S", Tool::kSelect);
  tool("tool_line", tr("Line tool"), "I", Tool::kLine);  // L holds the light of the cloth
  tool("tool_rectangle", tr("Rectangle tool"), "U", Tool::kRectangle);
  tool("tool_filled", tr("Filled rectangle tool"), "Shift+U", Tool::kFilledRectangle);
  tool("tool_fill", tr("Fill tool"), "G", Tool::kFill);
  tool("tool_type", tr("Type shaft and treadle numbers"), "N", Tool::kType)->run = [e] {
    change_tool(e, Tool::kType);
    begin_typing(e.draft.view(), e.draft.document().now().draft, e.window.hover());
  };
  const auto mirror = [&all, &e](const char* id, const char* label, const char* key, bool DrawingState::*on) {
    Action& a =
        add(all, "Edit", id, label, key, [on, e] { e.draft.view().drawing.*on = !(e.draft.view().drawing.*on); });
    a.checked = [on, e] { return e.draft.view().drawing.*on; };
    a.item.submenu = mark("Mirrored drawing");
  };
  mirror("mirror_ends", tr("Mirror across the warp"), "M", &DrawingState::mirror_ends);
  mirror("mirror_picks", tr("Mirror across the weft"), "Shift+M", &DrawingState::mirror_picks);
}

}  // namespace

void add_selection_actions(Actions& all, const SelectionSubjects& subjects) {
  add_clipboard(all, subjects);
  add_turns(all, subjects);
  add_shifts(all, subjects);
  add_repeats(all, subjects);
  add_threads(all, subjects);
  add_tools(all, subjects);
  add_keys(all, subjects);
}

}  // namespace weftlight::actions
