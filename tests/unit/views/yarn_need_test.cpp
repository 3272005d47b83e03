// The plan of a cloth comes from its view and from the settings.

#include <gtest/gtest.h>

#include "../straight_draft.h"
#include "views/analysis/yarn_need_panel.h"

namespace weftlight::views {

using design::Design;
using session::AnalysisView, session::Settings;

namespace {

TEST(YarnNeed, ThePlanCombinesViewAndSettings) {
  Design d = straight_draft(8);
  d.yarns.push_back(d.yarns[0]);
  d.yarns[0].name = "Linen";
  d.yarns[1].name = "Silk";
  AnalysisView view;
  view.cloth_length_cm = 200, view.cloth_width_cm = 50;
  Settings settings;
  settings.loom_waste_cm = 75, settings.shrinkage = 0.1f, settings.spare_yarn = 0;
  settings.yarn_prices = {{"Linen", 40.0f}};
  const analysis::ClothPlan plan = plan_of(d, view, settings);
  EXPECT_EQ(plan.length_mm, 2000);
  EXPECT_EQ(plan.width_mm, 500);
  EXPECT_EQ(plan.loom_waste_mm, 750);
  EXPECT_NEAR(plan.weft_shrinkage, 0.1, 1e-6);
  ASSERT_EQ(plan.price_per_kg.size(), 2u);
  EXPECT_EQ(plan.price_per_kg[0], 40);
  EXPECT_LT(plan.price_per_kg[1], 0) << "not known";
  const analysis::YarnReport r = analysis::yarn_report(d, plan);
  EXPECT_NEAR(r.cost, r.weight_g / 1000 * 40, 1e-6) << "all of it is linen";
  d.draft.weft.yarn[3] = 1;
  EXPECT_LT(analysis::yarn_report(d, plan_of(d, view, settings)).cost, 0) << "the silk's price is not known";
}

}  // namespace
}  // namespace weftlight::views
