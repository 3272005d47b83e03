#pragma once
// Small designs and meshes for the tests of the picture, and a context that skips where there is no graphics.

#include <gtest/gtest.h>

#include <cmath>

#include "preview/context.h"
#include "preview/pipeline.h"
#include "preview/renderer.h"
#include "preview/stages.h"

namespace weftlight {

/// Ends x picks, one shaft an end of the repeat, the warp up where (pick + end) % repeat < up.
inline Design twill(int repeat, int up, Rgb warp, Rgb weft) {
  Design design;
  const int threads = repeat * 2;
  design.draft = blank_draft(threads, threads, repeat, repeat);
  Draft& d = design.draft;
  d.drive = Drive::kLiftplan;
  d.palette = {warp, weft};
  for (int i = 0; i < threads; ++i) {
    d.threading.set(i, i % repeat, true);
    d.warp.color[static_cast<size_t>(i)] = 0;
    d.weft.color[static_cast<size_t>(i)] = 1;
    for (int s = 0; s < repeat; ++s) d.liftplan.set(i, s, (i + s) % repeat < up);
  }
  design.yarns[0].twist = Twist::kNone;
  design.scene.mesh.clear();  // the tests bring their own
  return design;
}

/// A square that faces +z, its uv starting at `uv0`.
inline Mesh square(float side_mm, Vec2 uv0 = {0, 0}) {
  Mesh mesh;
  constexpr int kSteps = 8;
  for (int y = 0; y <= kSteps; ++y) {
    for (int x = 0; x <= kSteps; ++x) {
      const float u = side_mm * static_cast<float>(x) / kSteps, v = side_mm * static_cast<float>(y) / kSteps;
      mesh.position_mm.push_back({u - side_mm / 2, v, 0});
      mesh.normal.push_back({0, 0, 1});
      mesh.tangent.push_back({1, 0, 0});
      mesh.uv_mm.push_back({u + uv0[0], v + uv0[1]});
    }
  }
  for (int y = 0; y < kSteps; ++y) {
    for (int x = 0; x < kSteps; ++x) {
      const uint32_t a = static_cast<uint32_t>(y * (kSteps + 1) + x), b = a + kSteps + 1;
      mesh.index.insert(mesh.index.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

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
  static void SetUpTestSuite() {
    context = HeadlessContext::create(error);
    if (context) renderer = Renderer::create(error);
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
    frame.width = frame.height = 128;
    frame.ground = false;
  }
  void upload(const Design& design, const Mesh& mesh) {
    Stages stages;
    stages.update(std::make_shared<const Design>(design));
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

}  // namespace weftlight
