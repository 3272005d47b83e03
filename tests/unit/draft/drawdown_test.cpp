#include "draft/drawdown.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "design/edits.h"

namespace weftlight::design {

using draft::BitMatrix, draft::CellRect, draft::Draft, draft::ShedControl, draft::System, draft::blank_draft,
    draft::complement, draft::differences, draft::drawdown, draft::drawdown_columns, draft::transposed,
    draft::update_drawdown;

namespace {

const Rows kStraight4 = {"1000", "0100", "0010", "0001"};

TEST(Drawdown, PlainWeave) {
  const Draft d = treadled({"10", "01", "10"}, {"10", "01"}, {"10", "01"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"101", "010"}));
}

TEST(Drawdown, TwillLeansToTheRight) {
  const Draft d = treadled(kStraight4, {"1100", "0110", "0011", "1001"}, kStraight4);
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"1100", "0110", "0011", "1001"}));
}

TEST(Drawdown, FiveEndSatin) {
  const Rows five = {"10000", "01000", "00100", "00010", "00001"};
  const Draft d = treadled(five, {"10000", "00100", "00001", "01000", "00010"}, five);
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"10000", "00100", "00001", "01000", "00010"}));
}

TEST(Drawdown, SinkingShedExchangesTheFaces) {
  Draft d = treadled(kStraight4, {"1000", "0100", "0010", "0001"}, kStraight4);
  d.rising = false;
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"0111", "1011", "1101", "1110"}));
}

TEST(Drawdown, UnthreadedEndIsNeverUp) {
  Draft d = treadled({"10", "00", "01"}, {"10", "01"}, {"10", "01", "00", "11"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"100", "001", "000", "101"}));
  d.rising = false;
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"001", "100", "101", "000"}));
}

TEST(Drawdown, EndOnTwoShafts) {
  // Rising: either shaft lifts it. Sinking: either shaft lowers it.
  Draft d = treadled({"11", "10", "01"}, {"10", "01"}, {"10", "01", "00"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"110", "101", "000"}));
  d.rising = false;
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"001", "010", "111"}));
}

TEST(Drawdown, SeveralTreadlesAddUp) {
  const Draft d = treadled(kStraight4, {"1000", "0110", "0001"}, {"110", "101", "111", "000"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"1110", "1001", "1111", "0000"}));
}

TEST(Drawdown, LiftplanAsShedControl) {
  Draft d = treadled(kStraight4, {"1111"}, {"1", "1"});
  d.liftplan = matrix_of({"1010", "0101"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"1111", "1111"}));
  d.shed_control = ShedControl::kLiftplan;
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"1010", "0101"}));
}

TEST(Drawdown, OneByOne) {
  Draft d = treadled({"1"}, {"1"}, {"1"});
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"1"}));
  d.rising = false;
  EXPECT_EQ(text_of(drawdown(d)), (Rows{"0"}));
}

TEST(Drawdown, EmptyDraftsGiveEmptyCloth) {
  EXPECT_EQ(drawdown(blank_draft(0, 0, 0, 0)).count(), 0);
  EXPECT_EQ(drawdown(blank_draft(3, 2, 0, 0)).rows(), 2);
  EXPECT_EQ(drawdown(Draft{}).cols(), 0);
}

TEST(Drawdown, AgreesWithTheDefinitionOnRandomDrafts) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const auto up_to = [&](unsigned n) { return 1 + static_cast<int>(random() % n); };
    const Draft d = random_draft(random, up_to(200), up_to(150), up_to(40), up_to(20));
    ASSERT_EQ(drawdown(d), slow_drawdown(d)) << "round " << round;
  }
}

TEST(Drawdown, TablesAgreeWithTheDefinition) {
  // Many different lifts on few shafts, more ends than a strip holds: the tables are used.
  std::mt19937 random(11);
  for (const bool rising : {true, false}) {
    for (const int shafts : {9, 32, 65}) {
      Draft d = random_draft(random, 2600, 1100, shafts, 1);
      d.shed_control = ShedControl::kLiftplan;
      d.rising = rising;
      ASSERT_EQ(drawdown(d), slow_drawdown(d)) << shafts << " shafts";
    }
  }
}

TEST(Drawdown, PaddingStaysZero) {
  Draft d = treadled({"1", "1", "1"}, {"1"}, {"1", "0"});
  d.rising = false;
  EXPECT_EQ(drawdown(d).count(), 3);
  EXPECT_EQ(complement(drawdown(d)).count(), 3);
}

TEST(Drawdown, BackIsTheComplement) {
  const BitMatrix front = matrix_of({"1100", "0011"});
  EXPECT_EQ(text_of(complement(front)), (Rows{"0011", "1100"}));
  EXPECT_EQ(complement(complement(front)), front);
}

