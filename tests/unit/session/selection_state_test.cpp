#include "session/editing/selection_state.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "design/edits.h"

namespace weftlight::session {

using design::Design, design::mirrored_across, design::mirrored_down, design::straight_twill, design::to_liftplan,
    design::with_size, design::with_threading;
using draft::BitGrid, draft::BitMatrix, draft::CellBlock, draft::Selection, draft::cells_of;

namespace {

SelectState with_selected(const Selection& s) {
  SelectState state;
  select_cells(state, s);
  return state;
}

TEST(SelectTool, ARectangleIncludesBothCorners) {
  const Selection s = selection_between(BitGrid::kThreading, {5, 3}, {2, 1});
  EXPECT_EQ(s, (Selection{BitGrid::kThreading, 2, 6, 1, 4}));
  EXPECT_TRUE(holds(s, BitGrid::kThreading, {5, 1}));
  EXPECT_FALSE(holds(s, BitGrid::kThreading, {6, 1}));
  EXPECT_FALSE(holds(s, BitGrid::kDrawdown, {3, 2}));
}

TEST(SelectTool, ArrowKeysFollowTheScreenInEveryOrientation) {
  const Settings right;
  Settings left, below, upwards;
  left.end1_right = false;
  upwards.pick1_bottom = true;
  below.threading_below = true;
  EXPECT_EQ(screen_step(BitGrid::kThreading, right, 1, 0), (Cell{-1, 0})) << "end 1 at the right";
  EXPECT_EQ(screen_step(BitGrid::kThreading, left, 1, 0), (Cell{1, 0}));
  EXPECT_EQ(screen_step(BitGrid::kThreading, right, 0, -1).b, 1) << "shaft 1 lies lowest";
  EXPECT_EQ(screen_step(BitGrid::kTreadling, right, 1, 1), (Cell{1, 1}));
  EXPECT_EQ(screen_step(BitGrid::kDrawdown, right, -1, 1), (Cell{1, 1}));
  EXPECT_EQ(screen_step(BitGrid::kThreading, below, 0, -1).b, -1) << "shaft 1 lies highest, next to the drawdown";
  EXPECT_EQ(screen_step(BitGrid::kDrawdown, upwards, 0, 1).b, -1) << "pick 1 lies lowest";
  EXPECT_EQ(screen_step(BitGrid::kTreadling, upwards, 0, -1).b, 1);
  EXPECT_EQ(screen_step(BitGrid::kLiftplan, upwards, 0, -1).b, 1);
  EXPECT_EQ(screen_step(BitGrid::kTieup, upwards, 0, -1).b, 1) << "shafts stay as they are";
  EXPECT_EQ(screen_step(BitGrid::kThreading, upwards, 0, -1).b, 1);
}

TEST(SelectTool, MovedMarksRestoreTheCellsThatTheyPass) {
  const Design start = straight_twill(8, 6);
  SelectState s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  MaybeEdit edit = move_selection(s, start, 1, 0, false);
  ASSERT_TRUE(edit.has_value());
  const uint64_t stroke = edit->stroke;
  EXPECT_NE(stroke, 0u);
  Design now = edit->apply(start);
  EXPECT_EQ(now.draft.threading.first(0), -1);
  EXPECT_EQ(now.draft.threading.first(2), 1);
  edit = move_selection(s, now, 4, 0, false);
  ASSERT_TRUE(edit.has_value());
  EXPECT_EQ(edit->stroke, stroke) << "one move is one step";
  now = edit->apply(now);
  EXPECT_EQ(now.draft.threading.first(2), 2) << "passed over";
  EXPECT_EQ(now.draft.threading.first(4), 0);
  EXPECT_EQ(now.draft.threading.first(5), 1);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 4, 6, 0, 4}));
  edit = move_selection(s, now, 0, 0, false);
  EXPECT_EQ(edit->apply(now), start) << "back home";
}

TEST(SelectTool, AnEditBetweenTwoMovesSeparatesThem) {
  SelectState s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  MaybeEdit edit = move_selection(s, straight_twill(8, 6), 1, 0, false);
  const uint64_t stroke = edit->stroke;
  const Design painted = with_threading(edit->apply(straight_twill(8, 6)), 7, 0, true);
  edit = move_selection(s, painted, 2, 0, false);
  EXPECT_NE(edit->stroke, stroke);
  const Design now = edit->apply(painted);
  EXPECT_EQ(now.draft.threading.first(7), 0) << "what was painted stays";
  EXPECT_EQ(now.draft.threading.first(3), 1);
}

