// Gates of lighting on the GPU: turning, grazing, strong light. The formulas that fail at grazing angles and in half
// floats are run by the gates of core/light.

#include <array>
#include <numeric>

#include "gate.h"

namespace weftlight::gl {

using design::Design, design::Method, design::method_name;
using files::Image;
using render_data::Effort, render_data::FlatPatch;

namespace {

constexpr std::array kShadedMethods{Method::kFlat, Method::kCloth,  Method::kRepeat, Method::kCell,
                                    Method::kYarn, Method::kEngine, Method::kAuto};

/// What bounds a method at grazing light and view.
struct Grazing {
  Method method;
  double albedo;      // largest over views: threads of albedo 0.78 and 0.22 return less than the brighter ones
  double reciprocal;  // largest quotient of the BRDF and the same with light and view exchanged, to 80 degrees
};

// Exact for a colour alone. The others light and see the threads by formulas of their own; the cells' are known to be
// far from reciprocal, and all of them at the horizon, which is reported.
constexpr Grazing kGrazing[] = {{Method::kFlat, 0.33, 1.001}, {Method::kCloth, 0.47, 1.18},
                                {Method::kRepeat, 0.5, 1.2},  {Method::kCell, 0.27, 2.45},
                                {Method::kYarn, 0.43, 1.3},   {Method::kEngine, 0.42, 1.14},
                                {Method::kAuto, 0.43, 1.3}};

TEST_F(Gate, TurningLightShowsNoRippleWhereBooleanMapsDo) {
  design.look.method = Method::kVrst03;  // bakes its maps too
  lay(1);
  const auto ripple = [&](Method method) {
    constexpr int kSteps = 180;
    std::vector<double> at;
    for (int i = 0; i < kSteps; ++i) {
      at.push_back(mean(patch(method, 0.5f, 16, {0, 0}, towards(2 * kPi * static_cast<float>(i) / kSteps, 0.6f))));
    }
    double most = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double bend = at[static_cast<size_t>((i + 1) % kSteps)] - 2 * at[static_cast<size_t>(i)] +
                          at[static_cast<size_t>((i + kSteps - 1) % kSteps)];
      most = std::max(most, std::abs(bend));
    }
    return most / (std::accumulate(at.begin(), at.end(), 0.0) / kSteps);
  };
  const double boolean = ripple(Method::kVrst03);
  for (const Method method : {Method::kYarn, Method::kCell, Method::kRepeat, Method::kCloth, Method::kAuto}) {
    const double ours = ripple(method);
    figure("ripple while the light turns, " + std::string(method_name(method)), boolean, ours);
    // For yarn also the shadows that a finite number of samples meets.
    EXPECT_LT(ours, method == Method::kYarn || method == Method::kAuto ? 0.02 : 0.006) << method_name(method);
  }
}

TEST_F(Gate, GrazingLightAndViewConserveEnergyAndChangePlaces) {
  lay(1);
  const float irradiance = FlatPatch().light_irradiance.x;
  const auto at = [](float degrees, float azimuth) { return towards(azimuth, kPi / 2 - degrees * kPi / 180); };
  for (const Grazing& g : kGrazing) {
    const auto radiance = [&](const glm::vec3& light, const glm::vec3& view) {
      const Image image = patch(g.method, 0.7f, 8, {0, 0}, light, view);
      for (const float v : image.texels) EXPECT_TRUE(std::isfinite(v) && v >= 0) << method_name(g.method);
      return mean(image) / static_cast<double>(irradiance);
    };
    double albedo = 0, least = 9, apart = 1, apart_at_horizon = 1;
    for (const float degrees : {89.9f, 80.0f, 0.0f}) {
      // Rings of equal solid angle; radiance under unit irradiance is BRDF times cosine.
      constexpr int kRings = 10, kTurns = 8;
      double sum = 0;
      for (int i = 0; i < kRings; ++i) {
        const float elevation = std::asin((static_cast<float>(i) + 0.5f) / kRings);
        for (int j = 0; j < kTurns; ++j) {
          const float turn = 2 * kPi * (static_cast<float>(j) + 0.3f) / kTurns;
          sum +=
              radiance(towards(turn, elevation), at(degrees, 0.4f)) * static_cast<double>(2 * kPi) / (kRings * kTurns);
        }
      }
      albedo = std::max(albedo, sum), least = std::min(least, sum);
    }
    const auto quotient = [&](const glm::vec3& one, const glm::vec3& other) {
      const double there = radiance(one, other) / static_cast<double>(one.z),
                   back = radiance(other, one) / static_cast<double>(other.z);
      return std::max(there / back, back / there);
    };
    for (const auto& [one, other] :
         {std::pair{at(80, 1.1f), at(0, 0)}, {at(80, 1.1f), at(45, 3)}, {at(60, 2), at(30, 5)}})
      apart = std::max(apart, quotient(one, other));
    apart_at_horizon = quotient(at(89.9f, 1.1f), at(0, 0));
    figure("light and view exchanged, at 89.9 degrees and to 80, " + std::string(method_name(g.method)),
           apart_at_horizon, apart);
    EXPECT_LT(albedo, g.albedo) << method_name(g.method);
    EXPECT_GT(least, 0.1) << "black at some view: " << method_name(g.method);
    EXPECT_LT(apart, g.reciprocal) << method_name(g.method);
  }
}

TEST_F(Gate, AnyRoughnessStaysANumberAndIsNotBlack) {
  lay(1, Effort::kQuick);
  for (const float width : {0.0f, 1e-3f, 30.0f, 1e6f}) {
    design.yarns[0].lobes.along_width = design.yarns[0].lobes.across_width = width;
    renderer->upload_lobes(*stages.update(std::make_shared<const Design>(design), Effort::kQuick).lobes);
    for (const Method method : kShadedMethods) {
      const Image image = patch(method, 0.7f, 8);
      for (const float v : image.texels) ASSERT_TRUE(std::isfinite(v) && v >= 0) << method_name(method) << " " << width;
      EXPECT_GT(mean(image), 0.01) << method_name(method) << " " << width;
    }
  }
}

TEST_F(Gate, StrongLightOnNarrowLobesFitsHalfFloats) {
  design.yarns[0].lobes.along_width = design.yarns[0].lobes.across_width = 0;
  design.yarns[0].lobes.metallic = true;
  lay(1);
  constexpr float kStrong = 1e8f;
  FlatPatch p;
  p.width = p.height = 32;
  p.step_x_mm = {0.02f, 0}, p.step_y_mm = {0, 0.02f};
  const auto brightest = [&](Method method, float irradiance) {
    p.light_irradiance = glm::vec3(irradiance);
    look.method = method;
    renderer->draw_patch(p, look);
    float most = 0;
    const Image image = renderer->read_patch();
    for (size_t i = 0; i < image.texels.size(); ++i) {
      EXPECT_TRUE(std::isfinite(image.texels[i]));
      if (i % 4 != 3) most = std::max(most, image.texels[i]);
    }
    return most;
  };
  for (const Method method : {Method::kYarn, Method::kCell, Method::kRepeat, Method::kAuto}) {
    const float bare = brightest(method, 1) * kStrong, ours = brightest(method, kStrong);
    figure("brightest pixel under a strong light, " + std::string(method_name(method)), static_cast<double>(bare),
           static_cast<double>(ours));
    EXPECT_LE(ours, 65504) << method_name(method);
  }
}

}  // namespace
}  // namespace weftlight::gl
