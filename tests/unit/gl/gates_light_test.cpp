// Gates of light on the graphics card: turning, grazing, strong. What fails at grazing and in half floats is run by
// the gates of core/light, from the same formulas.

#include <array>
#include <glm/gtc/packing.hpp>
#include <numeric>

#include "gate.h"

namespace weftlight::gl {
namespace {

constexpr std::array kShadedMethods{Method::kFlat, Method::kCloth,  Method::kRepeat, Method::kCell,
                                    Method::kYarn, Method::kEngine, Method::kAuto};

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
  EXPECT_GT(boolean, 0.06);
  for (const Method method : {Method::kYarn, Method::kCell, Method::kRepeat, Method::kCloth, Method::kAuto}) {
    const double ours = ripple(method);
    figure("ripple while the light turns, " + std::string(method_name(method)), boolean, ours);
    // Of yarn also the shadows that a finite number of samples meets one after another.
    EXPECT_LT(ours, method == Method::kYarn || method == Method::kAuto ? 0.02 : 0.006) << method_name(method);
  }
}

TEST_F(Gate, GrazingLightAndViewStayNumbers) {
  lay(1);
  for (const Method method : kShadedMethods) {
    for (const float view : {89.9f, 80.0f, 0.0f}) {
      for (const float light : {89.9f, 80.0f, 0.0f}) {
        const Image image = patch(method, 0.7f, 8, {0, 0}, towards(1.1f, kPi / 2 - light * kPi / 180),
                                  towards(0.4f, kPi / 2 - view * kPi / 180));
        for (const float v : image.texels)
          ASSERT_TRUE(std::isfinite(v) && v >= 0) << method_name(method) << " " << view << " " << light;
        EXPECT_GT(mean(image), light < 85 ? 1e-3 : 1e-6) << method_name(method) << " " << view << " " << light;
        EXPECT_LT(mean(image), 20) << method_name(method) << " " << view << " " << light;
      }
    }
  }
}

TEST_F(Gate, AnyRoughnessStaysANumberAndIsNotBlack) {
  lay(1);
  for (const float width : {0.0f, 1e-3f, 30.0f, 1e6f}) {
    design.yarns[0].lobes.along_width = design.yarns[0].lobes.across_width = width;
    renderer->upload_lobes(*stages.update(std::make_shared<const Design>(design)).lobes);
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
    EXPECT_EQ(glm::unpackHalf1x16(glm::packHalf1x16(bare)), std::numeric_limits<float>::infinity())
        << method_name(method);
    EXPECT_LE(ours, 65504) << method_name(method);
  }
}

}  // namespace
}  // namespace weftlight::gl
