// How deep the dye of fibres must be for the cloth to have the colour of its threads.

#include "reference/fibre_dye.h"

#include <gtest/gtest.h>

#include <cmath>

#include "design/yarn_presets.h"
#include "plain_cloth.h"
#include "reference/picture.h"

namespace weftlight::reference {
namespace {

TEST(DyeCurve, FindsTheDepthOfAKnownReflectance) {
  std::array<float, DyeCurve::kDepths> returned{};
  const auto reflected = [](float depth) { return 0.05f + 0.7f * std::exp(-6 * std::sqrt(depth)); };
  for (size_t i = 0; i < DyeCurve::kDepths; ++i) returned[i] = reflected(dye_depth(i));
  const DyeCurve curve(returned, 0.05f);
  for (const float depth : {0.0f, 0.0002f, 0.01f, 0.05f, 0.2f})
    EXPECT_NEAR(curve.absorption(reflected(depth)), depth, 0.02f * depth + 1e-6f) << depth;
  EXPECT_EQ(curve.absorption(0.9f), 0) << "paler than clear fibres";
  EXPECT_GT(curve.absorption(0.0f), 1) << "darker than their surfaces";
}

TEST(DyeCurve, NoiseDoesNotTurnIt) {
  std::array<float, DyeCurve::kDepths> returned{};
  returned.fill(0.5f);
  returned[3] = 0.6f;
  const DyeCurve curve(returned, 0.1f);
  float before = 0;
  for (float r = 0.9f; r > 0; r -= 0.05f) {
    EXPECT_GE(curve.absorption(r), before);
    before = curve.absorption(r);
  }
}

/// Mean reflectance of the fibres, lit from everywhere above, where they are seen.
glm::vec3 traced_reflectance(const FibreScene& fibres, const Cloth& cloth) {
  constexpr int kPixels = 16;
  glm::vec3 light(0);
  float seen = 0;
  for (const float part : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f})  // of the light of a matt cloth
    for (const float turn : {0.3f, 1.2f}) {
      const float mu = std::sqrt(part);
      FlatPicture picture;
      picture.width = picture.height = kPixels, picture.spp = 16;
      picture.step_x_mm = {cloth.width_mm / kPixels, 0}, picture.step_y_mm = {0, cloth.depth_mm / kPixels};
      const float side = std::sqrt(1 - mu * mu);
      picture.view = {side * std::cos(turn), side * std::sin(turn), mu};
      picture.around.light_irradiance = glm::vec3(0);
      picture.around.sky = [](glm::vec3 d) { return glm::vec3(d.z > 0 ? 1.0f : 0.0f); };
      for (const glm::vec4& p : trace_flat(fibres, picture, {}).pixels) light += glm::vec3(p), seen += p.a;
    }
  return light / seen;
}

// The dye of dense hair (Chiang et al. 2016), used before, knows nothing of how thick the cloth is.
TEST(FibreDye, FibresAreAsBrightAsTheThreadsTheyAreIn) {
  design::Yarn melange = design::yarn_presets()[kWool];
  melange.name = "Melange", melange.melange = 1;
  for (const design::Yarn& yarn :
       {design::yarn_presets()[kCotton], design::yarn_presets()[kSilk], design::yarn_presets()[kWool], melange}) {
    const Cloth cloth = plain(yarn, {0.5f, 0.25f, 0.08f});
    const auto scene = FibreScene::build(cloth, whole(cloth));
    ASSERT_TRUE(scene) << base::problem_of(scene);
    const glm::vec3 wanted = ThreadReflectance(cloth).of(System::kWarp, 0, {0.5f, 0.25f, 0.08f});
    const glm::vec3 traced = traced_reflectance(**scene, cloth);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(traced[c] / wanted[c], 1, 0.1) << cloth.yarns[0].name << " " << c << " " << wanted[c];
  }
}

}  // namespace
}  // namespace weftlight::reference
