// The plot of a yarn's lobes and its strip.

#include <gtest/gtest.h>

#include <algorithm>

#include "views/common/yarn_strip.h"
#include "views/inspector/lobes_plot.h"

namespace weftlight::views {

using cloth::Linear;
using design::Lobes, design::Yarn;
using draft::Rgb;

namespace {

constexpr Linear kWhite{1, 1, 1};

int peak_of(const LobeCurves::Curve& curve) {
  return static_cast<int>(std::max_element(curve.begin(), curve.end()) - curve.begin());
}

TEST(LobesPlot, TheHighlightMirrorsTheLight) {
  Lobes glossy;
  glossy.along_width = glossy.across_width = 0.05f;
  const LobeCurves curves = lobe_curves(glossy, kWhite, 30);
  EXPECT_NEAR(LobeCurves::angle_deg(peak_of(curves.along)), -30, 2);
  EXPECT_NEAR(LobeCurves::angle_deg(peak_of(curves.across)), -30, 2);
}

TEST(LobesPlot, EachLobeFollowsItsSlider) {
  Lobes none;
  none.specular = none.body = none.fuzz = none.transmission = 0;
  const LobeCurves dark = lobe_curves(none, kWhite, 20);
  for (const LobeCurves::Curve* curve : {&dark.along, &dark.across, &dark.body, &dark.fuzz, &dark.through})
    EXPECT_LT(*std::max_element(curve->begin(), curve->end()), 1e-6f);
  Lobes body = none;
  body.body = 1;
  // A body without other lobes is as bright as paper of its colour.
  EXPECT_NEAR(lobe_curves(body, kWhite, 0).body[180], 1.0f, 1e-3f);
  body.transmission = 0.5f;
  const LobeCurves half = lobe_curves(body, kWhite, 0);
  EXPECT_NEAR(half.body[180], 0.5f, 1e-3f);
  EXPECT_NEAR(half.through[180], 0.5f, 1e-3f);
  Lobes fuzz = none;
  fuzz.fuzz = 1;
  const LobeCurves hair = lobe_curves(fuzz, kWhite, 20);
  EXPECT_GT(hair.fuzz[340], hair.fuzz[180]) << "fuzz is stronger at grazing angles";
}

TEST(LobesPlot, TheRimContainsThePeak) {
  Lobes sharp;
  sharp.along_width = sharp.across_width = 0.02f;
  const LobeCurves curves = lobe_curves(sharp, kWhite, 30);
  const float rim = rim_brightness(curves);
  EXPECT_GE(rim, curves.along[static_cast<size_t>(peak_of(curves.along))]);
  EXPECT_FLOAT_EQ(plotted_radius(rim, rim), 1);
  EXPECT_FLOAT_EQ(plotted_radius(rim / 8, rim), 0.5f);
}

TEST(YarnStrip, IsAThreadThatChangesWithTheYarnAndTheLight) {
  Yarn yarn;
  const Rgb red{0.8f, 0.1f, 0.1f};
  const std::vector<ImU32> strip = yarn_strip(yarn, red, 30, 60, 32);
  ASSERT_EQ(strip.size(), 60u * 32u);
  EXPECT_EQ(strip.front() >> IM_COL32_A_SHIFT, 0u) << "beside the thread";
  const ImU32 middle = strip[16 * 60 + 30];
  EXPECT_EQ(middle >> IM_COL32_A_SHIFT, 255u);
  EXPECT_GT((middle >> IM_COL32_R_SHIFT) & 255, (middle >> IM_COL32_B_SHIFT) & 255);
  EXPECT_NE(strip, yarn_strip(yarn, red, -30, 60, 32));
  yarn.lobes.body = 0.5f;
  EXPECT_NE(strip, yarn_strip(yarn, red, 30, 60, 32));
}

}  // namespace
}  // namespace weftlight::views
