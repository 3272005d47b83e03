// Triangles narrower than a pixel.

#include <algorithm>
#include <cmath>

#include "picture.h"

namespace weftlight::gl {

using render_data::twill;

namespace {

constexpr draft::Rgb kWhite{0.9f, 0.9f, 0.9f};

/// A standing square with the edge of a second layer across it: a strip narrower than a pixel, which faces from ahead
/// to downwards.
Mesh hemmed_square() {
  constexpr float kStrip_mm = 0.4f;
  Mesh mesh;
  for (const auto& [y, down] : std::vector<std::pair<float, float>>{
           {0, 0}, {50, 0}, {50, 1}, {50 + kStrip_mm, 0}, {50 + kStrip_mm, 0}, {100, 0}}) {
    for (const float x : {-50.0f, 50.0f}) {
      mesh.position_mm.push_back({x, y + (y > 0 && y < 100 ? 0.05f * x : 0), 0});
      mesh.normal.push_back({0, -std::sin(down), std::cos(down)});
      mesh.tangent.push_back({1, 0, 0});
      mesh.uv_mm.push_back({x, y});
    }
  }
  for (const uint32_t k : {0u, 4u, 8u}) mesh.index.insert(mesh.index.end(), {k, k + 1, k + 3, k, k + 3, k + 2});
  return mesh;
}

// Where a pixel's centre lay beside such a strip, interpolation turned its normal upwards: white specks at a yoke's
// edge.
TEST_F(PictureTest, AStripNarrowerThanAPixelHasNoSpecks) {
  upload(twill(4, 1, kWhite, kWhite), hemmed_square());
  look.method = Method::kFlat;
  scene.sky_strength = 0;
  scene.light_azimuth = 0, scene.light_elevation = 90;
  frame.transparent = true;
  const Image image = draw();
  float brightest = 0;
  for (size_t i = 0; i < image.texels.size(); i += 4) brightest = std::max(brightest, image.texels[i]);
  EXPECT_LT(brightest, 0.01) << "no side of the cloth faces the light";
}

}  // namespace
}  // namespace weftlight::gl
