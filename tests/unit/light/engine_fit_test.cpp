#include "light/engine_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "light/measure_response.h"
#include "weaves/weaves.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Maps, cloth::Period, cloth::bake, cloth::lay_out;
using design::Design, design::Yarn;
using draft::Face, draft::drawdown;
using weaves::Lean, weaves::plain, weaves::satin, weaves::twill;

namespace {

struct Measured {
  Cloth cloth;
  Maps maps;
  ClothResponse response;
};

Measured measured(const Design& design) {
  const Cloth cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
  Maps maps = bake(cloth, {256, 256, 16});
  ClothResponse response = measure_response(cloth, maps, 512);
  return {cloth, std::move(maps), std::move(response)};
}

/// Largest differences of a fitted material from its cloth: of the mean over a view's lights, and of the RMS.
struct Misses {
  double mean = 0, error = 0;                  // of views to 60 degrees
  double slanted_mean = 0, slanted_error = 0;  // at 71
};

Misses misses_of(const Measured& m, const EngineModel& model) {
  const EngineTexels texels = engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre);
  EXPECT_FALSE(texels.texels.empty());
  const EngineFit fit = fit_engine(texels, m.cloth, m.response, model);
  for (int c = 0; c < 3; ++c) {
    EXPECT_LE(fit.f0[c], model.most_f0);
    EXPECT_LE(fit.f0[c], fit.f90);
  }
  Misses most;
  for (const EngineScore& s : score_engine(texels, m.cloth, m.response, model, fit)) {
    if (s.view_deg > 75) continue;
    const bool slanted = s.view_deg > 60;
    double &mean = slanted ? most.slanted_mean : most.mean, &error = slanted ? most.slanted_error : most.error;
    mean = std::max(mean, static_cast<double>(std::abs(s.mean - 1)));
    error = std::max(error, static_cast<double>(s.error));
  }
  return most;
}

/// `known`: the misses as they are. A fit may not be a tenth worse, and 0.005.
void expect_no_worse(const Measured& m, const EngineModel& model, const Misses& known, const std::string& what) {
  const Misses now = misses_of(m, model);
  const auto compare = [&](const char* which, double is, double was) {
    EXPECT_LE(is, 1.1 * was + 0.005) << what << ", " << which;
  };
  compare("mean to 60 degrees", now.mean, known.mean);
  compare("error to 60 degrees", now.error, known.error);
  compare("mean at 71 degrees", now.slanted_mean, known.slanted_mean);
  compare("error at 71 degrees", now.slanted_error, known.slanted_error);
}

constexpr EngineModel kModels[] = {
    {formulas::kSheenCharlie, 1, true, true},     {formulas::kSheenZeltner, 0.08f, false, true},
    {formulas::kSheenNone, 0.16f, false, true},   {formulas::kSheenInverseGgx, 0.08f, false, false},
    {formulas::kSheenDisney, 0.08f, false, true}, {formulas::kSheenNoneDisney, 0.5f, false, true},
    {formulas::kSheenNoneAdded, 1, true, true}};

// Beside each model: plain weave, then a 3/1 twill.
constexpr Misses kMatt[][2] = {{{0.044, 0.222, 0.019, 0.224}, {0.034, 0.199, 0.044, 0.203}},
                               {{0.022, 0.276, 0.043, 0.294}, {0.036, 0.220, 0.053, 0.227}},
                               {{0.021, 0.286, 0.047, 0.306}, {0.036, 0.221, 0.054, 0.228}},
                               {{0.038, 0.269, 0.030, 0.294}, {0.024, 0.218, 0.054, 0.230}},
                               {{0.037, 0.267, 0.021, 0.251}, {0.078, 0.205, 0.015, 0.187}},
                               {{0.037, 0.267, 0.021, 0.251}, {0.078, 0.205, 0.015, 0.187}},
                               {{0.035, 0.291, 0.051, 0.318}, {0.027, 0.222, 0.047, 0.231}}};

TEST(EngineFit, MattClothsAreNoFurtherOffThanKnown) {
  const Measured cloths[] = {measured(plain({2, 2})), measured(twill({3, 1}, Lean::kRight, {4, 4}))};
  for (size_t model = 0; model < std::size(kModels); ++model)
    for (size_t cloth = 0; cloth < 2; ++cloth)
      expect_no_worse(cloths[cloth], kModels[model], kMatt[model][cloth],
                      (cloth == 0 ? "plain, model " : "twill, model ") + std::to_string(model));
}

