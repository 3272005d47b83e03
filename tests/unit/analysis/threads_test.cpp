// Heddles, interlacing, sett and yarn, against drafts counted by hand.

#include "analysis/threads.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_drafts.h"
#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::analysis {

using design::Design, design::Yarn, design::matrix_of, design::treadled, design::with_count, design::yarn_presets;
using draft::BitMatrix, draft::Draft, draft::blank_draft;

namespace {

Design plain_cloth(int ends, int picks) {
  Design d;
  d.draft = blank_draft(ends, picks, 2, 2);
  for (int e = 0; e < ends; ++e) d.draft.threading.set(e, e % 2, true);
  for (int p = 0; p < picks; ++p) d.draft.treadling.set(p, p % 2, true);
  d.draft.tieup.set(0, 0, true);
  d.draft.tieup.set(1, 1, true);
  return d;
}

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

TEST(Yarn, WeighsAsItsCount) {
  for (const Yarn& fibre : yarn_presets()) {
    Design d = plain_cloth(10, 10);
    d.yarns = {*with_count(fibre, "30 tex")};
    const YarnReport r = yarn_report(d, {});
    EXPECT_NEAR(r.weight_g / (r.warp_m + r.weft_m), 0.030, 3e-4)
        << fibre.name << ", its thickness in whole micrometres";
  }
}

TEST(Yarn, LengthWeightAndCostOfAPlainCloth) {
  Design d = plain_cloth(100, 200);
  d.draft.warp.spacing_mm.assign(100, 1.0f);
  d.draft.weft.spacing_mm.assign(200, 0.5f);
  ClothPlan plan;
  plan.loom_waste_mm = 500;
  plan.warp_take_up = 0.1;
  plan.weft_take_up = 0.05;
  plan.warp_shrinkage = plan.weft_shrinkage = 0;
  plan.spare = 0;
  plan.price_per_kg = {10};
  d.yarns[0].tex = 200;
  const YarnReport r = yarn_report(d, plan);
  EXPECT_EQ(r.ends, 100);
  EXPECT_EQ(r.picks, 200);
  EXPECT_NEAR(r.warp_length_mm, 110 + 500, 1e-6);  // 100 mm of cloth
  EXPECT_NEAR(r.warp_m, 61, 1e-6);
  EXPECT_NEAR(r.weft_m, 200 * 0.105, 1e-6);
  EXPECT_NEAR(r.weight_g, (61 + 21) * 0.2, 1e-6);
  EXPECT_NEAR(r.cost, (61 + 21) * 0.2 / 1000 * 10, 1e-9);
  EXPECT_NEAR(r.ends_per_cm, 10, 1e-9);
  EXPECT_NEAR(r.picks_per_cm, 20, 1e-9);
  // A square of 100 mm: 11 m of warp and 21 m of weft are in it.
  EXPECT_NEAR(r.g_per_m2, 32 * 0.2 / 0.01, 1e-6);
}

TEST(Yarn, ASizeShrinkageAndSpareYarn) {
  Design d = plain_cloth(10, 10);
  d.draft.warp.spacing_mm.assign(10, 1.0f);
  d.draft.weft.spacing_mm.assign(10, 1.0f);
  ClothPlan plan;
  plan.length_mm = 900;
  plan.width_mm = 450;
  plan.warp_shrinkage = plan.weft_shrinkage = 0.1;
  plan.warp_take_up = plan.weft_take_up = 0;
  plan.loom_waste_mm = 0;
  plan.spare = 0.1;
  const YarnReport r = yarn_report(d, plan);
  EXPECT_EQ(r.ends, 450);
  EXPECT_EQ(r.picks, 900);
  EXPECT_NEAR(r.loom_width_mm, 500, 1e-6);
  EXPECT_NEAR(r.warp_length_mm, 1000, 1e-6);
  EXPECT_NEAR(r.warp_m, 450 * 1.1, 1e-6);
  EXPECT_NEAR(r.weft_m, 900 * 0.5 * 1.1, 1e-6);
  EXPECT_EQ(r.cost, -1) << "no price is known";
}

TEST(Yarn, EachYarnAndColourIsNamed) {
  Design d = plain_cloth(6, 4);
  d.yarns.emplace_back();
  d.draft.warp.color = {0, 1, 0, 1, 0, 0};
  d.draft.weft.yarn = {1, 1, 1, 1};
  const YarnReport r = yarn_report(d, {});
  ASSERT_EQ(r.needs.size(), 3u);
  EXPECT_EQ(r.needs[0].threads, 4);
  EXPECT_EQ(r.needs[0].color, 0);
  EXPECT_EQ(r.needs[1].threads, 2);
  EXPECT_EQ(r.needs[2].yarn, 1);
}

TEST(Yarn, NumbersOutOfRangeCountAsTheLimit) {
  Design d = plain_cloth(3, 3);
  d.draft.warp.spacing_mm = {0, 0, 0};
  EXPECT_TRUE(yarn_report(d, {}).needs.empty()) << "a cloth of no width";
  d = plain_cloth(3, 3);
  ClothPlan wild;
  wild.warp_shrinkage = 5;
  wild.weft_take_up = -3;
  wild.spare = -9;
  ClothPlan limits;  // what such numbers count as
  limits.warp_shrinkage = 0.9;
  limits.weft_take_up = 0;
  limits.spare = 0;
  const YarnReport report = yarn_report(d, wild), expected = yarn_report(d, limits);
  EXPECT_GT(report.weight_g, 0);
  EXPECT_DOUBLE_EQ(report.weight_g, expected.weight_g);
  EXPECT_DOUBLE_EQ(report.loom_width_mm, expected.loom_width_mm);
}

}  // namespace
}  // namespace weftlight::analysis
