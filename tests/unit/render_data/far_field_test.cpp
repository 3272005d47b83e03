// Far-field radiance against the traced threads, for lights on both sides.

#include "render_data/far_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "base/resources.h"
#include "draft/drawdown.h"
#include "reference/picture.h"
#include "wif/wif.h"

namespace weftlight::render_data {

using base::presets_dir, base::problem_of, base::read_file;
using cloth::Cloth, cloth::Period, cloth::lay_out;
using design::Design;
using draft::Face, draft::System, draft::drawdown;
using light::kViewAzimuths, light::response_views;
using reference::Colours, reference::FlatPicture, reference::Surroundings, reference::TubeHit, reference::TubeScene,
    reference::trace_flat;

namespace {

constexpr std::array kDrafts{"plain", "twill_2_2", "satin_8", "twill_damask", "denim", "gauze"};
constexpr float kViewAzimuth = -73;  // degrees, not along a thread

glm::vec3 tilted(float azimuth_deg, float degrees) {
  const float a = glm::radians(azimuth_deg), t = glm::radians(degrees);
  return {std::cos(a) * std::sin(t), std::sin(a) * std::sin(t), std::cos(t)};
}

double grey(const glm::vec3& c) { return static_cast<double>(c.r + c.g + c.b) / 3; }

struct Shipped {
  std::string name;
  Cloth cloth;
  FarField field;
  std::unique_ptr<TubeScene> tubes;
};

class FarFields : public ::testing::Test {
 protected:
  static std::vector<Shipped> cloths;
  static void SetUpTestSuite() {
    for (const char* name : kDrafts) {
      const wif::WifRead read = wif::read_wif(read_file(presets_dir() + "/drafts/" + name + ".wif").value_or(""));
      ASSERT_TRUE(read.file) << name;
      const Design& design = read.file->design;
      Shipped made;
      made.name = name;
      made.cloth = lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat);
      made.field = far_field(made.cloth);
      auto tubes = TubeScene::build(made.cloth, {});
      ASSERT_TRUE(tubes) << problem_of(tubes);
      made.tubes = std::move(*tubes);
      cloths.push_back(std::move(made));
    }
  }
  static void TearDownTestSuite() { cloths.clear(); }