/// A satin of combed yarns: its highlight is a narrow band across the floats.
Design shining_satin() {
  Design design = satin(8, 3, Face::kFront, {8, 8});
  for (Yarn& yarn : design.yarns) yarn.lobes.along_width = 0.08f, yarn.lobes.across_width = 0.4f, yarn.lobes.layers = 8;
  return design;
}

TEST(EngineFit, GlossySatinKeepsItsHighlight) {
  const Measured m = measured(shining_satin());
  expect_no_worse(m, kModels[0], {0.083, 0.226, 0.100, 0.325}, "satin, glTF");
  const EngineTexels texels = engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre);
  const EngineFit fit = fit_engine(texels, m.cloth, m.response, kModels[0]);
  const EngineLobe wide = engine_lobe(texels.texels[0], {}, 1), held = engine_lobe(texels.texels[0], fit.lobe, 1);
  EXPECT_LT(held.roughness, 0.9f * wide.roughness) << "the spread of the normals is no highlight";
}

TEST(EngineFit, ARoundHighlightSendsAsMuchAsTheBandOfASatin) {
  const Measured m = measured(shining_satin());
  // A round highlight cannot be a band: that is most of the error.
  expect_no_worse(m, {formulas::kSheenNone, 1, false, false}, {0.098, 0.368, 0.145, 0.471}, "satin, Unity HDRP");
  expect_no_worse(m, kModels[3], {0.090, 0.378, 0.113, 0.482}, "satin, Unreal");
}

TEST(EngineFit, WhatAnEngineCannotSetStays) {
  const Measured m = measured(twill({2, 2}, Lean::kRight, {4, 4}));
  const EngineFit fit = fit_engine(engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre), m.cloth, m.response,
                                   {formulas::kSheenNone, formulas::kEngineF0, false, false});
  EXPECT_EQ(fit.f0, glm::vec3(formulas::kEngineF0));
  EXPECT_EQ(fit.f90, 1);
  EXPECT_FALSE(fit.has_sheen());
}

TEST(EngineFit, AFitStaysBesideThatOfANeighbour) {
  const Measured m = measured(plain({2, 2}));
  const EngineTexels texels = engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre);
  const EngineFit alone = fit_engine(texels, m.cloth, m.response, {});
  EngineFit near = alone;
  near.sheen *= 0.8f, near.lobe.fibre *= 1.1f;
  const EngineFit beside = fit_engine(texels, m.cloth, m.response, {}, &near);
  EXPECT_LT(glm::distance(beside.lobe.fibre, near.lobe.fibre), 0.3f * glm::length(near.lobe.fibre));
  EXPECT_LT(beside.error, 1.05f * alone.error);
  // No neighbour: a highlight that the cloth does not have.
  near.lobe.fibre = glm::vec2(0.02f, 4);
  EXPECT_LT(fit_engine(texels, m.cloth, m.response, {}, &near).error, 1.05f * alone.error);
}

// An absorbing 0: a sheen that one round of the fit took away did not come back.
TEST(EngineFit, ASheenThatWasTakenAwayComesBack) {
  const Measured m = measured(plain({2, 2}));
  const EngineTexels texels = engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre);
  const EngineFit alone = fit_engine(texels, m.cloth, m.response, {});
  ASSERT_GT(alone.sheen.g, 0);
  EngineFit near = alone;
  near.sheen = glm::vec3(0);
  EXPECT_GT(fit_engine(texels, m.cloth, m.response, {}, &near).sheen.g, 0.5f * alone.sheen.g);
}

TEST(EngineFit, CloseViewsKeepTheYarnsOwnLobes) {
  const Measured m = measured(plain({2, 2}));
  const EngineTexels texels = engine_texels(m.cloth, m.maps, 0);
  EXPECT_EQ(texels.footprint_weight, 0);
  const EngineFit fit = fit_engine(texels, m.cloth, m.response, {});
  EXPECT_EQ(fit.lobe.fibre, glm::vec2(1, 1));
  EXPECT_EQ(fit.lobe.weft, 1);
}

