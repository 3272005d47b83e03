// Methods `yarn`, `repeat` and `cloth` against the threads ray traced as bodies, on one repeat of a twill.

#include <map>

#include "base/resources.h"
#include "draft/drawdown.h"
#include "gate.h"
#include "reference/picture.h"
#include "render_data/face_cloth.h"
#include "wif/wif.h"

namespace weftlight::gl {

using base::problem_of;
using cloth::lay_out;
using design::Method, design::Yarn, design::method_name;
using draft::BitMatrix, draft::Face, draft::drawdown;
using files::Image;
using reference::Colours, reference::FlatPicture, reference::Surroundings, reference::TracedImage, reference::TubeScene,
    reference::trace_flat;
using render_data::FlatPatch, render_data::choose_period;

namespace {

struct Pair {
  glm::vec3 light, view;
};

class Truth : public Gate {
 protected:
  void SetUp() override {
    Gate::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    lay_both(1);
  }
  /// Lays out the design as lay() does, drawn and traced.
  void lay_both(float fill) {
    lay(fill);
    trace_threads();
  }
  void trace_threads() {
    const BitMatrix cells = drawdown(design.draft);
    auto built = TubeScene::build(lay_out(design, cells, Face::kFront, choose_period(design, cells)), {});
    ASSERT_TRUE(built) << problem_of(built);
    tubes = std::move(*built);
  }
  /// As patch(), traced.
  Image traced(float yarns, int pixels, int rays_a_pixel, const Pair& pair, glm::vec2 corner_mm = {0, 0}) {
    Surroundings around;
    around.light_towards = pair.light;
    around.light_irradiance = FlatPatch().light_irradiance;
    return traced(yarns, pixels, rays_a_pixel, pair.view, around, corner_mm);
  }
  Image traced(float yarns, int pixels, int rays_a_pixel, const glm::vec3& view, const Surroundings& around,
               glm::vec2 corner_mm = {0, 0}) {
    FlatPicture p;
    p.fibre_detail = true;
    p.width = p.height = pixels, p.spp = rays_a_pixel;
    p.corner_mm = corner_mm;
    p.step_x_mm = {yarns * kSpacing, 0}, p.step_y_mm = {0, yarns * kSpacing};
    p.view = view, p.around = around;
    p.bounces = 3, p.colours = Colours::kOfTheCloth;
    const TracedImage image = trace_flat(*tubes, p, {});
    Image out;
    out.width = out.height = pixels;
    for (const glm::vec4& c : image.pixels) out.texels.insert(out.texels.end(), {c.r, c.g, c.b, 1});
    return out;
  }
  Image drawn(Method method, float yarns, int pixels, const Pair& pair) {
    return patch(method, yarns, pixels, {0, 0}, pair.light, pair.view);
  }

