// Automatic exposure brightens dark cloths and leaves white ones white, and a darker cloth still looks darker.

#include "scene/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weftlight::scene {

using design::Look;

namespace {

TEST(Exposure, DarkClothsStayDarkerThanBrightOnes) {
  float shown = 0;
  for (int step = 0; step < 55; ++step) {
    const float reflectance = 0.005f * std::pow(1.1f, static_cast<float>(step));
    const float now = reflectance * std::exp2(exposure_for(reflectance));
    EXPECT_GT(now, shown);
    EXPECT_GE(now, reflectance) << "no cloth is lowered";
    shown = now;
  }
  EXPECT_GT(exposure_for(0.03f), 1);
  EXPECT_LT(exposure_for(0.9f), 0.4f) << "white is not burnt";
  EXPECT_GE(exposure_for(1), 0) << "nor greyed";
  EXPECT_TRUE(std::isfinite(exposure_for(0)));
}

TEST(Exposure, IsOfTheThreadsAndNotOfTheGaps) {
  interop::ClothData cloth{};
  const auto fill = [&](float color, float coverage) {
    for (interop::SystemData& s : cloth.systems) {
      s.color = {color, color, color, 0};
      s.yarn.body = 1;
      s.fraction = 0.5f, s.coverage = coverage;
    }
    return mean_reflectance(cloth);
  };
  EXPECT_NEAR(fill(0.4f, 0.5f), 0.4f, 0.01f);
  EXPECT_EQ(fill(0.4f, 0.5f), fill(0.4f, 0.1f));
  EXPECT_LT(fill(0.1f, 0.5f), fill(0.2f, 0.5f));
  Look look;
  look.exposure_ev = 1;
  EXPECT_NEAR(exposure_stops(look, cloth, {}), 1 + exposure_for(mean_reflectance(cloth)), 1e-6);
  look.automatic_exposure = false;
  EXPECT_EQ(exposure_stops(look, cloth, {}), 1);
}

}  // namespace
}  // namespace weftlight::scene
