// Heddles, interlacing and sett, against drafts counted by hand.

#include "analysis/threads.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"

namespace weftlight::analysis {

using design::matrix_of, design::treadled;
using draft::BitMatrix, draft::Draft;

namespace {

TEST(LoomUse, CountsHeddlesLiftsAndTreadles) {
  const Draft d = treadled({"100", "010", "100", "000", "011"}, {"110", "001", "000"}, {"100", "110", "001"});
  const LoomUse use = loom_use(d);
  EXPECT_EQ(use.heddles, (std::vector<int>{2, 2, 1}));
  EXPECT_EQ(use.lifts, (std::vector<int>{2, 2, 1}));
  EXPECT_EQ(use.treadle_uses, (std::vector<int>{2, 1, 1}));
  EXPECT_EQ(use.unthreaded_ends, 1);
  EXPECT_EQ(use.ends_in_several, 1);
  EXPECT_EQ(use.empty_picks, 1);
  EXPECT_EQ(use.most_treadles_per_pick, 2);
}

TEST(Interlacing, OfPlainWeaveAndTwill) {
  const Interlacing plain = interlacing(matrix_of({"10", "01"}));
  EXPECT_DOUBLE_EQ(plain.warp, 1);
  EXPECT_DOUBLE_EQ(plain.weft, 1);
  EXPECT_DOUBLE_EQ(interlacing(matrix_of({"1100", "0110", "0011", "1001"})).warp, 0.5);
  EXPECT_DOUBLE_EQ(interlacing(matrix_of({"1110", "0111", "1011", "1101"})).weft, 0.5);
  EXPECT_DOUBLE_EQ(interlacing(matrix_of({"11", "11"})).warp, 0);
}

TEST(Sett, IsHalfTheWrapsInPlainWeaveAndTwoThirdsInTwill) {
  EXPECT_DOUBLE_EQ(wraps_per_cm(0.5f), 20);
  EXPECT_DOUBLE_EQ(sett_per_cm(20, 1), 10);
  EXPECT_NEAR(sett_per_cm(20, 0.5), 13.333, 1e-3);
  EXPECT_EQ(wraps_per_cm(0), 0);
}

TEST(Sett, OfDoubleClothIsThatOfBothLayers) {
  const BitMatrix plain = matrix_of({"10", "01"});
  EXPECT_DOUBLE_EQ(firm_sett_per_cm(plain, weave_layers(plain), 20), 10);
  // Two layers of plain weave, end by end and pick by pick: the upper ends are up while the lower layer is woven.
  const BitMatrix both = matrix_of({"1000", "1110", "0010", "1011"});
  ASSERT_EQ(weave_layers(both).size(), 2u);
  EXPECT_DOUBLE_EQ(firm_sett_per_cm(both, weave_layers(both), 20), 20);
}

}  // namespace
}  // namespace weftlight::analysis