TEST(SelectTool, AMoveStaysInsideTheGrid) {
  SelectState s = with_selected({BitGrid::kTieup, 2, 4, 2, 4});
  move_selection(s, straight_twill(8, 6), 99, -99, false);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kTieup, 2, 4, 0, 2}));
  EXPECT_FALSE(move_selection(s, straight_twill(8, 6), 2, -5, false).has_value() && s.selected.b0 != 0);
  SelectState none;
  EXPECT_FALSE(move_selection(none, straight_twill(8, 6), 1, 1, false).has_value());
}

TEST(SelectTool, ACopyLeavesTheMarksInPlace) {
  const Design start = straight_twill(8, 6);
  SelectState s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  EXPECT_FALSE(move_selection(s, start, 0, 0, true).has_value()) << "nothing moved yet";
  const MaybeEdit edit = move_selection(s, start, 5, 0, false);
  const Design now = edit->apply(start);
  EXPECT_EQ(now.draft.threading.first(0), 0);
  EXPECT_EQ(now.draft.threading.first(5), 0);
  EXPECT_EQ(now.draft.threading.first(6), 1);
}

TEST(SelectTool, UndoOfAMoveMovesTheSelectionBack) {
  const Design start = straight_twill(8, 6);
  SelectState s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  const Design now = move_selection(s, start, 3, 0, false)->apply(start);
  follow_design(s, now, 2);
  EXPECT_EQ(s.selected.a0, 3);
  follow_design(s, start, 3);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 0, 2, 0, 4}));
}

TEST(SelectTool, DeletedThreadsAreNotSelected) {
  SelectState s = with_selected({BitGrid::kThreading, 2, 6, 0, 4});
  follow_design(s, with_size(straight_twill(8, 6), 4, 6, 3, 4), 1);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 2, 4, 0, 3}));
  s = with_selected({BitGrid::kTreadling, 0, 2, 0, 2});
  follow_design(s, to_liftplan(straight_twill(8, 6)), 2);
  EXPECT_TRUE(s.selected.empty()) << "a liftplan has no treadling";
}

TEST(SelectTool, ExtendingMovesTheFarCorner) {
  SelectState s = with_selected({BitGrid::kThreading, 2, 4, 1, 2});
  s.anchor = {2, 1};
  extend_selection(s, straight_twill(8, 6).draft, 2, 1);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 2, 6, 1, 3}));
  extend_selection(s, straight_twill(8, 6).draft, -5, 0);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 0, 3, 1, 3})) << "past the corner where it began";
  extend_selection(s, straight_twill(8, 6).draft, -9, 9);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 0, 3, 1, 4}));
}

TEST(SelectTool, APastedBlockIsPlacedAndSelected) {
  const Design start = straight_twill(8, 6);
  SelectState s;
  CellBlock block{BitGrid::kThreading, cells_of(start.draft, {BitGrid::kThreading, 0, 4, 0, 4})};
  hold_block(s, start.draft, block, false);
  EXPECT_EQ(s.tool, Tool::kSelect);
  EXPECT_NE(selection_text(s).find("4 ends \xC3\x97 4 shafts"), std::string::npos);
  hold_block_over(s, BitGrid::kThreading, {5, 0});
  hold_block_over(s, BitGrid::kThreading, {});
  EXPECT_EQ(s.held->at, (Cell{5, 0})) << "outside a grid it stays where it was";
  const Design now = drop_block(s, start, false)->apply(start);
  EXPECT_EQ(now.draft.threading.first(5), 0);
  EXPECT_EQ(now.draft.threading.first(7), 2);
  EXPECT_EQ(s.selected, (Selection{BitGrid::kThreading, 5, 8, 0, 4})) << "what hung over the edge is cut off";
  EXPECT_FALSE(s.held.has_value());
  EXPECT_NE(s.notice.find("Pasted"), std::string::npos);

  hold_block(s, start.draft, block, false);
  hold_block_over(s, BitGrid::kTreadling, {0, 2});
  const Design tromped = drop_block(s, start, true)->apply(start);
  EXPECT_EQ(tromped.draft.treadling.first(2), 0) << "threads stay threads";
  EXPECT_EQ(tromped.draft.treadling.first(5), 3);
  EXPECT_TRUE(s.held.has_value()) << "kept in hand";
  EXPECT_TRUE(escape(s));
  EXPECT_FALSE(s.held.has_value());
  EXPECT_TRUE(escape(s));
  EXPECT_FALSE(escape(s));
}

