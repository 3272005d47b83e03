#pragma once
// Small designs and meshes for the tests of the renderer, and a context that skips without graphics.

#include <gtest/gtest.h>

#include <cmath>

#include "../render_data/designs.h"
#include "gl/open_headless.h"
#include "gl/pipeline.h"
#include "gl/renderer.h"
#include "render_data/stages.h"

namespace weftlight::gl {

using base::problem_of;
using design::Design, design::Look, design::Method, design::Scene;
using drape::Mesh;
using files::Image;
using render_data::Effort, render_data::Stages;

struct Mean {
  double r = 0, g = 0, b = 0;
  double sum() const { return r + g + b; }
};

/// Mean of the middle of a picture, half its width and height.
inline Mean middle(const Image& image) {
  Mean m;
  int count = 0;
  for (int y = image.height / 4; y < image.height * 3 / 4; ++y) {
    for (int x = image.width / 4; x < image.width * 3 / 4; ++x, ++count) {
      const float* p = image.texels.data() + (static_cast<size_t>(y) * image.width + x) * 4;
      m.r += static_cast<double>(p[0]), m.g += static_cast<double>(p[1]), m.b += static_cast<double>(p[2]);
    }
  }
  return {m.r / count, m.g / count, m.b / count};
}

/// A renderer with a design's maps and a mesh; one context for all tests of a suite.
class PictureTest : public testing::Test {
 protected:
  static constexpr int kSide = 64;  // pixels

  static void SetUpTestSuite() {
    auto opened = open_headless();
    error = problem_of(opened);
    if (!opened) return;
    context = std::move(*opened);
    auto made = Renderer::create();
    error = problem_of(made);
    if (made) renderer = std::move(*made);
  }
  static void TearDownTestSuite() {
    renderer.reset();
    context.reset();
  }
  void SetUp() override {
    if (!context) GTEST_SKIP() << "no graphics: " << error;
    ASSERT_TRUE(renderer) << error;
    scene.view_azimuth = scene.view_elevation = 0;
    scene.light_azimuth = -30, scene.light_elevation = 40;
    look.method = Method::kYarn;
    look.automatic_exposure = false;
    frame.width = frame.height = kSide;
    frame.ground = false;
  }
  /// With the maps of a moving picture, a quarter as wide.
  void upload(const Design& design, const Mesh& mesh) {
    Stages stages;
    stages.update(std::make_shared<const Design>(design), Effort::kQuick);
    renderer->upload(stages.packed());
    renderer->set_mesh(mesh);
  }
  Image draw(bool linear = true) {
    renderer->draw(scene, look, frame);
    return renderer->read_back(linear);
  }

  static inline std::unique_ptr<HeadlessContext> context;
  static inline std::unique_ptr<Renderer> renderer;
  static inline std::string error;
  Scene scene;
  Look look;
  Frame frame;
};

}  // namespace weftlight::gl
