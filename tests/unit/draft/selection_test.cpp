#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "design/selection_edits.h"
#include "draft/block_text.h"

namespace weftlight::design {

using base::problem_of;
using draft::BitGrid, draft::BitMatrix, draft::CellBlock, draft::Draft, draft::Rgb, draft::Selection,
    draft::ShedControl, draft::Write, draft::block_text, draft::cells_of, draft::columns_of, draft::drawdown,
    draft::missed_cells, draft::read_block_text, draft::rows_of, draft::turned_for, draft::whole_grid,
    draft::with_cells;

namespace {

/// Ends 1 to 6 on shafts 1 2 3 4 1 2, a 2/2 twill; end i has colour i, pick p colour p.
Design twill_design() {
  Design design;
  Draft& d = design.draft;
  d = treadled({"1000", "0100", "0010", "0001", "1000", "0100"}, {"1100", "0110", "0011", "1001"},
               {"1000", "0100", "0010", "0001", "1000"});
  d.palette.assign(6, Rgb{});
  for (int i = 0; i < 6; ++i) d.warp.color[i] = i;
  for (int i = 0; i < 5; ++i) d.weft.color[i] = i;
  return design;
}

Rows threading(const Design& d) { return text_of(d.draft.threading); }
Rows treadling(const Design& d) { return text_of(d.draft.treadling); }
Rows cloth(const Design& d) { return text_of(drawdown(d.draft)); }
constexpr Selection kFirstThreeEnds{BitGrid::kThreading, 0, 3, 0, 4};

TEST(Selection, ReadsTheCellsOfEachGrid) {
  const Draft d = twill_design().draft;
  EXPECT_EQ(text_of(cells_of(d, {BitGrid::kThreading, 1, 4, 1, 4})), (Rows{"100", "010", "001"}));
  EXPECT_EQ(cells_of(d, {BitGrid::kTieup, 0, 2, 0, 3}), matrix_of({"10", "11", "01"})) << "nothing beyond its columns";
  EXPECT_EQ(text_of(cells_of(d, {BitGrid::kTreadling, 0, 4, 3, 5})), (Rows{"0001", "1000"}));
  const Rows all = text_of(drawdown(d));
  EXPECT_EQ(text_of(cells_of(d, {BitGrid::kDrawdown, 2, 5, 1, 3})), (Rows{all[1].substr(2, 3), all[2].substr(2, 3)}));
  EXPECT_EQ(cells_of(d, {BitGrid::kThreading, 7, 9, 0, 4}), BitMatrix()) << "empty outside the grid";
}

TEST(Selection, PastedEndsLeaveTheirOtherShafts) {
  const BitMatrix block = matrix_of({"1010", "0101"});  // ends on shafts 1 2 1 2
  const Design on = with_block(twill_design(), BitGrid::kThreading, 2, 2, block, Write::kThreads);
  EXPECT_EQ(threading(on), (Rows{"1000", "0100", "0010", "0001", "0010", "0001"}));
  const Design inside = with_block(twill_design(), BitGrid::kThreading, 2, 2, block, Write::kInside);
  EXPECT_EQ(threading(inside), (Rows{"1000", "0100", "0010", "0001", "1010", "0101"}));
  const Design added = with_block(twill_design(), BitGrid::kThreading, 0, 0, block, Write::kAdd);
  EXPECT_EQ(threading(added)[2], "1010");
  EXPECT_EQ(threading(added)[0], "1000");
  const Design erased =
      with_block(twill_design(), BitGrid::kThreading, 0, 0, matrix_of({"1010", "0101"}), Write::kErase);
  EXPECT_EQ(threading(erased), (Rows{"0000", "0000", "0010", "0001", "1000", "0100"})) << "only the cells of its marks";
  const Design raised = with_block(twill_design(), BitGrid::kLiftplan, 0, 0, matrix_of({"1000"}), Write::kErase);
  EXPECT_EQ(raised.draft.liftplan.row(0)[0], 0b0010u);
}

TEST(Selection, BlocksAreClippedToTheGrid) {
  const BitMatrix block = matrix_of({"1111", "0000", "0000", "0000"});
  EXPECT_EQ(threading(with_block(twill_design(), BitGrid::kThreading, 4, 0, block, Write::kThreads)),
            (Rows{"1000", "0100", "0010", "0001", "1000", "1000"}));
  EXPECT_EQ(threading(with_block(twill_design(), BitGrid::kThreading, -3, 0, block, Write::kThreads))[0], "1000");
  for (int far : {-100, 100, 1 << 30})
    EXPECT_EQ(with_block(twill_design(), BitGrid::kTieup, far, far, block, Write::kInside), twill_design());
}

TEST(Selection, ADrawdownIsNotWrittenAsCells) {
  const Draft d = twill_design().draft;
  EXPECT_EQ(with_cells(d, BitGrid::kDrawdown, 0, 0, matrix_of({"01", "10"}), Write::kInside), d);
}

TEST(Selection, CrossingsFollowTheThreadingAndReportTheRest) {
  Design d = twill_design();
  // Ends 1 and 5 share shaft 1.
  const Design up = with_block(d, BitGrid::kDrawdown, 0, 2, matrix_of({"1"}), Write::kInside);
  EXPECT_EQ(up.draft.shed_control, ShedControl::kTreadling);
  Rows expected = cloth(d);
  EXPECT_EQ(expected[2][0], '0');
  expected[2][0] = expected[2][4] = '1';
  EXPECT_EQ(cloth(up), expected);
  EXPECT_EQ(missed_cells(up.draft, BitGrid::kDrawdown, 0, 2, matrix_of({"1"})), 0);

  const BitMatrix torn = matrix_of({"10001"});  // as threaded; then end 5 alone down
  EXPECT_EQ(
      missed_cells(with_block(d, BitGrid::kDrawdown, 0, 2, torn, Write::kInside).draft, BitGrid::kDrawdown, 0, 2, torn),
      0);
  const BitMatrix against = matrix_of({"10000"});
  EXPECT_EQ(missed_cells(with_block(d, BitGrid::kDrawdown, 0, 2, against, Write::kInside).draft, BitGrid::kDrawdown, 0,
                         2, against),
            1);

  const BitMatrix same = cells_of(d.draft, whole_grid(d.draft, BitGrid::kDrawdown));
  EXPECT_EQ(with_block(d, BitGrid::kDrawdown, 0, 0, same, Write::kInside), d)
      << "an edit without effect keeps the treadles";
}

TEST(Selection, CrossingsArePastedIntoASinkingShed) {
  Design d = with_block(twill_design(), BitGrid::kDrawdown, 0, 0, matrix_of({"0"}), Write::kInside);
  d.draft.rising = false;
  const BitMatrix block = matrix_of({"1001", "0110"});
  const Design pasted = with_block(d, BitGrid::kDrawdown, 0, 0, block, Write::kInside);
  EXPECT_EQ(cells_of(pasted.draft, {BitGrid::kDrawdown, 0, 4, 0, 2}), block);
}

TEST(Selection, AThreadingBecomesTheTreadlingThatWeavesAsDrawnIn) {
  const CellBlock block{BitGrid::kThreading, matrix_of({"1001", "0110"})};
  EXPECT_EQ(turned_for(block, BitGrid::kTreadling), matrix_of({"10", "01", "01", "10"}));
  EXPECT_EQ(turned_for(block, BitGrid::kThreading), block.cells);
  EXPECT_EQ(turned_for(block, BitGrid::kDrawdown), block.cells);
  EXPECT_EQ(turned_for({BitGrid::kLiftplan, block.cells}, BitGrid::kTreadling), block.cells);
}

TEST(SelectionEdits, ClearInvertAndMove) {
  EXPECT_EQ(threading(with_cleared(twill_design(), {BitGrid::kThreading, 1, 3, 0, 4})),
            (Rows{"1000", "0000", "0000", "0001", "1000", "0100"}));
  EXPECT_EQ(text_of(with_inverted(twill_design(), {BitGrid::kTieup, 0, 1, 0, 4}).draft.tieup)[0], "0011");
  const Design moved = with_moved(twill_design(), {BitGrid::kThreading, 0, 2, 0, 2}, 3, 2);
  EXPECT_EQ(threading(moved), (Rows{"0000", "0000", "0010", "0010", "0001", "0100"}));
  EXPECT_EQ(threading(with_moved(twill_design(), {BitGrid::kThreading, 0, 2, 0, 2}, 3, 2, true))[0], "1000")
      << "a copy stays";
  EXPECT_EQ(moved.draft.warp, twill_design().draft.warp);
  EXPECT_EQ(with_moved(twill_design(), kFirstThreeEnds, 0, 0), twill_design());
}

TEST(SelectionEdits, MirroringWholeEndsTakesTheirColoursAlong) {
  const Design mirrored = with_mirrored_across(twill_design(), kFirstThreeEnds);
  EXPECT_EQ(threading(mirrored), (Rows{"0010", "0100", "1000", "0001", "1000", "0100"}));
  EXPECT_EQ(mirrored.draft.warp.color, (std::vector<int>{2, 1, 0, 3, 4, 5}));
  const Design marks_only = with_mirrored_across(twill_design(), kFirstThreeEnds, false);
  EXPECT_EQ(marks_only.draft.threading, mirrored.draft.threading);
  EXPECT_EQ(marks_only.draft.warp, twill_design().draft.warp);
  const Design part = with_mirrored_across(twill_design(), {BitGrid::kThreading, 0, 2, 0, 2});
  EXPECT_EQ(threading(part)[0], "0100");
  EXPECT_EQ(part.draft.warp, twill_design().draft.warp) << "some of the shafts are not whole threads";
  EXPECT_EQ(with_mirrored_across(mirrored, kFirstThreeEnds), twill_design());
}

TEST(SelectionEdits, MirrorsAndHalfTurns) {
  EXPECT_EQ(threading(with_mirrored_down(twill_design(), kFirstThreeEnds)),
            (Rows{"0001", "0010", "0100", "0001", "1000", "0100"}));
  const Selection picks{BitGrid::kTreadling, 0, 4, 0, 4};
  const Design down = with_mirrored_down(twill_design(), picks);
  EXPECT_EQ(treadling(down), (Rows{"0001", "0010", "0100", "1000", "1000"}));
  EXPECT_EQ(down.draft.weft.color, (std::vector<int>{3, 2, 1, 0, 4}));
  EXPECT_EQ(text_of(with_half_turn(twill_design(), {BitGrid::kTieup, 0, 2, 0, 4}).draft.tieup),
            (Rows{"0110", "0011", "0011", "1001"}));
  const Design half = with_half_turn(twill_design(), picks);
  EXPECT_EQ(treadling(half), (Rows{"1000", "0100", "0010", "0001", "1000"}));
  EXPECT_EQ(half.draft.weft.color, (std::vector<int>{3, 2, 1, 0, 4}));
}

TEST(SelectionEdits, ShiftsWrapInsideTheSelection) {
  const Design right = with_shifted(twill_design(), kFirstThreeEnds, 1, 0);
  EXPECT_EQ(threading(right), (Rows{"0010", "1000", "0100", "0001", "1000", "0100"}));
  EXPECT_EQ(right.draft.warp.color, (std::vector<int>{2, 0, 1, 3, 4, 5}));
  EXPECT_EQ(with_shifted(right, kFirstThreeEnds, -1, 0), twill_design());
  EXPECT_EQ(threading(with_shifted(twill_design(), kFirstThreeEnds, 0, 1)),
            (Rows{"0100", "0010", "0001", "0001", "1000", "0100"}));
  EXPECT_EQ(threading(with_shifted(twill_design(), {BitGrid::kThreading, 0, 2, 0, 2}, 1, 0)),
            (Rows{"0100", "1000", "0010", "0001", "1000", "0100"}));
  EXPECT_EQ(treadling(with_shifted(twill_design(), {BitGrid::kTreadling, 0, 4, 0, 5}, 0, -1)),
            (Rows{"0100", "0010", "0001", "1000", "1000"}));
}

TEST(SelectionEdits, RepeatsFillTheRestOrAll) {
  const Selection two{BitGrid::kThreading, 1, 3, 0, 4};
  EXPECT_EQ(threading(with_repeated(twill_design(), two, RepeatExtent::kToEnd)),
            (Rows{"1000", "0100", "0010", "0100", "0010", "0100"}));
  const Design all = with_repeated(twill_design(), two, RepeatExtent::kAll);
  EXPECT_EQ(threading(all), (Rows{"0010", "0100", "0010", "0100", "0010", "0100"}));
  EXPECT_EQ(all.draft.warp.color, (std::vector<int>{2, 1, 2, 1, 2, 1}));
  EXPECT_EQ(text_of(with_repeated(twill_design(), {BitGrid::kTieup, 0, 2, 0, 2}, RepeatExtent::kAll).draft.tieup),
            (Rows{"1111", "0101", "1111", "0101"}));
  const Design plain = with_repeated(twill_design(), {BitGrid::kDrawdown, 0, 2, 0, 2}, RepeatExtent::kToEnd);
  EXPECT_EQ(plain.draft.shed_control, ShedControl::kTreadling);
}

TEST(SelectionEdits, APlainWeaveRepeatedOverTheDrawdown) {
  Design d = twill_design();
  d = with_block(std::move(d), BitGrid::kDrawdown, 0, 0, matrix_of({"10", "01"}), Write::kInside);
  d = with_repeated(std::move(d), {BitGrid::kDrawdown, 0, 2, 0, 2}, RepeatExtent::kAll);
  EXPECT_EQ(cloth(d), (Rows{"101010", "010101", "101010", "010101", "101010"}));
}

TEST(SelectionEdits, AnEmptyOrInvalidSelectionChangesNothing) {
  const Design d = twill_design();
  for (const Selection& s : {Selection{}, Selection{BitGrid::kThreading, 9, 12, 0, 4},
                             Selection{BitGrid::kTieup, 3, 1, 0, 4}, Selection{BitGrid::kDrawdown, -5, 0, 0, 4}}) {
    EXPECT_EQ(with_cleared(d, s), d);
    EXPECT_EQ(with_inverted(d, s), d);
    EXPECT_EQ(with_moved(d, s, 1, 1), d);
    EXPECT_EQ(with_mirrored_across(d, s), d);
    EXPECT_EQ(with_mirrored_down(d, s), d);
    EXPECT_EQ(with_half_turn(d, s), d);
    EXPECT_EQ(with_shifted(d, s, 1, 1), d);
    EXPECT_EQ(with_repeated(d, s, RepeatExtent::kAll), d);
  }
}

TEST(SelectionEdits, EditsKeepADraftConsistentAndMirrorsAreInvolutions) {
  std::mt19937 random(20261121);
  for (int round = 0; round < 200; ++round) {
    Design d;
    d.draft = random_draft(random, 1 + static_cast<int>(random() % 90), 1 + static_cast<int>(random() % 20), 7, 5);
    const BitGrid grid = static_cast<BitGrid>(random() % 4);
    if (grid == BitGrid::kLiftplan) d.draft.shed_control = ShedControl::kLiftplan;
    const int columns = columns_of(d.draft, grid), rows = rows_of(d.draft, grid);
    Selection s{grid, static_cast<int>(random() % static_cast<unsigned>(columns)), columns,
                static_cast<int>(random() % static_cast<unsigned>(rows)), rows};
    EXPECT_EQ(with_mirrored_across(with_mirrored_across(d, s), s), d);
    EXPECT_EQ(with_mirrored_down(with_mirrored_down(d, s), s), d);
    EXPECT_EQ(with_half_turn(with_half_turn(d, s), s), d);
    EXPECT_EQ(with_inverted(with_inverted(d, s), s), d);
    EXPECT_EQ(with_shifted(with_shifted(d, s, 3, -2), s, -3, 2), d);
    EXPECT_TRUE(is_consistent(with_repeated(d, s, RepeatExtent::kAll)));
    EXPECT_TRUE(is_consistent(with_moved(d, s, -1, 2)));
  }
}

TEST(BlockText, RoundTrips) {
  const CellBlock block{BitGrid::kTreadling, matrix_of({"1010", "0000", "0111"})};
  EXPECT_EQ(block_text(block), "weftlight cells: treadling, 4 x 3\n#.#.\n....\n.###\n");
  EXPECT_EQ(*read_block_text(block_text(block)), block);
  for (BitGrid grid :
       {BitGrid::kThreading, BitGrid::kTieup, BitGrid::kTreadling, BitGrid::kLiftplan, BitGrid::kDrawdown})
    EXPECT_EQ(read_block_text(block_text({grid, block.cells}))->from, grid);
  EXPECT_EQ(block_text({}), "");
  EXPECT_EQ(block_text({BitGrid::kDrawdown, BitMatrix(4096, 1025)}), "");
}

TEST(BlockText, AcceptsHandwrittenAndSpreadsheetText) {
  const BitMatrix cells = matrix_of({"1001", "0110"});
  for (const char* text :
       {"1001\n0110\n", "#..#\r\n.##.\r\n", "X--X\r-xx-", "1 0 0 1\n0 1 1 0\n", "1\t0\t0\t1\n0\t1\t1\t0\n\n",
        "\xEF\xBB\xBF*__*\n_**_", "weftlight cells: drawdown\n1001\n011\n"}) {
    const base::Result<CellBlock> read = read_block_text(text);
    ASSERT_TRUE(read.has_value()) << text << problem_of(read);
    EXPECT_EQ(read->cells, cells) << text;
    EXPECT_EQ(read->from, BitGrid::kDrawdown);
  }
}

TEST(BlockText, EmptyCellsOfASpreadsheetKeepTheirPlace) {
  EXPECT_EQ(read_block_text("1\t\t\t1\n\t1\t1\t\n")->cells, matrix_of({"1001", "0110"}));
  EXPECT_EQ(read_block_text("\t\t\t\r\nx\t \tx\t\r\n\t\t\t\r\n")->cells, matrix_of({"0000", "1010", "0000"}));
}

TEST(BlockText, RejectsWithAReason) {
  for (const std::string& text :
       {std::string("10\t1\n"), std::string(), std::string("\n\n"), std::string("Dear weaver"),
        std::string("weftlight cells: "), std::string("weftlight cells: warp, 2 x 2\n##\n##\n"),
        std::string("weftlight cells: threading, 9 x 9\n"), std::string("1\0001", 3), std::string("\xFF\xFE"),
        std::string(200000, '1'), std::string(8'000'000, '\n'), std::string(8'000'000, '#'),
        std::string(3'000'000, '\n') + "#"}) {
    const base::Result<CellBlock> read = read_block_text(text);
    EXPECT_FALSE(read.has_value()) << text.substr(0, 40);
    EXPECT_FALSE(problem_of(read).empty());
  }
}

}  // namespace
}  // namespace weftlight::design