TEST(SelectTool, SaysWhatDidNotFit) {
  const Design start = straight_twill(8, 6);
  SelectState s;
  const auto pasted = [&](Cell at) {
    hold_block(s, start.draft, {BitGrid::kThreading, BitMatrix(3, 4)}, false);
    hold_block_over(s, BitGrid::kThreading, at);
    drop_block(s, start, false);
    return s.notice;
  };
  EXPECT_EQ(pasted({0, 0}), "Pasted 4 ends \xC3\x97 3 shafts");
  EXPECT_EQ(pasted({6, 0}), "Pasted 2 ends \xC3\x97 3 shafts; 2 ends did not fit");
  EXPECT_EQ(pasted({0, 3}), "Pasted 4 ends \xC3\x97 1 shaft; 2 shafts did not fit");
  EXPECT_EQ(pasted({5, 2}), "Pasted 3 ends \xC3\x97 2 shafts; 1 end and 1 shaft did not fit");
}

/// Ends 1 and 3 up, which no treadle of a 2/2 twill does.
CellBlock plain_pick() {
  BitMatrix cells(1, 4);
  cells.set(0, 0, true), cells.set(0, 2, true);
  return {BitGrid::kDrawdown, cells};
}

TEST(SelectTool, SaysHowManyTreadlesAPasteAdded) {
  const Design start = straight_twill(8, 6);
  SelectState s;
  hold_block(s, start.draft, plain_pick(), false);
  const MaybeEdit edit = drop_block(s, start, false);
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->apply(start).draft.treadles, start.draft.treadles + 1);
  EXPECT_EQ(s.notice, "Pasted 4 ends \xC3\x97 1 pick; 1 treadle added");
}

TEST(SelectTool, NamesShaftsAndTreadlesThatAnEditAdded) {
  draft::Draft before = straight_twill(8, 6).draft, after = before;
  EXPECT_EQ(with_added("Weave", before, after), "Weave");
  after.treadles += 2;
  EXPECT_EQ(with_added("Weave", before, after), "Weave; 2 treadles added");
  after.shafts += 1;
  EXPECT_EQ(with_added("Weave", before, after), "Weave; 1 shaft added; 2 treadles added");
  EXPECT_EQ(with_added("Weave", after, before), "Weave") << "none was added";
  after.shed_control = draft::ShedControl::kLiftplan;
  EXPECT_EQ(with_added("Weave", before, after), "Weave; 1 shaft added") << "a liftplan shows no treadles";
}

TEST(SelectTool, WhatTheLoomCannotWeaveIsNotSaidToBePasted) {
  Design start = straight_twill(8, 6);
  start.loom.shafts = start.draft.shafts, start.loom.treadles = start.draft.treadles;
  SelectState s;
  hold_block(s, start.draft, plain_pick(), false);
  const MaybeEdit edit = drop_block(s, start, false);
  ASSERT_TRUE(edit) << "the closest weave is offered for it";
  EXPECT_EQ(edit->apply(start), start);
  EXPECT_EQ(s.notice, "");
  EXPECT_NE(s.refusal, "");
}

TEST(SelectTool, ALockedGridTakesNoPasteAndItsMarksStay) {
  Design start = straight_twill(8, 6);
  start.loom.leading = design::Leading::kDrawdown;
  start.loom.locked = true;
  SelectState s;
  hold_block(s, start.draft, {BitGrid::kThreading, BitMatrix(3, 4)}, false);
  EXPECT_FALSE(drop_block(s, start, false));
  EXPECT_TRUE(s.held) << "it can be placed elsewhere";
  EXPECT_EQ(s.notice, "");
  EXPECT_EQ(s.refusal, "This follows the drawdown and is locked.");
  s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  EXPECT_FALSE(move_selection(s, start, 3, 0, false));
  EXPECT_EQ(s.selected.a0, 0) << "the selection does not leave its marks";
  EXPECT_EQ(s.refusal, "This follows the drawdown and is locked.");
  const Edit clear = unless_locked(BitGrid::kThreading, {"Delete", [](Design d) { return d; }});
  EXPECT_EQ(clear.why(start), "This follows the drawdown and is locked.");
}