  /// Mean over a period. With 36 rays a pixel no ratio is farther from its limit, but those of light between threads.
  static glm::vec3 traced_colour(const Shipped& of, const glm::vec3& view, const Surroundings& around, int rays = 16,
                                 int bounces = 0) {
    constexpr int kSide = 48;
    FlatPicture p;
    p.bounces = bounces;
    if (bounces > 0) p.colours = Colours::kOfTheCloth;
    p.width = p.height = kSide, p.spp = rays;
    p.step_x_mm = {of.cloth.width_mm / kSide, 0}, p.step_y_mm = {0, of.cloth.depth_mm / kSide};
    p.view = view, p.around = around;
    glm::vec3 sum(0);
    for (const glm::vec4& c : trace_flat(*of.tubes, p, {}).pixels) sum += glm::vec3(c);
    return sum / static_cast<float>(kSide * kSide);
  }
  static glm::vec3 traced_colour(const Shipped& of, const glm::vec3& view, const glm::vec3& light) {
    Surroundings around;
    around.light_towards = light, around.light_irradiance = glm::vec3(1);
    return traced_colour(of, view, around);
  }
  template <class Light>
  static double traced(const Shipped& of, const glm::vec3& view, const Light& light) {
    return grey(traced_colour(of, view, light));
  }
};
std::vector<Shipped> FarFields::cloths;

// Texels at the edge of a thread belong to one system all the same: on satin the maps overestimated the weft by a
// quarter.
TEST_F(FarFields, SharesAreWhatRaysSeeOfEachSystem) {
  constexpr int kRays = 40'000;
  for (const Shipped& cloth : cloths) {
    int warp = 0, all = 0;
    for (int k = 1; k <= kRays; ++k) {
      const glm::vec2 at(std::fmod(0.7548776662466927 * k, 1.0) * static_cast<double>(cloth.cloth.width_mm),
                         std::fmod(0.5698402909980532 * k, 1.0) * static_cast<double>(cloth.cloth.depth_mm));
      TubeHit hit;
      if (!cloth.tubes->intersect({at.x, at.y, cloth.tubes->z_max()}, {0, 0, -1}, 0, hit)) continue;
      ++all, warp += hit.system == System::kWarp;
    }
    EXPECT_NEAR(cloth.field.response.systems[0].fraction, static_cast<float>(warp) / static_cast<float>(all), 0.006f)
        << cloth.name;
  }
}

// A yarn's colour is that of its cloth: light between threads moves from faces to grooves and does not add to the
// whole.
TEST_F(FarFields, LightBetweenThreadsLeavesTheMean) {
  constexpr int kBounces = 4, kRays = 36;
  for (const Shipped& cloth : cloths) {
    if (cloth.name == "satin_8" || cloth.name == "twill_2_2" || cloth.name == "gauze")
      continue;  // slow, and no different
    for (const float tilt : {0.0f, 60.0f}) {
      for (const float lit_from : {30.0f, 75.0f}) {
        Surroundings around;
        around.light_towards = tilted(35, lit_from), around.light_irradiance = glm::vec3(1);
        const glm::vec3 view = tilted(kViewAzimuth, tilt);
        const double ratio =
            grey(traced_colour(cloth, view, around, kRays, kBounces)) / grey(traced_colour(cloth, view, around, kRays));
        // Low light stays on the faces.
        EXPECT_NEAR(ratio, 1, lit_from > 60 ? 0.09 : 0.06) << cloth.name << " view " << tilt << " light " << lit_from;
      }
    }
  }
}

// Other threads occlude nearly all of it: what remains is a fiftieth of the radiance under the same light from the
// front. A closed twill of worsted has but slits between shiny sides.
TEST_F(FarFields, LightFromBehindComesThroughThePlacesThatNoThreadHides) {
  for (const Shipped& cloth : cloths) {
    for (const float tilt : {0.0f, 60.0f}) {
      const glm::vec3 view = tilted(kViewAzimuth, tilt), before = tilted(35, 40), behind = tilted(35, 140);
      const double truth = traced(cloth, view, behind), bright = traced(cloth, view, before);
      const double holds = 0.1 * truth + (cloth.name == "twill_2_2" ? 0.0036 : 0.0015) * bright;
      EXPECT_NEAR(grey(far_field_radiance(cloth.field, behind, view)), truth, holds)
          << cloth.name << " at " << tilt << " degrees";
    }
  }
}

// Pinholes are narrow: lights between the nodes, weighted by their radiance. Satin transmits almost nothing; the rest
// is mirrored by few sides.
TEST_F(FarFields, LightFromBehindHoldsBetweenTheNodesToo) {
  const std::array lights{tilted(100, 140), tilted(-73, 140), tilted(0, 180), tilted(35, 155), tilted(160, 130)};
  for (const Shipped& cloth : cloths) {
    double missed = 0, all = 0;
    for (const float tilt : {0.0f, 60.0f}) {
      const glm::vec3 view = tilted(kViewAzimuth, tilt);
      for (const glm::vec3& light : lights) {
        const double truth = traced(cloth, view, light);
        all += truth, missed += std::abs(grey(far_field_radiance(cloth.field, light, view)) - truth);
      }
    }
    EXPECT_LT(missed / all, cloth.name == "satin_8" ? 0.4 : cloth.name == "twill_2_2" ? 0.19 : 0.15) << cloth.name;
  }
}

TEST_F(FarFields, TheSkyIsSeenAsFarAsOtherThreadsLeaveIt) {
  Surroundings around;
  around.light_irradiance = glm::vec3(0);
  around.sky = [](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * d.z); };
  for (const Shipped& cloth : cloths) {
    for (const float tilt : {0.0f, 60.0f, 80.0f}) {
      const glm::vec3 view = tilted(kViewAzimuth, tilt);
      const double ours = grey(far_field_sky_radiance(cloth.field, view, 0.5f, {0, 0, 0.5f}));
      EXPECT_NEAR(ours / traced(cloth, view, around), 1, 0.1) << cloth.name << " at " << tilt << " degrees";
    }
  }
}

