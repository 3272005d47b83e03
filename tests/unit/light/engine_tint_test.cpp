#include "light/engine_tint.h"

#include <gtest/gtest.h>

#include <vector>

namespace weftlight::light {

namespace {

glm::vec3 view_at(float from_normal, float azimuth) {
  return {std::sin(from_normal) * std::cos(azimuth), std::sin(from_normal) * std::sin(azimuth), std::cos(from_normal)};
}

/// What a material reflects by view that has this tint and no highlight, or nothing else.
struct Material {
  glm::vec3 base{1};
  ViewTint tint;
  float gloss = 0;
  glm::vec3 body_at(const glm::vec3& view) const { return gloss > 0 ? glm::vec3(0) : base * tint.base_at(view); }
  glm::vec3 gloss_at(const glm::vec3& view) const { return glm::vec3(gloss * tint.shine_at(view)); }
};

std::vector<TintedMean> means_of(const Material& cloth, const Material& engine) {
  std::vector<TintedMean> out;
  for (const float from_normal : {0.0f, 0.3f, 0.6f, 0.9f, 1.2f, 1.35f}) {
    for (const float azimuth : {0.0f, 0.8f, 1.571f}) {
      const glm::vec3 view = view_at(from_normal, azimuth), body = engine.body_at(view), gloss = engine.gloss_at(view);
      TintedMean mean;
      mean.wanted = cloth.body_at(view) + cloth.gloss_at(view), mean.whole = body + gloss, mean.body = body;
      mean.weight = 1.0f / (mean.wanted * mean.wanted);
      const glm::vec4 slant = ViewTint::slant(view);
      for (int k = 0; k < 4; ++k) mean.body_by[static_cast<size_t>(k)] = body * slant[k];
      for (int k = 0; k < 2; ++k) mean.gloss_by[static_cast<size_t>(k)] = gloss * slant[k + 2];
      out.push_back(mean);
    }
  }
  return out;
}

}  // namespace

TEST(ViewTint, IsNoneAtNormalViewAndOneMinusTheCosineBeyond) {
  EXPECT_EQ(ViewTint::slant({0, 0, 1}), glm::vec4(0));
  const glm::vec3 view = view_at(1.2f, 0.4f);
  const glm::vec4 slant = ViewTint::slant(view);
  EXPECT_NEAR(slant.x + slant.y, 1 - view.z, 1e-6f);
  EXPECT_NEAR(slant.z + slant.w, (1 - view.z) * (1 - view.z), 1e-6f);
}

TEST(ViewTint, ComesToThatOfACloth) {
  Material cloth, engine;
  cloth.base = {0.5f, 0.3f, 0.2f};
  cloth.tint.weft = {0.4f, -0.3f, -0.2f}, cloth.tint.late_weft = {0.2f, -0.5f, 0.3f};
  cloth.tint.late_warp = {-1.5f, 0, 0.8f};
  engine.base = glm::vec3(0.4f);
  for (int step = 0; step < 12; ++step) move_tint(engine.base, engine.tint, 1, means_of(cloth, engine));
  for (const TintedMean& mean : means_of(cloth, engine)) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean.whole[c] / mean.wanted[c], 1, 0.02);
  }
  EXPECT_EQ(engine.tint.shine, glm::vec2(0));
}

TEST(ViewTint, AHighlightGrowsNoMoreThanItMay) {
  Material cloth, engine;
  cloth.gloss = engine.gloss = 0.2f;
  cloth.tint.shine = {-0.4f, 1.5f};
  for (const float most : {2.0f, 0.7f}) {
    for (int step = 0; step < 8; ++step) move_tint(engine.base, engine.tint, most, means_of(cloth, engine));
    EXPECT_NEAR(engine.tint.shine.x, -0.4f, 0.02f);
    EXPECT_NEAR(engine.tint.shine.y, std::min(1.5f, most), 0.02f);
  }
  EXPECT_EQ(engine.base, glm::vec3(1));
}

}  // namespace weftlight::light
