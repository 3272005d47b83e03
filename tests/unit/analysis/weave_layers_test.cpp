#include "analysis/weave_layers.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"

namespace weftlight::analysis {

using design::fill_randomly, design::matrix_of;
using draft::BitMatrix;

namespace {

TEST(Layers, PlainAndTwillAreConnected) {
  EXPECT_LE(weave_layers(matrix_of({"10", "01"})).size(), 1u);
  EXPECT_LE(weave_layers(matrix_of({"1100", "0110", "0011", "1001"})).size(), 1u);
  EXPECT_LE(weave_layers(BitMatrix()).size(), 1u);
}

TEST(Layers, DoubleClothHasTwoLayers) {
  const auto found = weave_layers(matrix_of({"1000", "1110", "0010", "1011"}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0], (WeaveLayer{{0, 2}, {0, 2}}));
  EXPECT_EQ(found[1], (WeaveLayer{{1, 3}, {1, 3}}));
  EXPECT_FALSE(found[0].loose());
}

TEST(Layers, FindsLoosePickAndLooseEnd) {
  // Pick 3 is over every end; end 3 is under every pick.
  const auto found = weave_layers(matrix_of({"100", "010", "000"}));
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0], (WeaveLayer{{}, {2}}));
  EXPECT_EQ(found[1], (WeaveLayer{{0, 1}, {0, 1}}));
  EXPECT_EQ(found[2], (WeaveLayer{{2}, {}}));
  EXPECT_TRUE(found[0].loose() && found[2].loose());
}

TEST(Layers, WithoutInterlacingAllThreadsAreLoose) {
  EXPECT_EQ(weave_layers(matrix_of({"11", "11"})).size(), 4u);
  EXPECT_EQ(weave_layers(matrix_of({"1"})), (std::vector<WeaveLayer>{{{0}, {}}, {{}, {0}}}));
}

// Threads that reach each other through the relation "lies over" cannot be separated.
int slow_layer_count(const BitMatrix& m) {
  const int ends = m.cols(), n = ends + m.rows();
  std::vector<std::vector<char>> over(n, std::vector<char>(n, 0));
  for (int p = 0; p < m.rows(); ++p) {
    for (int e = 0; e < ends; ++e) (m.get(p, e) ? over[e][ends + p] : over[ends + p][e]) = 1;
  }
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) over[i][j] |= over[i][k] & over[k][j];
    }
  }
  int count = 0;
  for (int i = 0; i < n; ++i) {
    bool first = true;
    for (int j = 0; j < i; ++j) first &= !(over[i][j] && over[j][i]);
    count += first;
  }
  return count;
}

TEST(Layers, AgreeWithReachabilityOnRandomCloth) {
  std::mt19937 random(41);
  for (int round = 0; round < 2000; ++round) {
    BitMatrix m(1 + static_cast<int>(random() % 7), 1 + static_cast<int>(random() % 7));
    fill_randomly(m, random, 0.15 + 0.1 * (round % 8));
    const auto found = weave_layers(m);
    ASSERT_EQ(static_cast<int>(found.size()), slow_layer_count(m)) << "round " << round;
    for (size_t above = 0; above < found.size(); ++above) {
      for (size_t below = above + 1; below < found.size(); ++below) {
        for (const int e : found[above].ends) {
          for (const int p : found[below].picks) ASSERT_TRUE(m.get(p, e));
        }
        for (const int p : found[above].picks) {
          for (const int e : found[below].ends) ASSERT_FALSE(m.get(p, e));
        }
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::analysis
