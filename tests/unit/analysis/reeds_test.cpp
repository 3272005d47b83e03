// Setts in reeds, against published tables; the nearest reeds.

#include "analysis/reeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/units.h"

namespace weftlight::analysis {

using design::sleying_from_text;

namespace {

double per_inch(float dents, const char* sleying) {
  return sett_in_reed({dents, true}, sleying_from_text(sleying)) * kInch_mm / 10;
}

// House of Wool, Reed Substitution Guide, houseofwool.ca/pages/reed-substitution-guide: ends per inch, rounded to half
// or whole ends.
TEST(Reeds, MakeTheSettsOfAPublishedTable) {
  struct Row {
    const char* sleying;
    double setts[5];
  };
  constexpr float kDents[] = {5, 8, 10, 12, 15};
  constexpr Row kRows[] = {{"0-1", {2.5, 4, 5, 6, 7.5}},      {"0-1-1", {3, 5, 7, 8, 10}},
                           {"1", {5, 8, 10, 12, 15}},         {"1-1-1-2", {6, 10, 12.5, 15, 19}},
                           {"1-1-2", {7, 11, 13.5, 16, 20}},  {"1-2", {7.5, 12, 15, 18, 22.5}},
                           {"1-2-2", {8, 13, 17, 20, 25}},    {"2", {10, 16, 20, 24, 30}},
                           {"2-2-3", {12, 19, 24.5, 28, 35}}, {"3", {15, 24, 30, 36, 45}}};
  for (const Row& row : kRows)
    for (size_t i = 0; i < 5; ++i)
      EXPECT_NEAR(per_inch(kDents[i], row.sleying), row.setts[i], 1.2) << row.sleying << " in " << kDents[i];
}

// Handweaving Academy, How to use any reed for any sett: 20 ends per inch in a 12-dent reed are 1 2/3 ends in a dent.
// P. Osterkamp, Useful Information: 10 in an 8-dent reed are 1-1-1-2. Interweave, Sleying the Reed: 16 in 12 are 2-1-1.
// School of SweetGeorgia, Reed Substitution Chart: 20 in a 6-dent reed are 3-3-4.
TEST(Reeds, MakeTheSettsOfHandbooks) {
  EXPECT_NEAR(per_inch(12, "1-2-2"), 20, 1e-6);
  EXPECT_NEAR(per_inch(8, "1-1-1-2"), 10, 1e-6);
  EXPECT_NEAR(per_inch(12, "2-1-1"), 16, 1e-6);
  EXPECT_NEAR(per_inch(6, "3-3-4"), 20, 1e-6);
}

TEST(Reeds, TheBestMakesTheSettWithOneNumberOfEnds) {
  const auto near = nearest_reeds(10, false, 5);
  ASSERT_EQ(near.size(), 5u);
  EXPECT_EQ(near[0].sleying.size(), 1u);
  EXPECT_NEAR(near[0].deviation, 0, 1e-9);
  const auto inch = nearest_reeds(200 / kInch_mm, true, 3);
  ASSERT_FALSE(inch.empty());
  EXPECT_TRUE(inch[0].reed == Reed({10, true}) && inch[0].sleying == std::vector<int>{2})
      << "20 ends per inch: a 10-dent reed, two in each";
}

TEST(Reeds, AreNearForAnySettOfAHandloom) {
  for (int step = 0; step < 78; ++step)
    for (const bool inch : {false, true}) {
      const double sett = 2.5 * std::pow(1.03, step);
      const auto near = nearest_reeds(sett, inch, 3);
      ASSERT_FALSE(near.empty()) << sett;
      EXPECT_LT(std::abs(near[0].deviation), 0.045) << sett;
      for (const SleyedReed& r : near) EXPECT_NEAR(r.ends_per_cm, sett_in_reed(r.reed, r.sleying), 1e-9);
    }
  EXPECT_TRUE(nearest_reeds(0, false, 3).empty());
  EXPECT_TRUE(nearest_reeds(5000, true, 3).empty()) << "no reed holds that";
}

TEST(Reeds, DentsThatEndsTake) {
  EXPECT_EQ(dents_for(10, {2}), 5);
  EXPECT_EQ(dents_for(11, {2}), 6);
  EXPECT_EQ(dents_for(8, {1, 1, 2}), 6);
  EXPECT_EQ(dents_for(9, {1, 1, 2}), 7);
  EXPECT_EQ(dents_for(2, {0, 1}), 4);
  EXPECT_EQ(dents_for(0, {1}), 0);
}

TEST(Reeds, EvenNumbersHaveTheirMean) {
  EXPECT_EQ(even_numbers(10, 10), std::vector<int>{10});
  EXPECT_EQ(even_numbers(9.5, 10).size(), 2u);
  for (int step = 0; step < 32; ++step) {
    const double mean = 0.2 + 0.37 * step;
    const std::vector<int> numbers = even_numbers(mean, 10);
    const double sum = std::accumulate(numbers.begin(), numbers.end(), 0.0);
    EXPECT_NEAR(sum / static_cast<double>(numbers.size()), mean, 0.06) << mean;
    EXPECT_LE(*std::ranges::max_element(numbers) - *std::ranges::min_element(numbers), 1) << mean;
  }
}

}  // namespace
}  // namespace weftlight::analysis
