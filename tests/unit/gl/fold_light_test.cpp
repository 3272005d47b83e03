// The light on folds of a mesh.

#include "../folded_cloth.h"
#include "../relative_rms.h"
#include "picture.h"

namespace weftlight::gl {

using render_data::twill;

namespace {

class FoldLight : public PictureTest {};

// Across a fold, diagonals of a mesh's cells gave its shade the teeth of a saw.
TEST_F(FoldLight, IsThatOfAFinerMesh) {
  constexpr int kCells = 16, kFiner = 8;
  look.method = Method::kFlat;
  scene.light_azimuth = scene.light_elevation = 45;
  frame.width = frame.height = 256;
  frame.transparent = true;
  for (const float slope : {1.0f, -1.0f}) {
    upload(twill(4, 2, {0.9f, 0.9f, 0.9f}, {0.9f, 0.9f, 0.9f}), folded_cloth(slope, kFiner * kCells));
    const Image fine = draw();
    renderer->set_mesh(folded_cloth(slope, kCells));
    EXPECT_LT(relative_rms(fine, draw()), 0.16) << slope;  // 0.21 with diagonals across, 0.11 along
  }
}

}  // namespace
}  // namespace weftlight::gl
