#include "light/engine_pixels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weftlight::light {
namespace {

constexpr int kSheens[] = {formulas::kSheenNone,       formulas::kSheenCharlie, formulas::kSheenZeltner,
                           formulas::kSheenInverseGgx, formulas::kSheenDisney,  formulas::kSheenNoneDisney,
                           formulas::kSheenNoneAdded};

glm::vec3 direction(float from_normal, float azimuth) {
  return {std::sin(from_normal) * std::cos(azimuth), std::sin(from_normal) * std::sin(azimuth), std::cos(from_normal)};
}

/// As many pairs as no block of vectors has, some of them lit from behind a leaning pixel.
EngineDirections uneven_pairs() {
  EngineDirections out;
  for (int v = 0; v < 7; ++v)
    out.views.push_back(direction(0.2f * static_cast<float>(v), 0.7f * static_cast<float>(v)));
  for (int l = 0; l < 19; ++l) out.lights.push_back(direction(0.08f * static_cast<float>(l), static_cast<float>(l)));
  for (size_t v = 0; v < out.views.size(); ++v)
    for (size_t l = 0; l < out.lights.size(); ++l) out.pairs.push_back({v, l, glm::vec3(0), 1});
  return out;
}

EngineTexels two_texels() {
  EngineTexels out;
  out.footprint_weight = 1;
  for (const float lean : {-0.4f, 0.3f}) {
    EngineTexel t;
    t.material.base = {0.5f, 0.2f, 0.1f}, t.material.sheen = {0.1f, 0.08f, 0.05f};
    t.material.metal = lean < 0 ? 0.0f : 0.25f;
    t.normal = glm::normalize(glm::vec3(lean, 0.1f, 1));
    t.lobe = {{0.08f, 0.01f, 0.03f}, {0.7f, 0.3f}};
    t.weight = 1 + lean;
    out.texels.push_back(t);
  }
  return out;
}

EngineFit some_fit() {
  EngineFit fit;
  fit.base = {1.2f, 0.9f, 0.8f}, fit.f0 = glm::vec3(0.06f), fit.f90 = 0.8f, fit.sheen = {0.7f, 0.8f, 0.9f};
  fit.sheen_roughness = 0.35f;
  return fit;
}

/// The sums of one pair by the formulas alone.
PairRadiance by_formulas(const EngineTexels& texels, const glm::vec3& light, const glm::vec3& view,
                         const EngineModel& model, const EngineFit& fit) {
  PairRadiance out;
  for (const EngineTexel& t : texels.texels) {
    const EngineLobe lobe = engine_lobe(t, fit.lobe, texels.footprint_weight);
    formulas::EngineMaterial m = t.material;
    m.base *= fit.base, m.sheen *= fit.sheen, m.sheen_roughness = fit.sheen_roughness;
    m.f0 = fit.f0, m.f90 = fit.f90, m.alpha = lobe.alpha();
    const formulas::LobeFrame frame = formulas::lobe_frame(t.normal, {lobe.axis, 0});
    const formulas::EngineParts p =
        formulas::engine_parts(m, model.sheen, formulas::lobe_local(frame, light), formulas::lobe_local(frame, view));
    const float weight = t.weight / (texels.texels[0].weight + texels.texels[1].weight);
    out.body += p.body * p.kept * weight / fit.base, out.fuzz += p.fuzz * weight / fit.sheen;
    out.gloss += p.gloss * p.kept * weight, out.grazing += p.grazing * p.kept * weight;
  }
  return out;
}

void expect_near(const glm::vec3& a, const glm::vec3& b, const char* what) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f * std::abs(b[c]) + 1e-7f) << what;
}

TEST(EnginePixels, VectorsOfPairsGiveWhatTheFormulasGive) {
  const EngineDirections directions = uneven_pairs();
  const EngineTexels texels = two_texels();
  const EngineFit fit = some_fit();
  for (const int sheen : kSheens) {
    SCOPED_TRACE(sheen);
    const EngineModel model{.sheen = sheen};
    const std::vector<PairRadiance> all = texel_radiance(texels, directions, model, fit);
    ASSERT_EQ(all.size(), directions.pairs.size());
    for (size_t i = 0; i < all.size(); ++i) {
      const EnginePair& pair = directions.pairs[i];
      const PairRadiance one =
          by_formulas(texels, directions.lights[pair.light], directions.views[pair.view], model, fit);
      expect_near(all[i].body, one.body, "body"), expect_near(all[i].gloss, one.gloss, "gloss");
      expect_near(all[i].grazing, one.grazing, "grazing"), expect_near(all[i].fuzz, one.fuzz, "fuzz");
    }
  }
}

}  // namespace
}  // namespace weftlight::light
