#include "session/editing/shapes.h"

#include <gtest/gtest.h>

#include <random>

#include "../hand_drafts.h"
#include "session/document/document.h"
#include "session/editing/paint.h"
#include "session/editing/selection_state.h"

namespace weftlight::session {

using design::Design, design::Leading, design::straight_twill, design::text_of;
using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::blank_draft, draft::drawdown;

namespace {

std::vector<std::string> rows_of_mask(const CellMask& mask) { return text_of(mask.cells); }
using Rows = std::vector<std::string>;

DocumentView view_with(ActiveShape shape) {
  DocumentView v;
  v.drawing.shape = shape;
  return v;
}

Design drawn(const Design& d, DocumentView& v) {
  const MaybeEdit edit = finish_shape(v, d);
  EXPECT_FALSE(v.drawing.shape) << "it is no longer in hand";
  return edit ? edit->apply(d) : d;
}

TEST(Shapes, ALineInTheThreadingHasOneShaftPerEnd) {
  // Steep: elsewhere it would take several shafts of an end.
  EXPECT_EQ(rows_of_mask(cells_of_shape(Tool::kLine, GridId::kThreading, {2, 0}, {4, 6})),
            (Rows{"100", "000", "000", "010", "000", "000", "001"}));
  EXPECT_EQ(cells_of_shape(Tool::kLine, GridId::kThreading, {3, 1}, {3, 5}).cells.count(), 1) << "one end, one shaft";
  // In the treadling one treadle of each pick; in the tie-up without gaps.
  EXPECT_EQ(rows_of_mask(cells_of_shape(Tool::kLine, GridId::kTreadling, {0, 5}, {6, 7})),
            (Rows{"1000000", "0001000", "0000001"}));
  EXPECT_EQ(cells_of_shape(Tool::kLine, GridId::kTieup, {0, 0}, {2, 6}).cells.count(), 7);

  Design d = straight_twill(6, 5);
  d.draft.threading.set(1, 3, true);  // also on another shaft
  DocumentView v = view_with({Tool::kLine, GridId::kThreading, {0, 3}, {3, 0}, true});
  const Design after = drawn(d, v);
  for (int end = 0; end < 4; ++end) {
    EXPECT_TRUE(after.draft.threading.get(end, 3 - end));
    EXPECT_EQ(std::popcount(after.draft.threading.row(end)[0]), 1) << "end " << end + 1 << " is on one shaft";
  }
  EXPECT_TRUE(after.draft.threading.get(4, 0)) << "the others stay";
}

TEST(Shapes, RectanglesAreOutlinedOrFilledAndClearIfBegunOnAMark) {
  EXPECT_EQ(rows_of_mask(cells_of_shape(Tool::kRectangle, GridId::kTieup, {4, 3}, {1, 0})),
            (Rows{"1111", "1001", "1001", "1111"}));
  EXPECT_EQ(cells_of_shape(Tool::kFilledRectangle, GridId::kTieup, {4, 3}, {1, 0}).cells.count(), 16);
  Design d;
  d.draft = blank_draft(6, 6, 6, 6);
  DocumentView v = view_with({Tool::kFilledRectangle, GridId::kTieup, {0, 0}, {5, 5}, true});
  d = drawn(d, v);
  v.drawing.shape = ActiveShape{Tool::kRectangle, GridId::kTieup, {1, 1}, {4, 4}, false};
  d = drawn(d, v);
  EXPECT_EQ(text_of(d.draft.tieup), (Rows{"111111", "100001", "101101", "101101", "100001", "111111"}));
}

TEST(Shapes, ShiftKeepsLinesToEightDirectionsAndRectanglesSquare) {
  EXPECT_EQ(constrained(Tool::kLine, {5, 5}, {15, 7}, 20, 20), (Cell{15, 5}));
  EXPECT_EQ(constrained(Tool::kLine, {5, 5}, {4, 15}, 20, 20), (Cell{5, 15}));
  EXPECT_EQ(constrained(Tool::kLine, {5, 5}, {10, 9}, 20, 20), (Cell{10, 10}));
  EXPECT_EQ(constrained(Tool::kLine, {5, 5}, {0, 9}, 20, 20), (Cell{0, 10}));
  EXPECT_EQ(constrained(Tool::kLine, {5, 5}, {12, 10}, 20, 8), (Cell{7, 7})) << "no further than there is room";
  EXPECT_EQ(constrained(Tool::kRectangle, {5, 5}, {9, 6}, 20, 20), (Cell{9, 9}));
  EXPECT_EQ(constrained(Tool::kRectangle, {5, 5}, {5, 5}, 20, 20), (Cell{5, 5}));
}

TEST(Shapes, CrossingsThatTheLoomCannotWeaveAreCounted) {
  Design d = straight_twill(8, 8);
  d.loom.leading = Leading::kDrawdown;
  DocumentView v = view_with({Tool::kLine, GridId::kDrawdown, {0, 0}, {7, 7}, true});
  const Design line = drawn(d, v);
  const BitMatrix cells = drawdown(line.draft);
  for (int i = 0; i < 8; ++i) EXPECT_TRUE(cells.get(i, i));
  EXPECT_EQ(v.select.notice, "");
  // Threading rules: ends 1 and 5 share a shaft, and one cannot go where the other is.
  d.loom.leading = Leading::kThreading;
  d.draft.threading.set(0, 0, false);  // end 1 is on no shaft
  v.drawing.shape = ActiveShape{Tool::kFilledRectangle, GridId::kDrawdown, {0, 0}, {1, 1}, true};
  drawn(d, v);
  EXPECT_EQ(v.select.notice,
            "Filled rectangle: 2 crossings could not follow, because ends on the same shafts rise together");
}

TEST(Shapes, ALockedGridStaysWithAReason) {
  Design d = straight_twill(6, 5);
  d.loom.leading = Leading::kDrawdown;
  d.loom.locked = true;
  DocumentView v = view_with({Tool::kLine, GridId::kThreading, {0, 0}, {3, 3}, true});
  const MaybeEdit edit = finish_shape(v, d);
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->label, "Draw line");
  EXPECT_EQ(edit->apply(d), d);
  EXPECT_EQ(edit->why(d), "This follows the drawdown and is locked.");
}

TEST(Shapes, AFillCoversTheRegionOfEqualCells) {
  Design d;
  d.draft = blank_draft(6, 6, 6, 6);
  DocumentView v = view_with({Tool::kRectangle, GridId::kTieup, {1, 1}, {4, 4}, true});
  d = drawn(d, v);
  const BitMatrix cells = drawdown(d.draft);
  const CellMask inside = region_about(d.draft, cells, GridId::kTieup, {2, 3});
  EXPECT_EQ(rows_of_mask(inside), (Rows{"000000", "000000", "001100", "001100", "000000", "000000"}));
  const MaybeEdit edit = fill_region(v, d, GridId::kTieup, inside, true);
  const Design filled = edit->apply(d);
  EXPECT_EQ(filled.draft.tieup.count(), 16);
  const CellMask all = region_about(filled.draft, cells, GridId::kTieup, {1, 1});
  EXPECT_EQ(fill_region(v, filled, GridId::kTieup, all, false)->apply(filled).draft.tieup.count(), 0);
  // Diagonal neighbours do not hang together: the outside of the frame is one region, a plain weave's cells are each.
  EXPECT_EQ(region_about(d.draft, cells, GridId::kTieup, {0, 0}).cells.count(), 20);
}

/// Cell by cell.
BitMatrix flooded(const BitMatrix& cells, Cell at) {
  BitMatrix seen(cells.rows(), cells.cols());
  std::vector<Cell> next{at};
  while (!next.empty()) {
    const Cell c = next.back();
    next.pop_back();
    if (c.a < 0 || c.b < 0 || c.a >= cells.cols() || c.b >= cells.rows() || seen.get(c.b, c.a) ||
        cells.get(c.b, c.a) != cells.get(at.b, at.a))
      continue;
    seen.set(c.b, c.a, true);
    for (const Cell n : {Cell{c.a - 1, c.b}, Cell{c.a + 1, c.b}, Cell{c.a, c.b - 1}, Cell{c.a, c.b + 1}})
      next.push_back(n);
  }
  return seen;
}

TEST(Shapes, ARegionIsFourConnected) {
  // Wider than three words, and not whole ones.
  BitMatrix cells(40, 211);
  uint32_t random = 7;
  for (int r = 0; r < cells.rows(); ++r)
    for (int c = 0; c < cells.cols(); ++c) {
      random = random * 1664525u + 1013904223u;
      cells.set(r, c, (random >> 24) % 10 < 6);
    }
  const Draft d = blank_draft(211, 40, 2, 2);
  for (const Cell at :
       {Cell{0, 0}, Cell{210, 39}, Cell{64, 20}, Cell{63, 20}, Cell{127, 5}, Cell{128, 30}, Cell{100, 17}})
    EXPECT_EQ(region_about(d, cells, GridId::kDrawdown, at).cells, flooded(cells, at)) << at.a << ", " << at.b;
}

TEST(Shapes, AFillOfFourMillionCellsFinishes) {
  Design d;
  d.draft = blank_draft(2000, 2000, 2, 2);
  EXPECT_EQ(region_about(d.draft, drawdown(d.draft), GridId::kDrawdown, {1000, 1000}).cells.count(), 4'000'000);
}

TEST(Shapes, AFillMatchesASimpleFloodFillInAnyDrawdown) {
  // Against the plainest search there is: cell by cell.
  std::mt19937 random(7);
  for (const int width : {1, 63, 64, 65, 130, 200}) {
    BitMatrix cells(40, width);
    for (int b = 0; b < 40; ++b)
      for (int a = 0; a < width; ++a) cells.set(b, a, random() % 5 < 2);
    const Draft d = blank_draft(width, 40, 4, 4);
    const Cell at{static_cast<int>(random() % static_cast<unsigned>(width)), 17};
    BitMatrix wanted(40, width);
    std::vector<Cell> open{at};
    wanted.set(at.b, at.a, true);
    while (!open.empty()) {
      const Cell c = open.back();
      open.pop_back();
      for (const Cell n : {Cell{c.a - 1, c.b}, Cell{c.a + 1, c.b}, Cell{c.a, c.b - 1}, Cell{c.a, c.b + 1}}) {
        if (n.a < 0 || n.b < 0 || n.a >= width || n.b >= 40 || wanted.get(n.b, n.a)) continue;
        if (cells.get(n.b, n.a) != cells.get(at.b, at.a)) continue;
        wanted.set(n.b, n.a, true);
        open.push_back(n);
      }
    }
    EXPECT_EQ(region_about(d, cells, GridId::kDrawdown, at).cells, wanted) << width;
  }
}

TEST(Shapes, ColourBarsFillTheRunOfEqualThreads) {
  Design d = straight_twill(8, 5);
  d.draft.palette.resize(3);
  d.draft.warp.color = {0, 1, 1, 1, 0, 1, 1, 0};
  const Design filled = fill_bar_edit(d.draft, GridId::kWarpColors, {2, 0}, BarPaint::kColor, 2).apply(d);
  EXPECT_EQ(filled.draft.warp.color, (std::vector<int>{0, 2, 2, 2, 0, 1, 1, 0}));
}

TEST(Mirrors, TheAxisIsTheMiddleOfTheSelectionOrTheDraft) {
  const Draft d = blank_draft(10, 7, 4, 4);
  DocumentView v;
  EXPECT_FALSE(mirror_of(v.drawing, v.select.selected, d).ends);
  v.drawing.mirror_ends = v.drawing.mirror_picks = true;
  const Mirror whole = mirror_of(v.drawing, v.select.selected, d);
  EXPECT_EQ(images_of(whole, GridId::kThreading, {0, 2}), (std::vector<Cell>{{0, 2}, {9, 2}}));
  EXPECT_EQ(images_of(whole, GridId::kTreadling, {1, 0}), (std::vector<Cell>{{1, 0}, {1, 6}}));
  EXPECT_EQ(images_of(whole, GridId::kDrawdown, {0, 0}), (std::vector<Cell>{{0, 0}, {9, 0}, {0, 6}, {9, 6}}));
  EXPECT_EQ(images_of(whole, GridId::kTieup, {1, 1}).size(), 1u) << "a tie-up has neither ends nor picks";
  v.select.selected = {BitGrid::kThreading, 2, 5, 0, 4};
  const Mirror part = mirror_of(v.drawing, v.select.selected, d);
  EXPECT_EQ(images_of(part, GridId::kThreading, {2, 0})[1], (Cell{4, 0}));
  EXPECT_EQ(images_of(part, GridId::kDrawdown, {2, 0})[2], (Cell{2, 6})) << "the picks about those of the draft";
}

TEST(Mirrors, PenAndShapesDrawOnBothSides) {
  Design d;
  d.draft = blank_draft(8, 8, 4, 4);
  DocumentView v;
  v.drawing.mirror_ends = true;
  const Design painted =
      paint_edit(GridId::kThreading, {0, 0}, {1, 1}, true, true, mirror_of(v.drawing, v.select.selected, d.draft))
          .apply(d);
  EXPECT_EQ(text_of(painted.draft.threading), (Rows{"1000", "0100", "0000", "0000", "0000", "0000", "0100", "1000"}));
  v.drawing.shape = ActiveShape{Tool::kLine, GridId::kThreading, {0, 0}, {3, 3}, true};
  const Design point = drawn(d, v);
  EXPECT_EQ(text_of(point.draft.threading), (Rows{"1000", "0100", "0010", "0001", "0001", "0010", "0100", "1000"}));
}

}  // namespace
}  // namespace weftlight::session