TEST(SelectTool, AnActiveBlockRotatesAsSeenOnTheScreen) {
  const Design start = straight_twill(8, 6);
  SelectState s;
  hold_block(s, start.draft, {BitGrid::kThreading, cells_of(start.draft, {BitGrid::kThreading, 0, 3, 0, 4})}, false);
  turn_held_block(s, mirrored_across);
  hold_block_over(s, BitGrid::kThreading, {0, 0});
  Design now = drop_block(s, start, true)->apply(start);
  EXPECT_EQ(now.draft.threading.first(0), 2);
  EXPECT_EQ(now.draft.threading.first(2), 0);
  hold_block_over(s, BitGrid::kTreadling, {0, 0});
  turn_held_block(s, mirrored_down);
  now = drop_block(s, start, false)->apply(start);
  EXPECT_EQ(now.draft.treadling.first(0), 0) << "there and back";
  EXPECT_EQ(now.draft.treadling.first(2), 2);
}

TEST(SelectTool, EscapeDuringADragReturnsTheMarks) {
  const Design start = straight_twill(8, 6);
  SelectState s = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  s.drag = SelectDrag::kMove;
  const MaybeEdit away = move_selection(s, start, 3, 0, false);
  const Design now = away->apply(start);
  const MaybeEdit home = cancel_drag(s, now);
  ASSERT_TRUE(home.has_value());
  EXPECT_EQ(home->apply(now), start);
  EXPECT_EQ(home->stroke, away->stroke) << "the history forgets the move";
  EXPECT_EQ(s.selected.a0, 0);
  EXPECT_FALSE(cancel_drag(s, start).has_value());
}

TEST(SelectTool, CountsCrossingsThatCouldNotFollow) {
  SelectState s;
  BitMatrix torn(1, 5);
  torn.set(0, 0, true);  // end 1 up, end 5 on the same shaft down
  hold_block(s, straight_twill(8, 6).draft, {BitGrid::kDrawdown, torn}, false);
  drop_block(s, straight_twill(8, 6), false);
  EXPECT_NE(s.notice.find("1 crossing could not follow"), std::string::npos) << s.notice;
}

TEST(SelectTool, AMoveTellsTheCrossingsThatCouldNotFollow) {
  const Design start = straight_twill(8, 6);
  DocumentView view;
  view.select = with_selected({BitGrid::kDrawdown, 0, 1, 0, 1});
  view.select.drag = SelectDrag::kMove;
  // To end 5, which is on the shaft of end 1: the crossing that it left cannot stay down.
  const MaybeEdit away = move_selection(view.select, start, 4, 0, false);
  ASSERT_TRUE(away.has_value());
  const Design now = away->apply(start);
  EXPECT_EQ(view.select.refusal, "") << "not before the drag ends";
  end_drag(view, now);
  EXPECT_EQ(view.select.drag, SelectDrag::kNone);
  EXPECT_NE(view.select.refusal.find("Move selection: 1 crossing could not follow"), std::string::npos)
      << view.select.refusal;
  EXPECT_EQ(missed_by_move(view.select, straight_twill(12, 6)), "") << "the draft is another one";
  view.select = with_selected({BitGrid::kThreading, 0, 2, 0, 4});
  const Design moved = move_selection(view.select, start, 3, 0, false)->apply(start);
  EXPECT_EQ(missed_by_move(view.select, moved), "") << "the threading takes any marks";
}

TEST(SelectTool, ALiftplanBlockIsPastedIntoAShownGrid) {
  SelectState s;
  hold_block(s, straight_twill(8, 6).draft, {BitGrid::kLiftplan, BitMatrix(2, 2)}, false);
  EXPECT_TRUE(is_shown(straight_twill(8, 6).draft, s.held->grid));
  follow_design(s, to_liftplan(straight_twill(8, 6)), 1);
  EXPECT_TRUE(is_shown(to_liftplan(straight_twill(8, 6)).draft, s.held->grid));
}

TEST(SelectTool, DescribesTheSelection) {
  EXPECT_EQ(selection_text(with_selected({BitGrid::kThreading, 2, 10, 0, 1}))
                .rfind("8 ends \xC3\x97 1 shaft: ends 3\xE2\x80\x93"
                       "10, shaft 1    drag",
                       0),
            0u);
  EXPECT_EQ(selection_text({}), "");
}

}  // namespace
}  // namespace weftlight::session
