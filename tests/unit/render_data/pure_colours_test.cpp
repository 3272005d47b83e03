// A channel of a thread's colour at exactly 0 is a dark colour like any other: the answers from afar go evenly to it,
// and are those of the threads traced as bodies.

#include "pure_colours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "draft/drawdown.h"
#include "reference/picture.h"
#include "render_data/far_field.h"
#include "scene/exposure.h"

namespace weftlight::render_data {

using base::problem_of;
using cloth::Cloth, cloth::Period, cloth::lay_out;
using design::Design, design::Yarn;
using draft::Face, draft::Rgb, draft::drawdown;
using reference::FlatPicture, reference::Surroundings, reference::TubeScene, reference::trace_flat;
using scene::mean_reflectance;

namespace {

constexpr int kSamples = 512;  // places; the same for every colour

glm::vec3 tilted(float azimuth_deg, float degrees) {
  const float a = glm::radians(azimuth_deg), t = glm::radians(degrees);
  return {std::cos(a) * std::sin(t), std::sin(a) * std::sin(t), std::cos(t)};
}

struct Lit {
  const char* name;
  glm::vec3 view, light;
};
const std::array<Lit, 3> kLit{{{"lit from before", tilted(0, 0), tilted(35, 40)},
                               {"lit from before, at a slant", tilted(-73, 60), tilted(35, 40)},
                               {"lit from behind", tilted(0, 0), tilted(35, 140)}}};

Cloth cloth_of(const Design& design, Face face) {
  return lay_out(design, drawdown(design.draft), face, Period::kRepeat);
}

/// What all lights make of a cloth; last its sky.
std::array<glm::vec3, kLit.size() + 1> answers(const Design& design, Face face) {
  const FarField far = far_field(cloth_of(design, face), kSamples);
  std::array<glm::vec3, kLit.size() + 1> out;
  for (size_t i = 0; i < kLit.size(); ++i) out[i] = far_field_radiance(far, kLit[i].light, kLit[i].view);
  out.back() = far_field_sky_radiance(far, kLit[1].view, 0.5f, {0, 0, 0.5f});
  return out;
}

/// The last step, from 1 of 255 to 0, changes no more than those from 8 to 1 did: the root of a colour, which fuzz has,
/// falls by as much.
template <class Make>
void expect_even(const Make& make, const std::string& what) {
  for (const Face face : {Face::kFront, Face::kBack}) {
    const auto eight = answers(make(8), face), one = answers(make(1), face), none = answers(make(0), face);
    for (size_t i = 0; i < none.size(); ++i) {
      const float bright = std::max({eight[i].r, eight[i].g, eight[i].b});
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(none[i][c], one[i][c], std::abs(eight[i][c] - one[i][c]) + 0.005f * bright)
            << what << (face == Face::kFront ? ", front, " : ", back, ") << (i < kLit.size() ? kLit[i].name : "sky")
            << ", channel " << c;
      }
    }
  }
}

TEST(PureColours, AnswersGoEvenlyTo0WithAChannel) {
  const std::array yarns{Yarn{}, yarn_named("Silk"), metal_yarn()};
  const std::array names{"cotton", "silk", "metal"};
  for (size_t k = 0; k < yarns.size(); ++k) {
    const std::string of = names[k];
    const Rgb white = of_255(255, 255, 255);
    expect_even([&](int v) { return plain_in(of_255(v, v, v), white, yarns[k]); }, of + ": black and white");
    expect_even([&](int v) { return striped_in(of_255(v, v, v), white, yarns[k]); }, of + ": black and white stripes");
    expect_even([&](int v) { return plain_in(of_255(255, v, v), of_255(v, v, v), yarns[k]); }, of + ": red and black");
    expect_even([&](int v) { return plain_in(of_255(0, 128, 255), of_255(0, v, 255), yarns[k]); }, of + ": blues");
  }
}

// Red, green and blue are alike: the answers are those of the same cloth with its channels in another order.
TEST(PureColours, NoChannelCountsForMoreThanAnother) {
  for (const Yarn& yarn : {Yarn{}, yarn_named("Silk"), metal_yarn()}) {
    const auto red = answers(plain_in(of_255(255, 0, 0), of_255(200, 100, 0), yarn), Face::kFront),
               green = answers(plain_in(of_255(0, 255, 0), of_255(0, 200, 100), yarn), Face::kFront);
    for (size_t i = 0; i < red.size(); ++i)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(red[i][c], green[i][(c + 1) % 3], 1e-3f * red[i].r) << i << ' ' << c;
  }
}

class PureColoursTraced : public ::testing::Test {
 protected:
  /// Mean over a period.
  static glm::vec3 traced(const TubeScene& tubes, const Cloth& cloth, const glm::vec3& view,
                          const Surroundings& around) {
    constexpr int kSide = 24, kRays = 49;
    FlatPicture p;
    p.width = p.height = kSide, p.spp = kRays;
    p.step_x_mm = {cloth.width_mm / kSide, 0}, p.step_y_mm = {0, cloth.depth_mm / kSide};
    p.view = view, p.around = around;
    glm::vec3 sum(0);
    for (const glm::vec4& c : trace_flat(tubes, p, {}).pixels) sum += glm::vec3(c);
    return sum / static_cast<float>(kSide * kSide);
  }

