// The yarn that a cloth takes, by yarn and colour, and what is bought for it; by hand.

#include "analysis/yarn_need.h"

#include <gtest/gtest.h>

#include "../plain_cloth.h"
#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::analysis {

using design::Design, design::Yarn, design::with_count, design::with_purchase, design::yarn_presets;

namespace {

TEST(Yarn, WeighsAsItsCount) {
  for (const Yarn& fibre : yarn_presets()) {
    Design d = plain_cloth(10, 10);
    d.yarns = {*with_count(fibre, "30 tex")};
    const YarnReport r = yarn_report(d);
    EXPECT_NEAR(r.weight_g / (r.warp_m + r.weft_m), 0.030, 3e-4)
        << fibre.name << ", its thickness in whole micrometres";
  }
}

TEST(Yarn, LengthWeightAndCostOfAPlainCloth) {
  Design d = plain_cloth(100, 200, 1, 0.5f);
  d.plan = bare_plan();
  d.plan.loom_waste_mm = 500;
  d.plan.warp_take_up = 0.1f;
  d.plan.weft_take_up = 0.05f;
  d.plan = with_purchase(d.plan, {d.yarns[0].name, 0, 0, 10});
  d.yarns[0].tex = 200;
  const YarnReport r = yarn_report(d);
  EXPECT_NEAR(r.warp_m, 61, 1e-4) << "110 mm in the cloth, 500 beyond it";
  EXPECT_NEAR(r.weft_m, 200 * 0.105, 1e-4);
  EXPECT_NEAR(r.weight_g, (61 + 21) * 0.2, 1e-3);
  EXPECT_NEAR(r.cost, (61 + 21) * 0.2 / 1000 * 10, 1e-5);
  // A square of 100 mm: 11 m of warp and 21 m of weft are in it.
  EXPECT_NEAR(r.g_per_m2, 32 * 0.2 / 0.01, 0.01);
}

TEST(Yarn, ASizeShrinkageAndSpareYarn) {
  Design d = plain_cloth(10, 10);
  d.plan = bare_plan();
  d.plan.length_mm = 900;
  d.plan.width_mm = 450;
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0.1f;
  d.plan.spare = 0.1f;
  const YarnReport r = yarn_report(d);
  EXPECT_NEAR(r.warp_m, 450 * 1.1, 1e-3) << "a metre each";
  EXPECT_NEAR(r.weft_m, 900 * 0.5 * 1.1, 1e-3);
  EXPECT_EQ(r.cost, -1) << "no price is known";
}

TEST(Yarn, EachYarnAndColourIsCountedInWholeThreads) {
  Design d = plain_cloth(6, 4);
  d.yarns.emplace_back().name = "Linen";
  d.draft.warp.color = {0, 1, 0, 1, 0, 0};
  d.draft.weft.yarn = {1, 1, 1, 1};
  d.plan = bare_plan();
  d.plan.width_mm = 10;  // the draft, and four ends more
  const YarnReport r = yarn_report(d);
  ASSERT_EQ(r.needs.size(), 3u);
  EXPECT_EQ(r.needs[0].threads, 6);
  EXPECT_EQ(r.needs[0].color, 0);
  EXPECT_EQ(r.needs[1].threads, 4);
  EXPECT_EQ(r.needs[2].yarn, 1);
  d.plan.floating_selvedges = true;
  EXPECT_EQ(yarn_report(d).needs[0].threads, 7) << "one at end 1";
  EXPECT_EQ(yarn_report(d).needs[1].threads, 5) << "one at the fourth end, the last of the cloth";
}

TEST(Yarn, ConesAreBoughtWhole) {
  Design d = plain_cloth(100, 100);
  d.plan = bare_plan();
  d.plan.width_mm = d.plan.length_mm = 1000;
  d.draft.weft.color = d.draft.warp.color;
  d.yarns[0].tex = 100;  // 1000 threads of a metre each way: 2000 m, 200 g
  const std::string& name = d.yarns[0].name;
  d.plan = with_purchase(d.plan, {name, 75, 0, 8});
  YarnReport r = yarn_report(d);
  ASSERT_EQ(r.buy.size(), 1u);
  EXPECT_EQ(r.buy[0].cones, 3);
  EXPECT_DOUBLE_EQ(r.cost, 24);
  d.plan = with_purchase(d.plan, {name, 75, 2000, 8});
  EXPECT_EQ(yarn_report(d).buy[0].cones, 1) << "the length rules, and is just enough";
  d.plan = with_purchase(d.plan, {name, 0, 0, 8});
  r = yarn_report(d);
  EXPECT_EQ(r.buy[0].cones, 0);
  EXPECT_NEAR(r.cost, 1.6, 1e-6);
  d.yarns.emplace_back().name = "Silk";
  d.draft.weft.yarn[3] = 1;
  EXPECT_LT(yarn_report(d).cost, 0) << "the price of the silk is not known";
}

}  // namespace
}  // namespace weftlight::analysis
