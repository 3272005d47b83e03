#include "light/engine_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "draft/generators.h"

namespace weftlight::light {
namespace {

struct Measured {
  Cloth cloth;
  Maps maps;
  ClothResponse response;
};

Measured measured(const Design& design) {
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  Maps maps = bake(cloth, {256, 256, 16});
  ClothResponse response = cloth_response(cloth, maps, 512);
  return {cloth, std::move(maps), std::move(response)};
}

TEST(EngineFit, ComesNearTheMeasuredCloth) {
  const Measured m = measured(plain({2, 2}));
  const EngineTexels seen = engine_texels(m.cloth, m.maps, 1);
  ASSERT_FALSE(seen.texels.empty());
  for (const int sheen : {formulas::kSheenNone, formulas::kSheenCharlie, formulas::kSheenZeltner,
                          formulas::kSheenInverseGgx, formulas::kSheenDisney}) {
    const EngineFit fit = fit_engine(seen.texels, m.cloth, m.response, {sheen, true});
    EXPECT_LT(fit.error, 0.35f) << sheen;
    EXPECT_GT(fit.base.g, 0.3f) << sheen;
    EXPECT_LE(fit.specular, 2) << sheen;
    RecordProperty("error_" + std::to_string(sheen), std::to_string(fit.error));
  }
}

TEST(EngineFit, HeldSpecularStaysWhole) {
  const Measured m = measured(twill({2, 2}, Lean::kRight, {4, 4}));
  const EngineFit fit =
      fit_engine(engine_texels(m.cloth, m.maps, 1).texels, m.cloth, m.response, {formulas::kSheenNone, false});
  EXPECT_EQ(fit.specular, 1);
  EXPECT_EQ(fit.sheen, 0);
}

/// Albedo over a hemisphere of lights, of a sheen alone.
double sheen_albedo(int model, float roughness, float view_cosine) {
  formulas::EngineMaterial m{};
  m.sheen = glm::vec3(1), m.sheen_roughness = roughness, m.alpha = glm::vec2(0.5f);
  const glm::vec3 wo{std::sqrt(1 - view_cosine * view_cosine), 0, view_cosine};
  double sum = 0;
  constexpr int kElevations = 64, kAzimuths = 64;
  for (int i = 0; i < kElevations; ++i) {
    for (int j = 0; j < kAzimuths; ++j) {
      const float z = (static_cast<float>(i) + 0.5f) / kElevations, a = 6.2831853f * static_cast<float>(j) / kAzimuths;
      const float r = std::sqrt(1 - z * z);
      sum += static_cast<double>(formulas::engine_parts(m, model, {r * std::cos(a), r * std::sin(a), z}, wo).fuzz.g);
    }
  }
  return sum * 6.2831853 / (kElevations * kAzimuths);
}

TEST(EngineFit, SheenGivesBackNoMoreThanItGets) {
  for (const float cosine : {0.2f, 0.5f, 1.0f}) {
    for (const float roughness : {0.3f, 0.6f, 1.0f}) {
      EXPECT_LT(sheen_albedo(formulas::kSheenCharlie, roughness, cosine), 1.0);
      EXPECT_NEAR(sheen_albedo(formulas::kSheenZeltner, roughness, cosine),
                  static_cast<double>(formulas::zeltner_albedo(cosine, roughness)), 0.03)
          << "the transformed cosine has the albedo as its whole: " << cosine << " " << roughness;
    }
  }
}

}  // namespace
}  // namespace weftlight::light
