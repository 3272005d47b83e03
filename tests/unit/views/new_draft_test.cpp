// What the dialog for a new draft proposes.

#include <gtest/gtest.h>

#include "analysis/measures.h"
#include "design/yarn_presets.h"
#include "views/dialogs/prompts.h"

namespace weftlight::views {

namespace {

int kind_named(const std::string& id) {
  const auto kinds = weaves::weave_kinds();
  for (size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i].id == id) return static_cast<int>(i);
  return -1;
}

TEST(NewDraft, IsFirmOnTheLoomInWholeEnds) {
  struct Expected {
    const char* weave;
    Units units;
    double per_cm;
  };
  // Cotton Ne 8/2, 0.45 mm: 22.2 wraps in a cm.
  for (const Expected& one :
       {Expected{"plain", Units::kMetric, 11}, {"twill", Units::kMetric, 15}, {"plain", Units::kImperial, 28 / 2.54}}) {
    const WeavePrompt p = prompt_for(kind_named(one.weave), {64, 64}, one.units);
    const Design d = new_design(p);
    EXPECT_EQ(d.yarns[0], design::ready_yarns()[0]) << one.weave;
    EXPECT_NEAR(analysis::cloth_measures(d).loom_ends_per_cm, one.per_cm, 1e-3) << one.weave;
    EXPECT_NEAR(analysis::cloth_measures(d).loom_picks_per_cm, one.per_cm, 1e-3) << one.weave;
  }
}

TEST(NewDraft, KeepsItsPatternYarnThickerThanTheGround) {
  const WeavePrompt p = prompt_for(kind_named("overshot"), {64, 64}, Units::kMetric);
  const Design d = new_design(p);
  ASSERT_EQ(d.yarns.size(), 2u);
  EXPECT_FLOAT_EQ(d.yarns[1].diameter_mm, 1.6f * d.yarns[0].diameter_mm);
  EXPECT_EQ(d.yarns[1].lobes, d.yarns[0].lobes);
  EXPECT_EQ(d.yarns[1].name, "Pattern weft");
}

}  // namespace
}  // namespace weftlight::views