TEST(EngineFit, APixelOfManyThreadsIsFlat) {
  // Its repeat is far smaller than the pixel.
  Design fine = satin(8, 3, Face::kFront, {8, 8});
  for (auto* threads : {&fine.draft.warp, &fine.draft.weft}) {
    std::fill(threads->spacing_mm.begin(), threads->spacing_mm.end(), 0.1f);
    std::fill(threads->thickness_mm.begin(), threads->thickness_mm.end(), 0.1f);
  }
  const Measured m = measured(fine);
  ASSERT_LT(m.cloth.width_mm, kFootprintMmAtOneMetre);
  for (const EngineTexel& t : engine_texels(m.cloth, m.maps, kFootprintMmAtOneMetre).texels)
    EXPECT_LT(glm::length(glm::vec2(t.normal)), 0.02f);
}

TEST(EngineFit, AFootprintIsScaledAlongItsFibres) {
  const FootprintLobe warp{{0.3f, 0, 0.2f}, {0, 1}}, mixed{{0.3f, 0, 0.2f}, {0.5f, 0.5f}};
  const glm::vec3 narrow = scaled_covariance(warp, {{0.25f, 1}, 1});
  EXPECT_FLOAT_EQ(narrow.x, 0.3f);
  EXPECT_FLOAT_EQ(narrow.z, 0.05f);
  const glm::vec3 even = scaled_covariance(mixed, {{0.25f, 1}, 1});
  EXPECT_FLOAT_EQ(even.x, 0.15f);
  EXPECT_FLOAT_EQ(even.z, 0.1f);
  const glm::vec3 wide = scaled_covariance(mixed, {{1, 1}, 2});
  EXPECT_FLOAT_EQ(wide.x, 0.6f);
  EXPECT_FLOAT_EQ(wide.z, 0.1f);
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

/// Light that a material sends to a view from an even sky of 1: from its lights one by one.
glm::vec3 from_all_lights(const formulas::EngineMaterial& m, const formulas::LobeFrame& frame, const glm::vec3& view) {
  constexpr int kRings = 64, kAround = 96;
  glm::vec3 sum(0);
  for (int i = 0; i < kRings; ++i) {
    const float z = (static_cast<float>(i) + 0.5f) / kRings, r = std::sqrt(1 - z * z);
    for (int k = 0; k < kAround; ++k) {
      const float a = (static_cast<float>(k) + 0.5f) * 6.2831853f / kAround;
      sum += formulas::engine_radiance(m, frame, {r * std::cos(a), r * std::sin(a), z}, view).key;
    }
  }
  return sum * (6.2831853f / (kRings * kAround));
}

// The body kept all its light and rough highlights theirs: plain weave was half as bright again under an even sky.
TEST(EngineMethod, AnEvenSkyIsTheSumOfItsLights) {
  const formulas::LobeFrame frame = formulas::lobe_frame({0, 0, 1}, {1, 0, 0});
  const auto material = [](float base, float sheen, glm::vec2 alpha, float f0, float f90) {
    return formulas::EngineMaterial{glm::vec3(base), 0, glm::vec3(sheen), 0.9f, alpha, glm::vec3(f0), f90, 1};
  };
  const formulas::EngineMaterial materials[] = {
      material(0.3f, 0.3f, {0.7f, 0.7f}, 0.25f, 1), material(0.1f, 0, {0.5f, 0.2f}, 0.14f, 1),
      material(0.6f, 0, {0.8f, 0.8f}, 0.04f, 1), material(0.3f, 0.2f, {0.4f, 0.4f}, 0.02f, 0.1f)};
  for (size_t i = 0; i < std::size(materials); ++i) {
    for (const float degrees : {0.0f, 30.0f, 60.0f}) {
      const float t = degrees * 0.01745329f;
      const glm::vec3 view{0.7f * std::sin(t), std::sqrt(0.51f) * std::sin(t), std::cos(t)};
      const formulas::Reflected sky = formulas::engine_radiance(materials[i], frame, {0, 0, 1}, view);
      const float lights = from_all_lights(materials[i], frame, view).g;
      EXPECT_NEAR(sky.diffuse.g + sky.glossy.g, lights, 0.1f * lights) << "material " << i << ", " << degrees;
    }
  }
}

}  // namespace
}  // namespace weftlight::light
