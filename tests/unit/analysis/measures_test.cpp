// The measures of planned cloths, against published worked examples and by hand from the formulas of measures.h.

#include "analysis/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../plain_cloth.h"
#include "analysis/units.h"
#include "analysis/yarn_need.h"
#include "design/edits.h"
#include "design/fibre.h"

namespace weftlight::analysis {

using design::ClothPlan, design::Design, design::with_sett;

namespace {

constexpr double kYard_mm = 1000 * kYard_m;

/// As drafted at 10 threads in a cm, on a plan.
Design planned(const ClothPlan& plan) {
  Design d = plain_cloth(4, 4);
  d.plan = plan;
  return d;
}

// G. Sunnanö, Beräkning av varplängder, sunnano.se/gunilla/varplangd.htm: two rag rugs of 80 cm x 2 m, reed 30/10 with
// one end in each dent; 2 cm wider in the reed; 15% of the length for the take-up of the warp, 4 x 10 cm of fringe, 6
// dm of loom waste. 246 ends (and 4 more that double the selvedges), a warp of 5.6 m.
TEST(Measures, OfTwoRagRugsInASwedishExample) {
  ClothPlan plan = bare_plan();
  plan.width_mm = 800, plan.length_mm = 2000, plan.pieces = 2;
  plan.weft_take_up = 2.0f / 80;
  plan.warp_take_up = 0.15f;
  plan.fringe_mm = 200, plan.loom_waste_mm = 600;
  plan.reed = {30, false};
  const ClothMeasures m = cloth_measures(planned(plan));
  EXPECT_EQ(m.ends, 246);
  EXPECT_EQ(m.dents, 246);
  EXPECT_NEAR(m.reed_width_mm, 820, 0.01);
  EXPECT_NEAR(m.warp_length_mm, 5600, 0.01);
}

// The same example: 250 ends of 12/6 yarn, 1400 m a kilogram at count 1 of one ply, weigh 0.5 kg.
TEST(Measures, WeighTheWarpOfTheSwedishExample) {
  Design d = plain_cloth(250, 4, 10.0f / 3);
  d.plan = bare_plan();
  d.plan.loom_waste_mm = 5600 - 4;
  d.yarns[0].tex = 1e6f / 1400 * 6 / 12;
  const YarnReport r = yarn_report(d);
  EXPECT_NEAR(r.warp_m, 250 * 5.6, 0.01);
  EXPECT_NEAR(r.needs[0].weight_g, 500, 0.5);
}

// Calculate yarn, allfiberarts.com/tag/calculate-yarn: runners of 40 inches with hems, 17 wide, 15% for take-up and
// shrinkage, 36 inches of loom waste, 20 ends per inch. One takes a warp of 82 inches, two one of 128 (3.5 yards); 19.5
// inches (19.55, rounded) hold 390 ends, 1365 yards in all.
TEST(Measures, OfTableRunnersInAnAmericanExample) {
  ClothPlan plan = bare_plan();
  plan.width_mm = static_cast<float>(17 * kInch_mm), plan.length_mm = static_cast<float>(40 * kInch_mm);
  plan.warp_take_up = plan.weft_take_up = 0.15f;
  plan.loom_waste_mm = static_cast<float>(36 * kInch_mm);
  plan.ends_per_cm = static_cast<float>(200 / kInch_mm);
  const ClothMeasures one = cloth_measures(planned(plan));
  EXPECT_NEAR(one.warp_length_mm / kInch_mm, 82, 0.05);
  EXPECT_NEAR(one.reed_width_mm / kInch_mm, 19.5, 0.06);
  EXPECT_NEAR(static_cast<double>(one.ends), 390, 1.01);
  plan.pieces = 2;
  const ClothMeasures two = cloth_measures(planned(plan));
  EXPECT_NEAR(two.warp_length_mm / kInch_mm, 128, 0.1);
  EXPECT_NEAR(two.warp_length_mm / kYard_mm, 3.5, 0.06);
  EXPECT_NEAR(yarn_report(planned(plan)).warp_m / kYard_m, 1365, 0.025 * 1365) << "its 3.5 yards are 3.56";
}

// Creative Threads, Calculating warp yarn quantity, creative-threads.co.uk/calculating-warp-yarn-quantity: 8 ends per
// cm, 50 cm and 10%: 440 ends. Three pieces of 50 cm and 10%, 10 cm to tie on, 5 to spread the ends, 50 left over.
TEST(Measures, OfThreePiecesInABritishExample) {
  ClothPlan plan = bare_plan();
  plan.width_mm = 500, plan.length_mm = 500, plan.pieces = 3;
  plan.warp_take_up = plan.weft_take_up = 0.1f;
  plan.loom_waste_mm = 650;
  plan.ends_per_cm = 8;
  const ClothMeasures m = cloth_measures(planned(plan));
  EXPECT_EQ(m.ends, 440);
  EXPECT_NEAR(m.warp_length_mm, 2300, 0.1);
  EXPECT_NEAR(yarn_report(planned(plan)).warp_m, 440 * 2.3, 0.1) << "by hand: ends times length";
}

// Horsens Vævekreds, Garnberegning til vævet viskestykke, horsensvævekreds.dk: three towels of 50 x 74 cm with hems,
// 10% each way, 10 ends in a cm of the reed, 25 and 50 cm beyond the cloth: 550 ends, a warp of 319.2 cm, 130 g of a
// cotton of 13,500 m/kg.
TEST(Measures, OfThreeTowelsInADanishExample) {
  ClothPlan plan = bare_plan();
  plan.width_mm = 500, plan.length_mm = 740, plan.pieces = 3;
  plan.warp_take_up = plan.weft_take_up = 0.1f;
  plan.loom_waste_mm = 750;
  plan.reed = {50, false};
  plan.sleying = {2};
  Design d = planned(plan);
  d.yarns[0].tex = static_cast<float>(1e6 / 13500);
  const ClothMeasures m = cloth_measures(d);
  EXPECT_EQ(m.ends, 550);
  EXPECT_EQ(m.dents, 275);
  EXPECT_NEAR(m.warp_length_mm, 3192, 0.1);
  EXPECT_NEAR(yarn_report(d).needs[0].weight_g, 130, 0.5);
}

// Conference of Northern California Handweavers, cnch.org/?p=13821: what shrinks by 20% must be woven 12.5 inches long
// to be 10, not 12.
TEST(Measures, ShrinkageIsOfTheWovenLength) {
  ClothPlan plan = bare_plan();
  plan.length_mm = static_cast<float>(10 * kInch_mm);
  plan.warp_shrinkage = 0.2f;
  EXPECT_NEAR(cloth_measures(planned(plan)).woven_length_mm / kInch_mm, 12.5, 0.02);
}

TEST(Measures, ADraftWithoutAPlannedSizeIsTheCloth) {
  Design d = plain_cloth(360, 200, 1.25f, 2);
  const ClothMeasures m = cloth_measures(d);
  EXPECT_EQ(m.ends, 360);
  EXPECT_EQ(m.picks, 200);
  EXPECT_NEAR(m.width_mm, 450, 1e-3);
  EXPECT_NEAR(m.length_mm, 400, 1e-3);
  EXPECT_NEAR(m.cloth_ends_per_cm, 8, 1e-6);
  EXPECT_NEAR(m.reed_width_mm, 450 / 0.92 * 1.06, 1e-3);
  EXPECT_LT(m.loom_ends_per_cm, m.cloth_ends_per_cm) << "the cloth draws in and shrinks";
  d.plan.reed = {100, false};
  const ClothMeasures dense = cloth_measures(d);
  EXPECT_EQ(dense.ends, 360) << "the ends of the draft";
  EXPECT_LT(dense.width_mm, m.width_mm) << "closer together";
}

TEST(Measures, AReedDecidesTheSettAndTheEndsOfAPlannedWidth) {
  Design d = plain_cloth(4, 4);
  d.plan = bare_plan();
  d.plan.width_mm = 500;
  EXPECT_EQ(cloth_measures(d).ends, 500);
  d.plan.reed = {40, false};
  d.plan.sleying = {2, 3};
  const ClothMeasures m = cloth_measures(d);
  EXPECT_NEAR(m.wanted_ends_per_cm, 10, 1e-6);
  EXPECT_NEAR(m.loom_ends_per_cm, 10, 1e-6);
  EXPECT_EQ(m.dents, 200);
  d.plan.floating_selvedges = true;
  EXPECT_EQ(cloth_measures(d).dents, 202);
  EXPECT_EQ(cloth_measures(d).ends, 500) << "they are no ends of the cloth";
}

TEST(Measures, TheDraftCanTakeTheSettOfThePlan) {
  Design d = plain_cloth(40, 40);
  d.draft.warp.spacing_mm[3] = 2;
  d.plan.reed = {60, false};
  const ClothMeasures m = cloth_measures(d);
  d = with_sett(d, System::kWarp, m.cloth_ends_per_cm);
  EXPECT_NEAR(cloth_measures(d).draft_ends_per_cm, m.cloth_ends_per_cm, 1e-4);
  EXPECT_NEAR(d.draft.warp.spacing_mm[3], 2 * d.draft.warp.spacing_mm[4], 1e-6) << "wide gaps stay wide";
}

TEST(Measures, NumbersOutOfRangeCountAsTheLimit) {
  Design d = plain_cloth(3, 3);
  d.draft.warp.spacing_mm = {0, 0, 0};
  EXPECT_EQ(cloth_measures(d).ends, 0) << "a cloth of no width";
  EXPECT_TRUE(yarn_report(d).needs.empty());
  d = plain_cloth(3, 3);
  d.plan.warp_shrinkage = 5;
  d.plan.weft_take_up = -3;
  d.plan.spare = std::numeric_limits<float>::quiet_NaN();
  Design limits = plain_cloth(3, 3);
  limits.plan.warp_shrinkage = design::kMaxShrinkage;
  limits.plan.weft_take_up = 0;
  EXPECT_GT(yarn_report(d).weight_g, 0);
  EXPECT_DOUBLE_EQ(yarn_report(d).weight_g, yarn_report(limits).weight_g);
  d.plan.width_mm = d.plan.length_mm = 1e30f;
  d.plan.pieces = 1'000'000'000;
  EXPECT_TRUE(std::isfinite(yarn_report(d).weight_g));
}

TEST(Measures, OfThreadsAsTheyAreLaidOut) {
  Design d = plain_cloth(4, 2);
  d.yarns[0].diameter_mm = 0.5f;
  d.yarns.push_back(d.yarns[0]);
  d.yarns[1].diameter_mm = 0.3f, d.yarns[1].tex = 60;
  const double tex = static_cast<double>(tex_of(d.yarns[0]));
  EXPECT_DOUBLE_EQ(mean_thread(d, System::kWarp).diameter_mm, 0.5);
  EXPECT_DOUBLE_EQ(mean_thread(d, System::kWarp).tex, tex);
  d.draft.warp.thickness_mm = {1, 1, 1, 1};
  d.draft.weft.yarn = {0, 1};
  EXPECT_DOUBLE_EQ(mean_thread(d, System::kWarp).diameter_mm, 1);
  EXPECT_NEAR(mean_thread(d, System::kWarp).tex, 4 * tex, 1e-3) << "of four times the section";
  EXPECT_EQ(mean_thread(d, System::kWarp, 1).threads, 0);
  EXPECT_EQ(mean_thread(d, System::kWarp, 1).tex, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(mean_thread(d, System::kWeft).diameter_mm), 0.4f);
  EXPECT_EQ(mean_thread(d, System::kWeft, 1).tex, 60) << "as it is set";
  const YarnReport r = yarn_report(d);
  for (const YarnNeed& need : r.needs) {
    EXPECT_NEAR(need.weight_g, need.length_m * need.tex / 1000, 1e-6);
    EXPECT_NEAR(need.tex, mean_thread(d, need.system, need.yarn).tex, 1e-3) << "the plan weighs what is laid out";
  }
}

}  // namespace
}  // namespace weftlight::analysis
