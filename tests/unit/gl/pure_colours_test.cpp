// A channel of a thread's colour at exactly 0 is a dark colour like any other, in the picture of every method: it goes
// evenly to it, and is that of the threads traced as bodies.

#include "../render_data/pure_colours.h"

#include "design/methods.h"
#include "draft/drawdown.h"
#include "gate.h"
#include "reference/picture.h"

namespace weftlight::gl {

using base::problem_of;
using cloth::Period, cloth::lay_out;
using design::Design, design::Method, design::MethodFacts, design::kMethods, design::method_name;
using draft::BitMatrix, draft::Face, draft::Rgb, draft::drawdown;
using files::Image;
using reference::FlatPicture, reference::TubeScene, reference::trace_flat;
using render_data::ColourPair, render_data::Effort, render_data::FlatPatch, render_data::Stages,
    render_data::kPurePairs, render_data::kPureSpacing, render_data::metal_yarn, render_data::of_255,
    render_data::plain_in, render_data::striped_in;

namespace {

struct Shot {
  const char* name;
  glm::vec3 view, light;
  float sky = 0;  // beside no other light
};

const std::array<Shot, 3> kShots{{{"lit from before", towards(0, 1.57f), towards(0.6f, 0.87f)},
                                  {"lit from behind", towards(0, 1.57f), -towards(0.6f, 0.87f)},
                                  {"sky", towards(-1.3f, 0.52f), towards(0.6f, 0.87f), 1}}};

class PureColours : public PictureTest {
 protected:
  /// kQuick: the maps of a moving picture, a quarter as wide, and those that vrst03 alone asks for.
  void show(Design design, Effort effort) {
    if (effort == Effort::kQuick) design.look.method = Method::kVrst03;
    Stages stages;
    stages.update(std::make_shared<const Design>(design), effort);
    renderer->upload(stages.packed());
  }
  /// Means of the channels.
  glm::vec3 mean_of(Method method, const Shot& shot, Face face, float yarns, int pixels) {
    FlatPatch p;
    p.width = p.height = pixels, p.face = face, p.samples = 13;
    p.step_x_mm = {yarns * kPureSpacing, 0}, p.step_y_mm = {0, yarns * kPureSpacing};
    p.view = shot.view, p.light_towards = shot.light, p.sky = shot.sky;
    if (shot.sky > 0) p.light_irradiance = glm::vec3(0);
    look.method = method;
    renderer->draw_patch(p, look);
    const Image image = renderer->read_patch();
    return {static_cast<float>(mean(image, 0)), static_cast<float>(mean(image, 1)), static_cast<float>(mean(image, 2))};
  }

  struct Picture {
    std::string what;
    glm::vec3 mean;
  };
  /// By every method, on both faces, in all lights, from near and far.
  std::vector<Picture> pictures(const Design& design) {
    show(design, Effort::kQuick);
    std::vector<Picture> out;
    for (const MethodFacts& m : kMethods) {
      if (!m.drawn) continue;
      for (const Face face : {Face::kFront, Face::kBack})
        for (const Shot& shot : kShots)
          for (const float yarns : {0.0625f, 0.25f, 1.5f, 8.0f})
            out.push_back({std::string(m.name) + (face == Face::kFront ? ", front, " : ", back, ") + shot.name + ", " +
                               text(yarns) + " yarns a pixel",
                           mean_of(m.method, shot, face, yarns, 4)});
    }
    return out;
  }
  /// make: a design by so many of 255. The last step changes no more than those before it did together, or than a
  /// hundredth of the brightest channel.
  template <class Make>
  void expect_even(const Make& make, const std::string& what) {
    const auto eight = pictures(make(8)), one = pictures(make(1)), none = pictures(make(0));
    for (size_t i = 0; i < none.size(); ++i) {
      const glm::vec3 before = eight[i].mean;
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(none[i].mean[c], one[i].mean[c],
                    std::abs(before[c] - one[i].mean[c]) + 0.01f * std::max({before.r, before.g, before.b, 0.01f}))
            << what << ": " << none[i].what << ", channel " << c;
    }
  }
};

TEST_F(PureColours, EveryMethodGoesEvenlyTo0WithAChannel) {
  const Rgb white = of_255(255, 255, 255);
  expect_even([&](int v) { return striped_in(of_255(v, v, v), white); }, "black and white stripes");
  expect_even([](int v) { return plain_in(of_255(255, v, v), of_255(v, v, 255), metal_yarn()); }, "red and blue metal");
}

// Near, the threads themselves; from afar what is measured on them.
TEST_F(PureColours, PairsAreDrawnAsTheTracedThreads) {
  for (const ColourPair& pair : {kPurePairs[0], kPurePairs[1], kPurePairs[3]}) {
    const Design design = plain_in(pair.warp, pair.weft);
    show(design, Effort::kFull);
    const BitMatrix cells = drawdown(design.draft);
    const auto built = TubeScene::build(lay_out(design, cells, Face::kFront, Period::kRepeat), {});
    ASSERT_TRUE(built) << problem_of(built);
    const std::unique_ptr<TubeScene>& tubes = *built;
    for (const Shot& shot : {kShots[0], kShots[2]}) {
      FlatPicture p;
      p.width = p.height = 16, p.spp = 64;
      p.step_x_mm = {0.25f * kPureSpacing, 0}, p.step_y_mm = {0, 0.25f * kPureSpacing};
      p.view = shot.view, p.around.light_towards = shot.light;
      p.around.light_irradiance = shot.sky > 0 ? glm::vec3(0) : FlatPatch().light_irradiance;
      if (shot.sky > 0) p.around.sky = [](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * d.z); };
      glm::vec3 truth(0);
      for (const glm::vec4& c : trace_flat(*tubes, p, {}).pixels) truth += glm::vec3(c) / 256.0f;
      for (const auto& [method, yarns] :
           {std::pair{Method::kYarn, 0.25f}, std::pair{Method::kAuto, 0.25f}, std::pair{Method::kRepeat, 1.0f},
            std::pair{Method::kAuto, 1.0f}, std::pair{Method::kCloth, 2.0f}}) {
        const glm::vec3 ours = mean_of(method, shot, Face::kFront, yarns, static_cast<int>(std::lround(4 / yarns)));
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(ours[c], truth[c], 0.1f * truth[c] + 0.005f * std::max({truth.r, truth.g, truth.b}))
              << pair.name << ", " << shot.name << ", " << method_name(method) << ", " << yarns
              << " yarns a pixel, channel " << c;
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::gl
