// What the panel says of weight and stiffness of the cloth.

#include <gtest/gtest.h>

#include "../plain_cloth.h"
#include "analysis/units.h"
#include "analysis/yarn_need.h"
#include "views/inspector/drape_stiffness_rows.h"

namespace weftlight::views {

using analysis::Units, analysis::area_weight_text, analysis::yarn_report;

namespace {

TEST(DrapeStiffness, TellsTheWeightOfThePlan) {
  Design d = plain_cloth(60, 40, 0.5f, 0.5f);
  d.plan = bare_plan();
  const auto ends_with_weight = [&] {
    for (const Units units : {Units::kMetric, Units::kImperial})
      if (!stiffness_in_words(d, units).ends_with(", " + area_weight_text(yarn_report(d).g_per_m2, units)))
        return false;
    return true;
  };
  const std::string before = stiffness_in_words(d, Units::kMetric);
  EXPECT_TRUE(ends_with_weight()) << before;
  EXPECT_NE(stiffness_in_words(d, Units::kImperial).find(" in, "), std::string::npos);
  d.plan.warp_take_up = 0.2f;
  d.plan.warp_shrinkage = 0.1f;
  EXPECT_TRUE(ends_with_weight()) << stiffness_in_words(d, Units::kMetric);
  EXPECT_NE(stiffness_in_words(d, Units::kMetric), before);
  EXPECT_EQ(stiffness_in_words(Design{}, Units::kMetric), "");
}

}  // namespace
}  // namespace weftlight::views
