#include "analysis/floats.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../hand_drafts.h"

namespace weftlight::analysis {

using design::Rows, design::fill_randomly, design::matrix_of;
using draft::BitMatrix, draft::Face, draft::System, draft::transposed;

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

TEST(Floats, AFloatThatIsNeverBoundIsAsLongAsTheCloth) {
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

TEST(LongFloats, AreListedTheLongestFirst) {
  // Pick 3 floats over ends 4, 5, 1 and 2; end 1 over picks 4, 5 and 1.
  const BitMatrix m = matrix_of({"10100", "01010", "00100", "11011", "10101"});
  const LongFloats f = long_floats(m, 2);
  ASSERT_FALSE(f.listed.empty());
  EXPECT_EQ(f.listed[0], (Float{System::kWeft, Face::kFront, 2, 3, 4}));
  EXPECT_NE(std::ranges::find(f.listed, Float{System::kWarp, Face::kFront, 0, 3, 3}), f.listed.end());
  EXPECT_EQ(f.count, static_cast<int64_t>(f.listed.size()));
  EXPECT_EQ(long_floats(m, 2, 1).listed.size(), 1u);
  EXPECT_TRUE(long_floats(m, 5).listed.empty());
}

TEST(LongFloats, OnlyTheLongestAreKept) {
  // 2/2 twill has floats of 2 in every thread; one end floats over ten picks.
  BitMatrix m(200, 200);
  for (int p = 0; p < 200; ++p)
    for (int e = 0; e < 200; ++e) m.set(p, e, (p + e) % 4 < 2);
  for (int p = 10; p < 20; ++p) m.set(p, 7, true);
  const LongFloats few = long_floats(m, 1, 3), all = long_floats(m, 1, 1000000);
  EXPECT_EQ(few.count, all.count);
  ASSERT_EQ(few.listed.size(), 3u);
  EXPECT_EQ(all.listed.size(), static_cast<size_t>(all.count));
  EXPECT_GE(few.listed[0].length, 10);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(few.listed[i], all.listed[i]) << i;
}

TEST(LongFloats, AgreeWithCountingOnRandomCloth) {
  std::mt19937 random(31);
  for (int round = 0; round < 150; ++round) {
    BitMatrix m(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 70));
    fill_randomly(m, random, 0.05 + 0.9 * (round % 10) / 9);
    const int limit = static_cast<int>(random() % 6);
    const BitMatrix marked = crossings_in_floats(m, limit, Face::kFront);
    const auto run_at = [&](int p, int e, bool down) {
      const bool value = m.get(p, e);
      const int n = down ? m.rows() : m.cols(), here = down ? p : e;
      const auto same = [&](int i) {
        const int k = ((here + i) % n + n) % n;
        return (down ? m.get(k, e) : m.get(p, k)) == value;
      };
      int run = 1;
      for (int i = 1; i < n && same(i); ++i) ++run;
      for (int i = 1; i < n && run < n && same(-i); ++i) ++run;
      return run;
    };
    for (int p = 0; p < m.rows(); ++p)
      for (int e = 0; e < m.cols(); ++e) {
        // On the front a warp float is where the warp is up, a weft float where it is down.
        const bool in_float = m.get(p, e) ? run_at(p, e, true) > limit : run_at(p, e, false) > limit;
        ASSERT_EQ(marked.get(p, e), in_float) << round << ": " << p << ", " << e;
      }
    int longest = 0;
    for (const Float& f : long_floats(m, limit).listed) longest = std::max(longest, f.length);
    const LongestFloats of = longest_floats(m);
    const int most = std::max({of.warp_front, of.warp_back, of.weft_front, of.weft_back});
    ASSERT_EQ(longest, most > limit ? most : 0);
  }
}

}  // namespace
}  // namespace weftlight::analysis
