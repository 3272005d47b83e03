// Pinholes of a cloth that covers nearly all: they are seen where its threads are drawn one by one.

#include <algorithm>

#include "picture.h"

namespace weftlight::gl {

using draft::Rgb;
using render_data::prepare_mesh, render_data::square, render_data::twill;

namespace {

/// With pinholes a tenth of a thread wide.
Design pale_cloth() {
  constexpr Rgb kPale{0.9f, 0.9f, 0.9f};
  Design cloth = twill(2, 1, kPale, kPale);
  for (draft::Threads* threads : {&cloth.draft.warp, &cloth.draft.weft}) {
    std::ranges::fill(threads->thickness_mm, 0.4f);
    std::ranges::fill(threads->spacing_mm, 0.49f);
  }
  return cloth;
}

/// A square, and on it a small one of the same cloth, so many times as large.
Mesh with_enlarged_square(float times, float side_mm) {
  Mesh mesh = square(100);
  const auto first = static_cast<uint32_t>(mesh.position_mm.size());
  for (const float y : {0.0f, side_mm}) {
    for (const float x : {0.0f, side_mm}) {
      mesh.position_mm.push_back({x - side_mm / 2, 50 + y - side_mm / 2, 1});
      mesh.normal.push_back({0, 0, 1});
      mesh.tangent.push_back({1, 0, 0});
      mesh.uv_mm.push_back({x / times, y / times});
    }
  }
  mesh.index.insert(mesh.index.end(), {first, first + 1, first + 3, first, first + 3, first + 2});
  return mesh;
}

float least_alpha(const Image& image) {
  float least = 1;
  for (size_t i = 3; i < image.texels.size(); i += 4) least = std::min(least, image.texels[i]);
  return least;
}

// They were black where so little of the picture was so near that its background was not drawn first.
TEST_F(PictureTest, PinholesShowTheBackgroundHoweverLittleIsNear) {
  upload(pale_cloth(), square(100));
  frame.transparent = true, frame.yarns_per_pixel = 0.05f;
  ASSERT_LT(least_alpha(draw()), 0.1f) << "the cloth has pinholes";
  look.method = Method::kCell;
  ASSERT_EQ(least_alpha(draw()), 1.0f) << "which are too small for the maps";

  frame.transparent = false, frame.yarns_per_pixel = 3;
  renderer->set_mesh(prepare_mesh(with_enlarged_square(40, 7)));
  look.method = Method::kAuto;
  renderer->draw(scene, look, frame);
  const float near = renderer->measure().method_weights[0];
  ASSERT_GT(near, 0.002f);
  ASSERT_LT(near, 0.01f);
  EXPECT_GT(least_alpha(renderer->read_back(true)), 0.999f);
}

}  // namespace
}  // namespace weftlight::gl
