#include "design/repeat.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"

namespace weftlight::design {

using draft::BitMatrix, draft::drawdown;

namespace {

TEST(Repeats, OfStructure) {
  const Repeat twill = structure_repeat(matrix_of({"11001100", "01100110", "00110011", "10011001"}));
  EXPECT_EQ(twill.ends, 4);
  EXPECT_EQ(twill.picks, 4);
  const Repeat odd = structure_repeat(matrix_of({"10101", "01010"}));
  EXPECT_EQ(odd.ends, 5) << "two does not divide five";
  EXPECT_EQ(odd.picks, 2);
}

TEST(Repeats, OfDesignIncludeColoursYarnsAndSett) {
  Design d;
  d.draft = treadled({"10", "01", "10", "01", "10", "01", "10", "01"}, {"10", "01"}, {"10", "01", "10", "01"});
  const BitMatrix cells = drawdown(d.draft);
  EXPECT_EQ(design_repeat(d, cells).ends, 2);
  Design colour = d;
  colour.draft.warp.color = {0, 0, 1, 1, 0, 0, 1, 1};
  EXPECT_EQ(design_repeat(colour, cells).ends, 4);
  colour.draft.palette[1] = colour.draft.palette[0];
  EXPECT_EQ(design_repeat(colour, cells).ends, 2) << "equal colours count as one";
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

TEST(WarpUpFraction, CountsCrossings) {
  EXPECT_DOUBLE_EQ(warp_up_fraction(matrix_of({"1110", "0111"})), 0.75);
  EXPECT_DOUBLE_EQ(warp_up_fraction(BitMatrix()), 0.0);
}

}  // namespace
}  // namespace weftlight::design
