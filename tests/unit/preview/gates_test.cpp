// Where methods fail: each gate also runs what fails there, so that the gate is known to bite.

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "picture.h"

namespace weftlight {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kSpacing = 0.5f;   // mm, of the test's cloth
constexpr int kPeriod = 8;         // yarns

glm::vec3 towards(float azimuth, float elevation) {
  return {std::cos(azimuth) * std::cos(elevation), std::sin(azimuth) * std::cos(elevation), std::sin(elevation)};
}

double luminance(const float* p) { return static_cast<double>(p[0] + p[1] + p[2]) / 3; }

class Gate : public PictureTest {
 protected:
  void SetUp() override {
    PictureTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    design = twill(4, 2, {0.85f, 0.8f, 0.7f}, {0.1f, 0.15f, 0.4f});
    lay(1);
  }
  /// Threads of kSpacing; `fill`: width of a thread over its room.
  void lay(float fill) {
    for (Threads* t : {&design.draft.warp, &design.draft.weft}) {
      t->spacing_mm.assign(t->color.size(), kSpacing);
      t->thickness_mm.assign(t->color.size(), 0.85f * kSpacing * fill);
    }
    Stages stages;
    stages.update(std::make_shared<const Design>(design));
    renderer->upload(stages.packed());
  }
  Image patch(Method method, float yarns, int pixels, glm::vec2 corner_mm = {0, 0}, glm::vec3 light = towards(0.8f, 0.9f),
              glm::vec3 view = {0, 0, 1}) {
    FlatPatch p;
    p.width = p.height = pixels;
    p.corner_mm = corner_mm;
    p.step_x_mm = {yarns * kSpacing, 0}, p.step_y_mm = {0, yarns * kSpacing};
    p.light_towards = light, p.view = view;
    look.method = method;
    renderer->draw_patch(p, look);
    return renderer->read_patch();
  }
  static double mean(const Image& image, int channel = -1) {
    double sum = 0;
    for (size_t i = 0; i < image.texels.size(); i += 4) {
      sum += channel < 0 ? luminance(&image.texels[i]) : static_cast<double>(image.texels[i + static_cast<size_t>(channel)]);
    }
    return sum / (static_cast<double>(image.texels.size()) / 4);
  }
  /// Whole periods, whatever the footprint.
  Image period(Method method, float yarns) {
    return patch(method, yarns, std::max(8, static_cast<int>(std::lround(kPeriod / yarns))));
  }
  Design design;
};

TEST_F(Gate, EnergyHoldsFromNearToFar) {
  for (const Method method : {Method::kRepeat, Method::kCloth}) {
    const double near = mean(period(method, 1 / 32.0f));
    for (float yarns = 1 / 16.0f; yarns <= 32; yarns *= 2) EXPECT_NEAR(mean(period(method, yarns)) / near, 1, 0.02) << yarns;
  }
  // Between rungs the models differ: held to 15 %, looser than within one.
  const double far = mean(period(Method::kAuto, 32));
  for (float yarns = 1 / 32.0f; yarns < 32; yarns *= 2) EXPECT_NEAR(mean(period(Method::kAuto, yarns)) / far, 1, 0.15) << yarns;
}

TEST_F(Gate, PanDoesNotFlickerWhereUnfilteredShadingDoes) {
  // Points of a fine picture are what an unfiltered shading at 4 yarns a pixel shows.
  const Image fine = patch(Method::kYarn, 1 / 16.0f, 128);
  const Image a = patch(Method::kAuto, 4, 16), b = patch(Method::kAuto, 4, 16, {kSpacing * 0.6f, kSpacing * 0.3f});
  double filtered = 0, unfiltered = 0;
  for (size_t i = 0; i < 16 * 16; ++i) filtered = std::max(filtered, std::abs(luminance(&a.texels[4 * i]) - luminance(&b.texels[4 * i])));
  for (size_t y = 0; y + 16 < 128; y += 32) {
    for (size_t x = 0; x + 16 < 128; x += 32) {
      const double here = luminance(&fine.texels[4 * (y * 128 + x)]), next = luminance(&fine.texels[4 * ((y + 5) * 128 + x + 10)]);
      unfiltered = std::max(unfiltered, std::abs(here - next));
    }
  }
  EXPECT_LT(filtered / mean(a), 0.06);
  EXPECT_GT(unfiltered / mean(fine), 0.4);
}

TEST_F(Gate, TurningLightShowsNoRippleWhereBooleanMapsDo) {
  design.look.method = Method::kVrst03;  // bakes its maps too
  lay(1);
  const auto ripple = [&](Method method) {
    constexpr int kSteps = 90;
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
  for (const Method method : {Method::kYarn, Method::kCell, Method::kRepeat}) {
    EXPECT_LT(ripple(method), 0.02) << static_cast<int>(method);
    EXPECT_GT(boolean, 2 * ripple(method)) << static_cast<int>(method);
  }
}

TEST_F(Gate, GapsKeepTheirShareThroughMipsWhereAnAlphaTestDoesNot) {
  lay(0.5f);
  const double near = mean(patch(Method::kAuto, 1 / 16.0f, 128), 3);
  ASSERT_LT(near, 0.95);
  for (const float yarns : {0.25f, 1.0f, 4.0f, 16.0f}) {
    const Image image = period(Method::kAuto, yarns);
    EXPECT_NEAR(mean(image, 3), near, 0.03) << yarns;
  }
  const Image far = period(Method::kAuto, 8);
  double tested = 0;
  for (size_t i = 3; i < far.texels.size(); i += 4) tested += far.texels[i] > 0.5f ? 1 : 0;
  EXPECT_GT(std::abs(tested / (static_cast<double>(far.texels.size()) / 4) - near), 0.05);
  // They close towards grazing views.
  double open = near;
  for (const float elevation : {0.9f, 0.5f, 0.2f}) {
    const double covered = mean(patch(Method::kAuto, 0.5f, 32, {0, 0}, towards(0.8f, 0.9f), towards(0.5f, elevation)), 3);
    EXPECT_GE(covered, open - 0.01);
    open = covered;
  }
  EXPECT_GT(open, near + 0.05);
}

TEST_F(Gate, GrazingLightAndViewStayNumbers) {
  for (const Method method : {Method::kFlat, Method::kCloth, Method::kRepeat, Method::kCell, Method::kYarn, Method::kEngine, Method::kAuto}) {
    for (const float view : {89.9f, 80.0f, 0.0f}) {
      for (const float light : {89.9f, 80.0f, 0.0f}) {
        const Image image = patch(method, 0.7f, 8, {0, 0}, towards(1.1f, kPi / 2 - light * kPi / 180),
                                  towards(0.4f, kPi / 2 - view * kPi / 180));
        for (const float v : image.texels) ASSERT_TRUE(std::isfinite(v) && v >= 0) << static_cast<int>(method) << " " << view << " " << light;
        if (light < 85) {
          EXPECT_GT(mean(image), 1e-4) << static_cast<int>(method) << " " << view << " " << light;
        }
      }
    }
  }
}

TEST_F(Gate, StrongLightOnNarrowLobesFitsHalfFloats) {
  design.yarns[0].lobes.along_width = design.yarns[0].lobes.across_width = 0;
  design.yarns[0].lobes.metallic = true;
  lay(1);
  FlatPatch p;
  p.width = p.height = 32;
  p.step_x_mm = {0.02f, 0}, p.step_y_mm = {0, 0.02f};
  p.light_irradiance = glm::vec3(1e6f);
  for (const Method method : {Method::kYarn, Method::kRepeat}) {
    look.method = method;
    renderer->draw_patch(p, look);
    for (const float v : renderer->read_patch().texels) ASSERT_TRUE(std::isfinite(v) && v <= 65504) << v;
  }
}

TEST_F(Gate, NoSeamBetweenRungs) {
  double before = 0;
  for (float octave = -5; octave <= 5; octave += 0.125f) {
    // Two periods each time, as far as eight pixels hold them.
    // An odd number, so that the pixels meet the threads at every phase.
    const int pixels = std::max(8, static_cast<int>(std::lround(2 * kPeriod / std::exp2(octave)))) | 1;
    const float yarns = pixels > 9 ? 2.0f * kPeriod / static_cast<float>(pixels) : std::exp2(octave);
    const double now = mean(patch(Method::kAuto, yarns, pixels));
    if (before > 0) {
      EXPECT_NEAR(now / before, 1, 0.06) << yarns;
    }
    before = now;
  }
}

TEST_F(Gate, TexturesHoldFarFromTheOriginWhereFloatUvDoesNot) {
  const float side = 8 * kPeriod * kSpacing, far = 1e5f * kPeriod * kSpacing;
  look.method = Method::kYarn;
  scene.sky_strength = 1;
  frame.transparent = true;
  renderer->set_mesh(square(side));
  const Image near_image = draw();
  renderer->set_mesh(square(side, {far, far}));
  const Image far_image = draw();
  double difference = 0;
  for (size_t i = 0; i < near_image.texels.size(); ++i) difference = std::max(difference, static_cast<double>(std::abs(near_image.texels[i] - far_image.texels[i])));
  // The mesh's own uv are floats too: they are off by up to 1 / 64 mm there, a thirtieth of a yarn.
  const Mean a = middle(near_image), b = middle(far_image);
  EXPECT_NEAR(b.sum() / a.sum(), 1, 0.02);
  // A float that holds repeats keeps no place inside a thread: steps of 1 / 128 repeat.
  const float repeats = 1e5f + 0.3f;
  EXPECT_GT(std::abs(static_cast<double>(repeats - std::floor(repeats)) - 0.3), 1e-3);
}

}  // namespace
}  // namespace weftlight
