// A hundred thousand random actions: the draft stays consistent, every step is undone and redone exactly, and memory
// stays bounded.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <random>

#include "bare_editor.h"
#include "design/edits.h"
#include "session/editing/follow_document.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"
#include "session/editing/shapes.h"
#include "session/recovery/journal_format.h"

namespace weftlight::actions {

using design::Design, design::Yarn, design::is_consistent, design::kMaxHistoryBytes, design::with_new_palette_color,
    design::with_new_yarn, design::with_size, design::with_thread_spacing, design::with_thread_thickness;
using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::Selection, draft::System, draft::blank_draft,
    draft::columns_of, draft::drawdown, draft::kFromYarn, draft::rows_of;
using session::ActiveShape, session::BarPaint, session::Cell, session::Edit, session::GridId, session::JournalEntry,
    session::MaybeEdit, session::Mirror, session::Tool, session::bar_edit, session::finish_shape,
    session::follow_document, session::is_shown, session::journal_entry, session::journal_start, session::mirror_of,
    session::paint_edit, session::read_journal, session::select_cells, session::selection_between;
using wif::read_wif, wif::write_new_wif;

namespace {

constexpr int kActions = 100'000, kMaxThreadsHere = 160;
constexpr unsigned kSeed = 20260;

Design first_design() {
  Design d;
  d.draft = blank_draft(24, 24, 6, 6);
  for (int i = 0; i < 24; ++i) {
    d.draft.threading.set(i, i % 6, true);
    d.draft.treadling.set(i, i % 6, true);
  }
  return d;
}

size_t resident_bytes() {
  size_t pages = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

class RandomActions : public testing::Test {
 protected:
  int roll(int below) { return static_cast<int>(dice_() % static_cast<unsigned>(std::max(below, 1))); }
  const Draft& draft() const { return editor_.document().now().draft; }

  void act();
  void paint();
  void select();
  void edit_threads();
  /// Steps back and forth again, each exactly.
  void walk(int steps);

  std::mt19937 dice_{kSeed};
  BareEditor editor_{first_design()};
  std::vector<Action> actions_ = make_actions(editor_.subjects(), {});
  bool joins_none_ = false;  // the last action was an edit of its own step
};

void RandomActions::paint() {
  constexpr GridId kGrids[] = {GridId::kThreading, GridId::kTieup,      GridId::kTreadling, GridId::kLiftplan,
                               GridId::kDrawdown,  GridId::kWarpColors, GridId::kWeftColors};
  const GridId grid = kGrids[roll(7)];
  const auto cell = [&] { return Cell{roll(draft().ends() + 2) - 1, roll(draft().picks() + 2) - 1}; };
  const Cell from = cell(), to = cell();
  if (grid == GridId::kWarpColors || grid == GridId::kWeftColors)
    return editor_.commit(bar_edit(grid, from, to, roll(2) == 0 ? BarPaint::kColor : BarPaint::kYarn, roll(4)));
  const Mirror mirror = mirror_of(editor_.view().drawing, editor_.view().select.selected, draft());
  if (roll(3) == 0 && from.valid() && to.valid()) {
    constexpr Tool kShapes[] = {Tool::kLine, Tool::kRectangle, Tool::kFilledRectangle};
    editor_.view().drawing.shape = ActiveShape{kShapes[roll(3)], grid, from, to, roll(2) == 0};
    if (const MaybeEdit edit = finish_shape(editor_.view(), editor_.document().now())) editor_.commit(*edit);
    return;
  }
  Edit edit = paint_edit(grid, from, to, roll(3) != 0, roll(2) == 0, mirror);
  edit.stroke = static_cast<uint64_t>(roll(3));  // some join the one before
  editor_.commit(edit);
}

void RandomActions::select() {
  constexpr BitGrid kGrids[] = {BitGrid::kThreading, BitGrid::kTieup, BitGrid::kTreadling, BitGrid::kLiftplan,
                                BitGrid::kDrawdown};
  const BitGrid grid = kGrids[roll(5)];
  const int columns = columns_of(draft(), grid), rows = rows_of(draft(), grid);
  if (!is_shown(draft(), grid) || columns == 0 || rows == 0) return;
  select_cells(editor_.view().select,
               selection_between(grid, {roll(columns), roll(rows)}, {roll(columns), roll(rows)}));
}

void RandomActions::edit_threads() {
  const System system = roll(2) == 0 ? System::kWarp : System::kWeft;
  const int threads = draft().threads(system).size(), thread = roll(threads);
  const int kind = roll(6);
  const float mm = roll(3) == 0 ? kFromYarn : 0.1f * static_cast<float>(1 + roll(30));
  const int ends = 1 + roll(60), picks = 1 + roll(60), shafts = 1 + roll(10), treadles = 1 + roll(10);
  editor_.commit({"threads", [=](Design d) {
                    switch (kind) {
                      case 0:
                        return with_thread_thickness(std::move(d), system, thread, mm);
                      case 1:
                        return with_thread_spacing(std::move(d), system, thread, mm);
                      case 2:
                        return with_new_palette_color(std::move(d), {0.1f, 0.2f, 0.3f});
                      case 3:
                        return d.yarns.size() < 8 ? with_new_yarn(std::move(d), Yarn{}) : d;
                      case 4:
                        return d.draft.palette.size() > 64 ? first_design() : d;
                      default:
                        return with_size(std::move(d), ends, picks, shafts, treadles);
                    }
                  }});
}

void RandomActions::act() {
  joins_none_ = false;
  // What grows without end is cut back, as a step like the others.
  if (std::max(draft().ends(), draft().picks()) > kMaxThreadsHere || draft().shafts > 40 || draft().treadles > 40)
    return editor_.commit({"cut", [](Design d) { return with_size(std::move(d), 24, 24, 6, 6); }});
  const int kind = roll(100);
  if (kind < 25) return paint();
  if (kind < 40) return select();
  if (kind < 50) {
    joins_none_ = true;
    return edit_threads();
  }
  if (kind < 56) return editor_.undo();
  if (kind < 60) return editor_.redo();
  const Action& action = actions_[static_cast<size_t>(roll(static_cast<int>(actions_.size())))];
  const auto run = action.run;
  if (!action.enabled || action.enabled()) run();
}

void RandomActions::walk(int steps) {
  std::vector<std::shared_ptr<const Design>> passed{editor_.document().snapshot()};
  while (static_cast<int>(passed.size()) <= steps && editor_.document().history().can_undo()) {
    editor_.undo();
    passed.push_back(editor_.document().snapshot());
  }
  for (size_t i = passed.size() - 1; i-- > 0;) {
    editor_.redo();
    ASSERT_EQ(editor_.document().now(), *passed[i]) << "the very step that was taken back";
  }
  ASSERT_EQ(editor_.document().cells(), drawdown(draft()));
}

TEST_F(RandomActions, KeepTheDraftConsistentAndCanAllBeUndone) {
  const size_t before = resident_bytes();
  std::string text = write_new_wif(editor_.document().now());
  JournalEntry first;
  first.text = text;
  std::string journal = journal_start(first);
  int changes = 0;
  for (int i = 0; i < kActions; ++i) {
    const auto was = editor_.document().snapshot();
    act();
    changes += editor_.document().snapshot() != was;
    follow_document(editor_.view(), editor_.document());
    ASSERT_TRUE(is_consistent(editor_.document().now())) << "after action " << i;
    if (i % 16 == 0) {
      ASSERT_EQ(editor_.document().cells(), drawdown(draft())) << "after action " << i;
    }
    // Undo gives the very design of before.
    if (joins_none_ && editor_.document().snapshot() != was) {
      editor_.undo();
      ASSERT_EQ(editor_.document().now(), *was) << "after action " << i;
      editor_.redo();
    }
    if (i % 1000 == 0) {
      ASSERT_NO_FATAL_FAILURE(walk(50)) << "after action " << i;
    }
    if (i % 500 == 0) {
      const std::string now = write_new_wif(editor_.document().now());
      ASSERT_EQ(read_wif(now).file->design, editor_.document().now()) << "after action " << i;
      journal += journal_entry(text, now);
      text = now;
    }
  }
  EXPECT_GT(changes, kActions / 4) << "most do something";
  EXPECT_EQ(read_journal(journal)->text, text);
  ASSERT_NO_FATAL_FAILURE(walk(1'000'000));
  const size_t after = resident_bytes();
  EXPECT_LT(after, before + 2 * kMaxHistoryBytes) << "bytes, and at the beginning " << before;
  RecordProperty("megabytes", static_cast<int>(after >> 20));
}

TEST(ThreadActions, ColoursAreCopiedBetweenWarpAndWeft) {
  Design d;
  d.draft = blank_draft(3, 7, 2, 2);
  d.draft.palette.resize(4);
  d.draft.warp.color = {2, 3, 1};
  BareEditor editor(d);
  for (const Action& a : make_actions(editor.subjects(), {}))
    if (a.item.id == "threads.weft_as_warp") a.run();
  EXPECT_EQ(editor.document().now().draft.weft.color, (std::vector<int>{2, 3, 1, 2, 3, 1, 2})) << "over and over";
  editor.undo();
  EXPECT_EQ(editor.document().now(), d) << "one step of undo";
}

TEST(ThreadActions, ColoursAndThicknessAreCopiedSeparately) {
  Design d;
  d.draft = blank_draft(3, 5, 2, 2);
  d.draft.palette.resize(4, {0.5f, 0.25f, 1});
  d.draft.palette[2] = {1, 0, 0};
  d.draft.warp.color = {2, 0, 1};
  d.draft.warp.thickness_mm = {0.5f, kFromYarn, 2};
  BareEditor editor(d);
  const auto run = [&editor](const char* id) {
    for (const Action& a : make_actions(editor.subjects(), {}))
      if (a.item.id == id) return a.run();
    FAIL() << id;
  };
  editor.view().chosen = {System::kWarp, {0, 2}, 0, {}, false, false};
  run("threads.copy_colors");
  editor.view().chosen = {System::kWeft, {1, 2, 3}, 1, {}, false, false};
  run("threads.paste_looks");
  EXPECT_EQ(editor.document().now().draft.weft.color, (std::vector<int>{1, 2, 1, 2, 1}));
  EXPECT_EQ(editor.document().now().draft.weft.thickness_mm, d.draft.weft.thickness_mm);
  editor.undo();
  run("threads.weft_thick_as_warp");
  EXPECT_EQ(editor.document().now().draft.weft.thickness_mm, (std::vector<float>{0.5f, kFromYarn, 2, 0.5f, kFromYarn}));
  EXPECT_EQ(editor.document().now().draft.weft.color, d.draft.weft.color);
}

TEST(ThreadActions, DeselectIsForThreadsAsWellOnceNothingIsBeingPasted) {
  Design d;
  d.draft = blank_draft(4, 4, 2, 2);
  BareEditor editor(d);
  const std::vector<Action> all = make_actions(editor.subjects(), {});
  const auto deselect = std::ranges::find(all, "select_none", [](const Action& a) { return a.item.id; });
  ASSERT_NE(deselect, all.end());
  EXPECT_FALSE(deselect->enabled());
  editor.view().chosen = {System::kWarp, {0, 2}, 0, {}, false, false};
  editor.view().select.held.emplace();
  deselect->run();
  EXPECT_FALSE(editor.view().select.held);
  EXPECT_EQ(editor.view().chosen.threads.size(), 2u) << "one thing at a time";
  ASSERT_TRUE(deselect->enabled());
  deselect->run();
  EXPECT_TRUE(editor.view().chosen.threads.empty());
  EXPECT_FALSE(deselect->enabled());
}

TEST(SelectionActions, AQuarterTurnIsClockwiseOnTheScreen) {
  Design d;
  d.draft = blank_draft(6, 6, 4, 4);
  d.draft.threading.set(0, 0, true);  // end 1 at the right, shaft 1 at the bottom
  d.draft.threading.set(1, 0, true);
  BareEditor editor(d);
  const auto turn = [&editor] {
    for (const Action& a : make_actions(editor.subjects(), {}))
      if (a.item.id == "quarter_turn") a.run();
  };
  select_cells(editor.view().select, {BitGrid::kThreading, 0, 2, 0, 2});
  turn();
  // The lower row of the two by two is now its left column.
  const BitMatrix& threading = editor.document().now().draft.threading;
  EXPECT_TRUE(threading.get(1, 0));
  EXPECT_TRUE(threading.get(1, 1));
  EXPECT_EQ(threading.count(), 2);
  for (int i = 0; i < 3; ++i) turn();
  EXPECT_EQ(editor.document().now(), d) << "four quarters are none";
  // One that is longer than wide stays in its grid.
  select_cells(editor.view().select, {BitGrid::kThreading, 0, 4, 3, 4});
  turn();
  const Selection& now = editor.view().select.selected;
  EXPECT_EQ(now, (Selection{BitGrid::kThreading, 0, 1, 0, 4}));
}

}  // namespace
}  // namespace weftlight::actions