  std::unique_ptr<TubeScene> tubes;
};

TEST_F(Truth, MeanBrightnessIsThatOfTheTracedThreads) {
  const Pair pairs[] = {{towards(0.6f, 0.87f), towards(0, 1.57f)},  {towards(2.1f, 0.6f), towards(0.2f, 1.0f)},
                        {towards(4.4f, 0.5f), towards(1.7f, 0.6f)}, {towards(0.6f, 0.87f), towards(-1.3f, 0.3f)},
                        {towards(3.6f, 1.3f), towards(5, 0.8f)},    {towards(1.9f, 0.6f), towards(-1.3f, 0.25f)}};
  double squares = 0;
  for (const Pair& pair : pairs) {
    const double truth = mean(traced(2, 4, 1500, pair));
    for (const Method method : {Method::kRepeat, Method::kCloth}) {
      const double ratio = mean(drawn(method, 2, 4, pair)) / truth;
      // Most where light comes from the viewer's side: a height map has no undersides of threads.
      EXPECT_NEAR(ratio, 1, 0.12) << method_name(method) << " light " << pair.light.x << ' ' << pair.light.y << " view "
                                  << pair.view.x << ' ' << pair.view.y;
      squares += (ratio - 1) * (ratio - 1) / 12;
    }
  }
  EXPECT_LT(std::sqrt(squares), 0.07);
}

TEST_F(Truth, TheSkyIsThatOfTheTracedThreads) {
  for (const glm::vec3& view : {towards(0, 1.57f), towards(-1.3f, 0.52f)}) {
    std::map<float, double> truths;  // by yarns
    for (const auto& [method, yarns] : {std::pair{Method::kYarn, 0.125f}, std::pair{Method::kYarn, 2.0f},
                                        std::pair{Method::kRepeat, 2.0f}, std::pair{Method::kCloth, 2.0f}}) {
      const int pixels = static_cast<int>(std::max(4.0f, 4 / yarns));
      FlatPatch p;
      p.width = p.height = pixels, p.samples = kSamples;
      p.step_x_mm = {yarns * kSpacing, 0}, p.step_y_mm = {0, yarns * kSpacing};
      p.view = view, p.light_irradiance = glm::vec3(0), p.sky = 1;
      look.method = method;
      renderer->draw_patch(p, look);
      Surroundings around;
      around.light_irradiance = glm::vec3(0);
      around.sky = [](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * d.z); };
      if (!truths.contains(yarns)) truths[yarns] = mean(traced(yarns, pixels, 60000 / (pixels * pixels), view, around));
      EXPECT_NEAR(mean(renderer->read_patch()) / truths[yarns], 1, 0.1)
          << method_name(method) << ' ' << yarns << " view " << view.z;
    }
  }
}

// Lamps are low over the folds of a drape, and threads occlude low light.
TEST_F(Truth, NearTheThreadsASkyThatIsBrightAtOneSideIsThatOfTheTracedThreads) {
  for (const glm::vec3& view : {towards(0, 1.57f), towards(-1.3f, 0.52f), towards(1.9f, 0.52f)}) {
    const glm::vec3 bright = towards(-1.3f, 0.1f);
    FlatPatch p;
    p.width = p.height = 4, p.samples = kSamples;
    p.step_x_mm = {2 * kSpacing, 0}, p.step_y_mm = {0, 2 * kSpacing};
    p.view = view, p.light_irradiance = glm::vec3(0), p.sky = 1, p.sky_towards = bright;
    look.method = Method::kYarn;
    renderer->draw_patch(p, look);
    Surroundings around;
    around.light_irradiance = glm::vec3(0);
    around.sky = [bright](glm::vec3 d) { return glm::vec3(0.5f + 0.5f * glm::dot(d, bright)); };
    EXPECT_NEAR(mean(renderer->read_patch()) / mean(traced(2, 4, 1500, view, around)), 1, 0.08)
        << view.x << ' ' << view.z;
  }
}

TEST_F(Truth, LightFromBehindIsThatOfTheTracedThreads) {
  for (const glm::vec3& view : {towards(0, 1.57f), towards(-1.3f, 0.52f)}) {
    const glm::vec3 before = towards(0.6f, 0.87f), behind(before.x, before.y, -before.z);
    const double truth = mean(traced(2, 4, 1500, {behind, view})), bright = mean(traced(2, 4, 1500, {before, view}));
    for (const Method method : {Method::kYarn, Method::kRepeat, Method::kCloth, Method::kCell}) {
      EXPECT_NEAR(mean(drawn(method, 2, 4, {behind, view})), truth, 0.12 * truth + 0.002 * bright)
          << method_name(method) << " view " << view.z;
    }
  }
}

// Fibres that stand over the face lie in the shadow of the cloth.
TEST_F(Truth, NearTheThreadsLightFromBehindIsThatOfTheTracedThreads) {
  for (const glm::vec3& view : {towards(0, 1.57f), towards(-1.3f, 0.52f)}) {
    for (const auto& [yarns, holds] : {std::pair{0.0625f, 0.3}, {0.25f, 0.45}}) {
      const int pixels = static_cast<int>(4 / yarns);
      const Pair behind{towards(0.6f, -0.87f), view};
      const Image truth = traced(yarns, pixels, 12800 / pixels, behind);
      const Image ours = drawn(Method::kYarn, yarns, pixels, behind);
      EXPECT_LT(relative_rms(truth, ours), holds) << yarns << " view " << view.z;
      EXPECT_NEAR(mean(ours) / mean(truth), 1, 0.15) << yarns << " view " << view.z;
    }
  }
}

// Where threads touch, a point beside the side of one lies in its neighbour: a shadow ray from there found no light.
// Traced, so many threads have few facets, and the slit that the light comes through is wider.
TEST_F(Truth, LightFromBehindFallsThroughASlitBetweenThreadsThatTouch) {
  const wif::WifRead read = wif::read_wif(base::read_file(base::presets_dir() + "/cloths/denim.wif").value_or(""));
  ASSERT_TRUE(read.file);
  design = read.file->design;
  upload_maps(design);
  trace_threads();
  const float spacing = full_updates.back().packed.mean_spacing_mm;
  const glm::vec2 corner = glm::vec2(1.3f, 2.08f) * spacing;
  const Pair behind{towards(0.6f, -0.87f), towards(0, 1.57f)};
  const float yarns = 0.012f * spacing / kSpacing;
  const double traced_light = mean(traced(yarns, 48, 64, behind, corner));
  const double ratio = mean(patch(Method::kYarn, yarns, 48, corner, behind.light, behind.view)) / traced_light;
  EXPECT_GT(ratio, 0.55);
  EXPECT_LT(ratio, 1.1);
}

TEST_F(Truth, YarnDrawsTheTracedThreads) {
  const Pair pairs[] = {{towards(0.6f, 0.87f), towards(0, 1.57f)},
                        {towards(2.1f, 0.6f), towards(0.2f, 0.6f)},
                        {towards(-1.9f, 0.5f), towards(1.7f, 0.2f)},
                        {towards(0.6f, 0.87f), towards(2.2f, 0.17f)}};
  for (const Pair& pair : pairs) {
    for (const float yarns : {0.125f, 0.5f}) {
      const int pixels = static_cast<int>(4 / yarns);
      const Image truth = traced(yarns, pixels, 8000 / pixels, pair);
      const Image ours = drawn(Method::kYarn, yarns, pixels, pair);
      const double off = relative_rms(truth, ours);
      figure("error at " + text(yarns) + " yarns a pixel, an averaged normal",
             relative_rms(truth, drawn(Method::kEngine, yarns, pixels, pair)), off);
      EXPECT_LT(off, 0.12) << yarns << " view " << pair.view.z << " light " << pair.light.z;
      // Of light between threads less reaches those that are seen at a slant.
      EXPECT_NEAR(mean(ours) / mean(truth), 1, 0.06) << yarns << " view " << pair.view.z << " light " << pair.light.z;
    }
  }
}

TEST_F(Truth, YarnGivesEachThreadItsOwnLobes) {
  Yarn metal = design.yarns.front();
  metal.lobes.metallic = true;
  metal.lobes.along_width = metal.lobes.across_width = 0.2f;
  design.yarns.push_back(metal);
  design.draft.warp.yarn.assign(static_cast<size_t>(design.draft.ends()), 0);
  for (size_t i = 0; i < design.draft.warp.yarn.size(); i += 2)
    design.draft.warp.yarn[i] = static_cast<int>(design.yarns.size()) - 1;
  lay_both(1);
  const Pair straight{towards(0.1f, 1.3f), towards(0, 1.57f)};
  const Image truth = traced(0.125f, 32, 200, straight);
  const double ours = relative_rms(truth, drawn(Method::kYarn, 0.125f, 32, straight));
  const double mixed = relative_rms(truth, drawn(Method::kCell, 0.125f, 32, straight));
  figure("error with two yarns in the warp, mean lobes of the system", mixed, ours);
  EXPECT_LT(ours, 0.12);
  EXPECT_GT(mixed, 2 * ours);
}

TEST_F(Truth, RepeatShowsThreadsWhereTheyAre) {
  const Pair straight{towards(0.6f, 0.87f), towards(0, 1.57f)};
  // Relative error at half a yarn, one and two yarns a pixel: one radiance for the whole cloth is far worse.
  for (const auto& [yarns, holds] : {std::pair{0.5f, 0.15}, {1.0f, 0.12}, {2.0f, 0.07}}) {
    const int pixels = static_cast<int>(8 / yarns);
    const Image truth = traced(yarns, pixels, 20000 / pixels, straight);
    const double ours = relative_rms(truth, drawn(Method::kRepeat, yarns, pixels, straight));
    figure("error at " + text(yarns) + " yarns a pixel, one radiance for the whole cloth",
           relative_rms(truth, drawn(Method::kCloth, yarns, pixels, straight)), ours);
    EXPECT_LT(ours, holds) << yarns;
  }
}

TEST_F(Truth, RepeatIsWhatItsOwnFinerPictureAverages) {
  const Pair straight{towards(0.6f, 0.87f), towards(0, 1.57f)};
  constexpr int kFiner = 8;
  for (const auto& [yarns, holds] : {std::pair{1.3f, 0.12}, {2.6f, 0.09}, {5.2f, 0.05}}) {
    constexpr int pixels = 8;
    const Image fine = drawn(Method::kRepeat, yarns / kFiner, pixels * kFiner, straight);
    Image average = drawn(Method::kRepeat, yarns, pixels, straight);
    const Image coarse = average;
    for (int y = 0; y < pixels; ++y) {
      for (int x = 0; x < pixels; ++x) {
        for (size_t c = 0; c < 3; ++c) {
          float sum = 0;
          for (int k = 0; k < kFiner * kFiner; ++k) {
            const int fx = x * kFiner + k % kFiner, fy = y * kFiner + k / kFiner;
            sum += fine.texels[4 * static_cast<size_t>(fy * fine.width + fx) + c];
          }
          average.texels[4 * static_cast<size_t>(y * pixels + x) + c] = sum / (kFiner * kFiner);
        }
      }
    }
    const double off = relative_rms(average, coarse);
    EXPECT_LT(off, holds) << yarns;
  }
}

}  // namespace
}  // namespace weftlight::gl
