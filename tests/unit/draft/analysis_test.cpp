#include "draft/analysis.h"

#include <gtest/gtest.h>

#include "hand_drafts.h"

namespace weftlight::draft {
namespace {

void expect_floats(const Rows& rows, int warp_front, int warp_back, int weft_front, int weft_back) {
  const LongestFloats f = longest_floats(matrix_of(rows));
  EXPECT_EQ(f.warp_front, warp_front);
  EXPECT_EQ(f.warp_back, warp_back);
  EXPECT_EQ(f.weft_front, weft_front);
  EXPECT_EQ(f.weft_back, weft_back);
}

TEST(Floats, PlainWeaveHasOnes) { expect_floats({"10", "01"}, 1, 1, 1, 1); }

TEST(Floats, DenimIsThreeOverOne) { expect_floats({"1110", "0111", "1011", "1101"}, 3, 1, 1, 3); }

TEST(Floats, RunOverTheEdgeOfTheRepeat) {
  // End 1 is up on the last two picks and the first: one float of three.
  expect_floats({"10000", "00111", "01010", "10101", "11000"}, 3, 3, 4, 3);
}

TEST(Floats, NeverBoundIsAsLongAsTheCloth) {
  expect_floats({"111", "111"}, 2, 0, 0, 3);
  expect_floats({"000", "000"}, 0, 2, 3, 0);
  expect_floats({"1"}, 1, 0, 0, 1);
}

int slow_run_down(const BitMatrix& m, bool of) {
  int longest = 0;
  for (int c = 0; c < m.cols(); ++c) {
    for (int start = 0; start < m.rows(); ++start) {
      int run = 0;
      while (run < m.rows() && m.get((start + run) % m.rows(), c) == of) ++run;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST(Floats, AgreeWithCountingOnRandomCloth) {
  std::mt19937 random(29);
  for (int round = 0; round < 200; ++round) {
    BitMatrix m(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 70));
    fill_randomly(m, random, 0.05 + 0.9 * (round % 10) / 9);
    const LongestFloats f = longest_floats(m);
    ASSERT_EQ(f.warp_front, slow_run_down(m, true));
    ASSERT_EQ(f.warp_back, slow_run_down(m, false));
    ASSERT_EQ(f.weft_front, slow_run_down(transposed(m), false));
    ASSERT_EQ(f.weft_back, slow_run_down(transposed(m), true));
  }
}

TEST(Repeats, OfStructure) {
  const Repeat twill = structure_repeat(matrix_of({"11001100", "01100110", "00110011", "10011001"}));
  EXPECT_EQ(twill.ends, 4);
  EXPECT_EQ(twill.picks, 4);
  const Repeat odd = structure_repeat(matrix_of({"10101", "01010"}));
  EXPECT_EQ(odd.ends, 5) << "two does not divide five";
  EXPECT_EQ(odd.picks, 2);
}

TEST(Repeats, OfDesignHoldColoursYarnsAndSett) {
  Design d;
  d.draft = treadled({"10", "01", "10", "01", "10", "01", "10", "01"}, {"10", "01"}, {"10", "01", "10", "01"});
  const BitMatrix cells = drawdown(d.draft);
  EXPECT_EQ(design_repeat(d, cells).ends, 2);
  Design colour = d;
  colour.draft.warp.color = {0, 0, 1, 1, 0, 0, 1, 1};
  EXPECT_EQ(design_repeat(colour, cells).ends, 4);
  colour.draft.palette[1] = colour.draft.palette[0];
  EXPECT_EQ(design_repeat(colour, cells).ends, 2) << "colours that look alike are alike";
  Design yarn = d;
  yarn.yarns.emplace_back().diameter_mm = 2;
  yarn.draft.warp.yarn[3] = 1;
  EXPECT_EQ(design_repeat(yarn, cells).ends, 8);
  Design thick = d;
  thick.draft.weft.thickness_mm[0] = 1;
  EXPECT_EQ(design_repeat(thick, cells).picks, 4);
  Design spaced = d;
  spaced.draft.weft.spacing_mm = {1, 2, 1, 2};
  EXPECT_EQ(design_repeat(spaced, cells).picks, 2);
}

TEST(WarpShare, CountsCrossings) {
  EXPECT_DOUBLE_EQ(warp_up_share(matrix_of({"1110", "0111"})), 0.75);
  EXPECT_DOUBLE_EQ(warp_up_share(BitMatrix()), 0.0);
}

}  // namespace
}  // namespace weftlight::draft
