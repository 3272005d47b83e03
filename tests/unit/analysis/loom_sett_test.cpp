// The sett of new drafts.

#include "analysis/loom_sett.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "../plain_cloth.h"
#include "analysis/measures.h"
#include "design/edits.h"

namespace weftlight::analysis {

using design::straight_twill;

namespace {

TEST(LoomSett, IsFirmInWholeThreadsOfTheUnit) {
  Design d = plain_cloth(20, 20);
  d.yarns[0].diameter_mm = 0.5f;
  EXPECT_EQ(firm_sett(d, Units::kMetric), (LoomSett{10, 10})) << "half of the wraps";
  EXPECT_EQ(firm_sett(d, Units::kImperial), (LoomSett{25, 25}));
  d = straight_twill(20, 20);
  d.yarns[0].diameter_mm = 0.5f;
  EXPECT_EQ(firm_sett(d, Units::kMetric), (LoomSett{13, 13})) << "two thirds";
}

TEST(LoomSett, OfEndsAndPicksFollowsTheYarnOfEach) {
  Design d = plain_cloth(20, 20);
  d.yarns[0].diameter_mm = 0.5f;
  d.yarns.push_back(d.yarns[0]);
  d.yarns[1].diameter_mm = 1;
  d.draft.weft.yarn.assign(20, 1);
  EXPECT_EQ(firm_sett(d, Units::kMetric), (LoomSett{10, 5}));
  d.yarns[0].diameter_mm = 0;
  EXPECT_EQ(firm_sett(d, Units::kMetric).ends, 9) << "10 as drawn, 8.7 on the loom";
}

TEST(LoomSett, IsThatOfTheLoomByThePlan) {
  const Design d = with_loom_sett(straight_twill(20, 20), {12, 11}, Units::kMetric);
  const ClothMeasures m = cloth_measures(d);
  EXPECT_NEAR(m.loom_ends_per_cm, 12, 1e-3);
  EXPECT_NEAR(m.loom_picks_per_cm, 11, 1e-3);
  EXPECT_GT(m.draft_ends_per_cm, 12) << "the draft is drawn as the finished cloth";
  EXPECT_NEAR(cloth_measures(with_loom_sett(d, {24, 20}, Units::kImperial)).loom_ends_per_cm, 24 / 2.54, 1e-3);
}

}  // namespace
}  // namespace weftlight::analysis