  /// Each channel to a tenth of itself and a two-hundredth of the brightest; from behind, where hardly any light comes
  /// through, a fifth.
  static void expect_as_traced(const Design& design, Face face, const std::string& what) {
    const Cloth cloth = cloth_of(design, face);
    const auto ours = answers(design, face);
    const auto built = TubeScene::build(cloth, {});
    ASSERT_TRUE(built) << problem_of(built);
    const std::unique_ptr<TubeScene>& tubes = *built;
    for (size_t i = 0; i < ours.size(); ++i) {
      const bool sky = i == kLit.size();
      Surroundings around;
      around.light_irradiance = glm::vec3(sky ? 0.0f : 1.0f);
      if (sky) around.sky = [](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * d.z); };
      else around.light_towards = kLit[i].light;
      const glm::vec3 truth = traced(*tubes, cloth, sky ? kLit[1].view : kLit[i].view, around);
      const bool behind = !sky && kLit[i].light.z < 0;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(ours[i][c], truth[c],
                    (behind ? 0.2f : 0.1f) * truth[c] + 0.005f * std::max({truth.r, truth.g, truth.b}))
            << what << ", " << (sky ? "sky" : kLit[i].name) << ", channel " << c;
      }
    }
  }
};

TEST_F(PureColoursTraced, PairsAnswerAsTheTracedThreads) {
  for (const ColourPair& pair : kPurePairs) expect_as_traced(plain_in(pair.warp, pair.weft), Face::kFront, pair.name);
  const ColourPair& red_white = kPurePairs[1];
  expect_as_traced(plain_in(red_white.warp, red_white.weft), Face::kBack, "red, white, back");
  expect_as_traced(plain_in(red_white.warp, red_white.weft, yarn_named("Silk")), Face::kFront, "red, white silk");
  expect_as_traced(plain_in(red_white.warp, red_white.weft, metal_yarn()), Face::kFront, "red, white metal");
}

// Pictures are exposed by the cloth's reflectance, which has no step either.
TEST(PureColours, ExposureGoesEvenlyTo0WithAChannel) {
  const auto reflectance = [](int v) {
    const Design d = plain_in(of_255(v, v, v), of_255(255, v, v));
    return mean_reflectance(far_field(cloth_of(d, Face::kFront), 64).numbers);
  };
  EXPECT_NEAR(reflectance(0), reflectance(1), reflectance(8) - reflectance(1));
}

}  // namespace
}  // namespace weftlight::render_data