// Every kind of edit that touches the structure, at a random place.
Design edited(const Design& design, std::mt19937& random) {
  const Draft& d = design.draft;
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const bool on = random() % 2 == 0;
  switch (random() % 8) {
    case 0:
      return with_threading(design, below(d.ends()), below(d.shafts), on, random() % 2 == 0);
    case 1:
      return with_tieup(design, below(d.treadles), below(d.shafts), on);
    case 2:
      return with_treadling(design, below(d.picks()), below(d.treadles), on, random() % 2 == 0);
    case 3:
      return random() % 20 == 0 ? with_liftplan(design, below(d.picks()), below(d.shafts), on) : design;
    case 4:
      return random() % 20 == 0 ? to_treadling(design) : design;
    case 5:
      return random() % 20 == 0 ? with_rising(design, on) : design;
    case 6:  // another number of shafts alone
      return random() % 4 == 0 ? with_size(design, d.ends(), d.picks(), 1 + below(90), 7) : design;
    default:
      return random() % 20 == 0 ? with_size(design, 1 + below(90), 1 + below(90), 9, 7) : design;
  }
}

bool all_changes_inside(const BitMatrix& was, const BitMatrix& is, const CellRect& rect) {
  for (int p = 0; p < is.rows(); ++p) {
    for (int e = 0; e < is.cols(); ++e) {
      const bool inside = e >= rect.end0 && e < rect.end1 && p >= rect.pick0 && p < rect.pick1;
      if (!inside && was.get(p, e) != is.get(p, e)) return false;
    }
  }
  return true;
}

TEST(UpdateDrawdown, EqualsAFullDrawdownAfterRandomEdits) {
  std::mt19937 random(3);
  Design design;
  design.draft = random_draft(random, 70, 65, 8, 10);
  BitMatrix cells = drawdown(design.draft);
  for (int round = 0; round < 3000; ++round) {
    const Design next = edited(design, random);
    ASSERT_TRUE(is_consistent(next));
    const BitMatrix was = cells;
    const CellRect rect = update_drawdown(cells, design.draft, next.draft);
    ASSERT_EQ(cells, slow_drawdown(next.draft)) << "round " << round;
    const bool same_size = was.rows() == cells.rows() && was.cols() == cells.cols();
    if (same_size) {
      ASSERT_TRUE(all_changes_inside(was, cells, rect)) << "round " << round;
      ASSERT_EQ(rect.empty(), was == cells);
    } else {
      ASSERT_EQ(rect, (CellRect{0, cells.cols(), 0, cells.rows()}));
    }
    design = next;
  }
}

TEST(Drawdown, ColumnsOfSomeEnds) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    const Draft d = random_draft(random, 40, 70, 6, 7);
    const std::vector<int> ends = {0, 7, 8, 39};
    const BitMatrix all = transposed(drawdown(d)), some = drawdown_columns(d, ends);
    ASSERT_EQ(some.rows(), 4);
    for (int i = 0; i < 4; ++i) ASSERT_EQ(differences(some.row(i), all.row(ends[static_cast<size_t>(i)])), 0) << round;
  }
}

TEST(UpdateDrawdown, OneChangedPickGivesThatPick) {
  Design design;
  design.draft = treadled(kStraight4, {"1100", "0110", "0011", "1001"}, kStraight4);
  BitMatrix cells = drawdown(design.draft);
  const Design next = with_treadling(design, 1, 3, true);
  EXPECT_EQ(update_drawdown(cells, design.draft, next.draft), (CellRect{0, 4, 1, 2}));
  EXPECT_EQ(text_of(cells), (Rows{"1100", "1001", "0011", "1001"}));
}

TEST(UpdateDrawdown, ColourChangesNoCell) {
  Design design;
  design.draft = treadled(kStraight4, {"1100"}, {"1"});
  BitMatrix cells = drawdown(design.draft);
  const Design next = with_thread_color(design, System::kWarp, 0, 1);
  EXPECT_TRUE(update_drawdown(cells, design.draft, next.draft).empty());
}

TEST(BitMatrix, ResizeKeepsWhatBothSizesShare) {
  BitMatrix m(70, 130);
  m.set(3, 64, true);
  m.set(3, 129, true);
  m.set(69, 0, true);
  m.resize(10, 129);
  EXPECT_TRUE(m.get(3, 64));
  EXPECT_EQ(m.count(), 1);
  m.resize(70, 200);
  EXPECT_EQ(m.count(), 1) << "cells that were cut are empty again";
}

TEST(BitMatrix, TransposeTwiceIsTheSame) {
  std::mt19937 random(5);
  for (const auto& [rows, cols] : {std::pair{1, 1}, {3, 200}, {64, 64}, {65, 127}, {130, 1}, {0, 7}}) {
    BitMatrix m(rows, cols);
    fill_randomly(m, random, 0.4);
    const BitMatrix turned = transposed(m);
    ASSERT_EQ(turned.rows(), cols);
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < cols; ++c) ASSERT_EQ(turned.get(c, r), m.get(r, c));
    }
    EXPECT_EQ(transposed(turned), m);
  }
}

}  // namespace
}  // namespace weftlight::design
