#include "weaves/weaves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../hand_drafts.h"
#include "../yarns.h"
#include "analysis/floats.h"

namespace weftlight::weaves {

using design::Design, design::Rows, design::Yarn, design::clamped, design::is_consistent, design::text_of,
    design::yarn_presets;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::drawdown;

namespace {

Rows cloth(const Design& design) { return text_of(drawdown(design.draft)); }

TEST(Generators, KnownDrawdowns) {
  EXPECT_EQ(cloth(plain({3, 2})), (Rows{"101", "010"}));
  EXPECT_EQ(cloth(basket(2, {4, 4})), (Rows{"1100", "1100", "0011", "0011"}));
  EXPECT_EQ(cloth(twill({2, 1}, Lean::kRight, {3, 3})), (Rows{"110", "011", "101"}));
  EXPECT_EQ(cloth(twill({2, 1}, Lean::kLeft, {3, 3})), (Rows{"110", "101", "011"}));
  EXPECT_EQ(cloth(satin(5, 2, Face::kBack, {5, 5})), (Rows{"10000", "00100", "00001", "01000", "00010"}));
  EXPECT_EQ(cloth(satin(5, 2, Face::kFront, {5, 2})), (Rows{"01111", "11011"}));
  EXPECT_EQ(cloth(pointed_twill({1, 2}, false, {4, 3})), (Rows{"1000", "0101", "0010"}));
}

TEST(Generators, HerringboneBreaksCleanly) {
  const BitMatrix cells = drawdown(herringbone({2, 2}, 6, {24, 4}).draft);
  for (const int turn : {5, 11}) {
    for (int p = 0; p < 4; ++p) EXPECT_NE(cells.get(p, turn), cells.get(p, turn + 1));
  }
}

TEST(Generators, FloatsStayShort) {
  const auto longest = [](const Design& d) {
    const analysis::LongestFloats f = analysis::longest_floats(drawdown(d.draft));
    return std::max({f.warp_front, f.warp_back, f.weft_front, f.weft_back});
  };
  EXPECT_EQ(longest(waffle(4, {60, 60})), 5);
  EXPECT_EQ(longest(shadow_weave({0, 0, 1, 1, 2, 2, 3, 3}, {16, 16})), 2);
  EXPECT_EQ(longest(twill_damask({0, 0, 1}, {12, 12})), 3);
  EXPECT_EQ(longest(summer_and_winter({0, 1, 1}, {12, 12})), 3);
  EXPECT_EQ(longest(advancing_twill({2, 2}, 4, 1, {16, 16})), 2);
}

/// The shaft of each end.
std::vector<int> shafts_of(const Design& design) {
  std::vector<int> shafts;
  for (int e = 0; e < design.draft.ends(); ++e) shafts.push_back(design.draft.threading.first(e));
  return shafts;
}

TEST(Generators, OvershotTabbiesWeavePlain) {
  const Design d = overshot({0, 1, 2, 3}, 4, {16, 16});
  EXPECT_EQ(shafts_of(d), (std::vector<int>{0, 1, 0, 1, 2, 1, 2, 3, 2, 3, 0, 3, 0, 1, 0, 1}))
      << "with the end shared with the next, four in each block";
  const BitMatrix cells = drawdown(d.draft);
  for (int p = 1; p < 16; p += 2) {
    for (int e = 0; e < 16; ++e) EXPECT_EQ(cells.get(p, e), (e + p / 2) % 2 == 0);
  }
  EXPECT_EQ(d.draft.weft.yarn[0], 1);
  EXPECT_EQ(d.draft.weft.yarn[1], 0);
}

/// The list up to where it repeats; it holds two repeats or more.
std::vector<int> one_repeat(const std::vector<int>& list) {
  size_t period = 1;
  while (!std::equal(list.begin() + static_cast<std::ptrdiff_t>(period), list.end(), list.begin())) ++period;
  return {list.begin(), list.begin() + static_cast<std::ptrdiff_t>(period)};
}

/// Whether a list that repeats reads the same both ways from some place in it.
bool is_palindrome(const std::vector<int>& list) {
  const size_t n = list.size();
  const auto same_both_ways = [&](size_t middle) {
    for (size_t i = 0; i < n; ++i)
      if (list[(middle + i) % n] != list[(middle + n - i) % n]) return false;
    return true;
  };
  for (size_t middle = 0; middle < n; ++middle)
    if (same_both_ways(middle)) return true;
  return false;
}

TEST(Generators, OvershotOfASymmetricProfileIsSymmetric) {
  for (const std::vector<int>& profile : std::vector<std::vector<int>>{
           {0, 1, 2, 3, 2, 1}, {0, 1, 2, 1, 0}, {1, 0, 0, 1, 2, 3, 3, 2}, {0, 1, 2, 3, 0, 3, 2, 1}, {0, 2, 0, 4, 5, 4}})
    for (const int length : {2, 3, 4, 5, 8})
      for (const bool as_writ : {false, true}) {
        const Design d = overshot(profile, length, {300, 300}, {false, as_writ, 2});
        std::vector<int> shafts = shafts_of(d), treadles;
        for (int p = 0; p < d.draft.picks(); ++p) treadles.push_back(d.draft.treadling.first(p));
        EXPECT_TRUE(is_palindrome(one_repeat(shafts))) << "ends in a block: " << length;
        EXPECT_TRUE(is_palindrome(one_repeat(treadles))) << "ends in a block: " << length;
        for (size_t e = 0; e < shafts.size(); ++e) ASSERT_EQ(shafts[e] % 2, static_cast<int>(e % 2));
        for (size_t p = 1; p < treadles.size(); p += 2)
          ASSERT_EQ(treadles[p], d.draft.shafts + static_cast<int>(p / 2 % 2));
      }
  const std::vector<int> shafts = shafts_of(overshot({0, 1, 2, 1, 0}, 4, {15, 4}));
  std::vector<int> back = shafts;
  std::ranges::reverse(back);
  EXPECT_EQ(shafts, back) << "from the first end to the last";
}

TEST(Generators, DamaskBlocksMeetInACleanCut) {
  const BitMatrix cells = drawdown(twill_damask({0, 1}, {8, 8}).draft);
  for (int i = 0; i < 8; ++i) {
    EXPECT_NE(cells.get(i, 3), cells.get(i, 4));
    EXPECT_NE(cells.get(3, i), cells.get(4, i));
  }
}

/// Halves of a thread were rounded by the last bit of a cosine; now they go down while the wave rises, and up while it
/// falls.
TEST(Generators, AnUndulatingTwillRisesAsItFalls) {
  for (const int widest : {2, 3, 4, 7}) {
    const Design d = undulating_twill({2, 2, 2, 2}, widest, false, {4096, 8});
    std::vector<int> ends_on_a_shaft;
    for (int e = 0; e < d.draft.ends(); ++e) {
      const bool is_next = e == 0 || d.draft.threading.first(e) != d.draft.threading.first(e - 1);
      if (is_next) ends_on_a_shaft.push_back(0);
      ++ends_on_a_shaft.back();
    }
    constexpr size_t kWave = 24;  // three times through the shafts
    ASSERT_GT(ends_on_a_shaft.size(), kWave);
    for (size_t i = 1; i < kWave / 2; ++i) {
      const double exact = (widest - 1) * (0.5 - 0.5 * std::cos(2 * std::numbers::pi * static_cast<double>(i) / kWave));
      const bool half = std::abs(exact - std::floor(exact) - 0.5) < 1e-6;
      EXPECT_EQ(ends_on_a_shaft[kWave - i] - ends_on_a_shaft[i], half) << widest << ", " << i;
    }
  }
}

TEST(Generators, AnyParametersMakeAConsistentDraft) {
  for (const int wild : {-1000, -1, 0, 1, 2, 3, 7, 1000}) {
    const ClothSize size{wild, wild};
    const OverUnder order{wild, 1};
    for (const Design& d : {plain(size),
                            basket(wild, size),
                            twill(order, Lean::kLeft, size),
                            satin(wild, wild, Face::kBack, size),
                            pointed_twill(order, true, size),
                            herringbone(order, wild, size),
                            advancing_twill(order, wild, wild, size),
                            undulating_twill({2, 2}, wild, true, size),
                            waffle(wild, size),
                            overshot({wild}, wild, size),
                            summer_and_winter({wild}, size),
                            twill_damask({wild}, size),
                            shadow_weave({wild}, size),
                            log_cabin(wild, size),
                            corkscrew(wild, Face::kBack, Lean::kLeft, size),
                            houndstooth(order, wild, size),
                            glen_check(order, {wild, wild, wild, wild, wild}, size),
                            overshot({0, wild}, 3, size, {true, wild % 2 == 0, wild}),
                            overshot({}, 4, size),
                            with_colors(plain(size), {}, {}, {}),
                            with_colors(plain(size), {Rgb{}}, {{wild, wild}}, {})}) {
      ASSERT_TRUE(is_consistent(d)) << wild;
    }
  }
  EXPECT_TRUE(is_consistent(twill({}, Lean::kRight, {4, 4})));
}

TEST(Sett, FewerInterlacingsGiveACloserSett) {
  const Yarn yarn = yarn_preset("Cotton");
  const auto spacing = [&](Design d) {
    return with_sett(with_yarns(std::move(d), yarn, yarn)).draft.warp.spacing_mm[0];
  };
  const float in_plain = spacing(plain({8, 8}));
  const float in_twill = spacing(twill({2, 2}, Lean::kRight, {8, 8}));
  const float in_satin = spacing(satin(8, 3, Face::kFront, {8, 8}));
  EXPECT_GT(in_plain, in_twill);
  EXPECT_GT(in_twill, in_satin);
  EXPECT_GT(in_satin, yarn.diameter_mm);
}

TEST(YarnPresets, AreInRange) {
  ASSERT_EQ(yarn_presets().size(), 8u);
  for (const Yarn& yarn : yarn_presets()) {
    EXPECT_EQ(clamped(yarn), yarn) << yarn.name;
  }
  EXPECT_LT(yarn_preset("Silk").lobes.along_width, yarn_preset("Cotton").lobes.along_width);
}

}  // namespace
}  // namespace weftlight::weaves