// Highlights are narrow, so few samples contain them. Threads light each other: the truth without it is brighter at a
// slant, where one sees less of the grooves.
TEST_F(FarFields, AtASlantClothIsAsBrightAsTraced) {
  for (const Shipped& cloth : cloths) {
    for (const float tilt : {0.0f, 60.0f, 80.0f}) {
      const glm::vec3 view = tilted(kViewAzimuth, tilt);
      Surroundings around;
      around.light_towards = tilted(35, 40), around.light_irradiance = glm::vec3(1);
      const glm::vec3 ours = far_field_radiance(cloth.field, around.light_towards, view),
                      truth = traced_colour(cloth, view, around, 16, 2);
      // Beside satin's highlight light falls by more, from node to node, than a line between them tells: a tenth too
      // bright here, in every channel. While green alone was measured, red and blue were too dark, and the mean held
      // 0.06.
      const double holds = cloth.name == "satin_8" && tilt <= 0 ? 0.11 : tilt < 70 ? 0.06 : 0.11;
      EXPECT_NEAR(grey(ours) / grey(truth), 1, holds) << cloth.name << " at " << tilt << " degrees";
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(ours[c] / truth[c], 1, static_cast<float>(holds) + 0.04f)
            << cloth.name << " at " << tilt << " degrees, channel " << c;
    }
  }
}

// From every side: root mean square of the relative error (docs/decisions/highlights-between-nodes.md). Satin's weft is
// seen in slits only, and turns with every degree of the light. Silk and wool have the narrow highlights of their
// fibres (docs/decisions/lobes-follow-from-fibres.md).
TEST_F(FarFields, HoldsInManyDirections) {
  const std::map<std::string, double> limits{
      {"satin_8", 0.21}, {"twill_2_2", 0.068}, {"denim", 0.068}, {"gauze", 0.071}};
  constexpr int kRays = 9;
  for (const Shipped& cloth : cloths) {
    double squares = 0, sum = 0, count = 0;
    for (const float tilt : {0.0f, 30.0f, 60.0f, 80.0f}) {
      for (const float lit_from : {10.0f, 30.0f, 55.0f, 75.0f}) {
        for (const float azimuth : {35.0f, 100.0f, -80.0f}) {
          const glm::vec3 view = tilted(azimuth > 50 ? 10 : kViewAzimuth, tilt);
          Surroundings around;
          around.light_towards = tilted(azimuth, lit_from), around.light_irradiance = glm::vec3(1);
          const double off = grey(far_field_radiance(cloth.field, around.light_towards, view)) /
                                 grey(traced_colour(cloth, view, around, kRays, 2)) -
                             1;
          squares += off * off, sum += off, ++count;
        }
      }
    }
    const double rms = std::sqrt(squares / count);
    RecordProperty(cloth.name, std::to_string(rms));
    const auto limit = limits.find(cloth.name);
    EXPECT_LT(rms, limit != limits.end() ? limit->second : 0.06) << cloth.name;
    EXPECT_NEAR(sum / count, 0, 0.035) << cloth.name;
  }
}

TEST_F(FarFields, OnTheNodesEveryChannelIsThatOfTheTracedThreads) {
  const glm::vec3 light = response_views()[6 * kViewAzimuths + kViewAzimuths / 8];
  for (const Shipped& cloth : cloths) {
    const glm::vec3 view(0, 0, 1), truth = traced_colour(cloth, view, light),
                                   ours = far_field_radiance(cloth.field, light, view);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ours[c] / truth[c], 1, 0.1f) << cloth.name << ", channel " << c;
  }
}

}  // namespace
}  // namespace weftlight::render_data
