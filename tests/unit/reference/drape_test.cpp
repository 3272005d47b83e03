// The draped reference at silhouettes, where interpolated normals face away from an eye that still sees the triangle.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "reference/picture.h"

namespace weftlight::reference {

using base::problem_of;
using cloth::Cloth;
using design::Twist, design::Yarn;
using draft::BitMatrix;

namespace {

constexpr float kPi = 3.14159265f;

/// White ends side by side over black picks: the front is white, the back black.
Cloth white_over_black() {
  Cloth cloth;
  Yarn yarn;
  yarn.twist = Twist::kNone;
  yarn.groove_depth = yarn.hairiness = 0;
  yarn.lobes.specular = yarn.lobes.fuzz = yarn.lobes.transmission = 0;
  cloth.yarns = {yarn};
  for (int i = 0; i < 4; ++i) {
    const float at = 0.25f + 0.5f * static_cast<float>(i);
    cloth.ends.push_back({at, 0.5f, 0.5f, 0.3f, {1, 1, 1}, 0});
    cloth.picks.push_back({at, 0.5f, 0.5f, 0.3f, {0, 0, 0}, 0});
  }
  cloth.width_mm = cloth.depth_mm = 2;
  cloth.up = BitMatrix(4, 4);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e) cloth.up.set(p, e, true);
  return cloth;
}

/// An upright prism of few sides, with the normals of the cylinder that it approximates.
drape::Mesh rounded_prism(int sides, float radius_mm, float height_mm) {
  drape::Mesh mesh;
  for (int i = 0; i <= sides; ++i) {
    // Turned so that a side shows at the silhouette, a large part of whose normals face away.
    const float turn = 2 * kPi * (static_cast<float>(i) + 0.43f) / static_cast<float>(sides);
    const glm::vec3 out(std::sin(turn), 0, std::cos(turn));
    for (const float y : {0.0f, height_mm}) {
      mesh.position_mm.push_back(radius_mm * out + glm::vec3(0, y, 0));
      mesh.normal.push_back(out);
      mesh.tangent.push_back({out.z, 0, -out.x});
      mesh.uv_mm.push_back({turn * radius_mm, y});
    }
    if (i == sides) break;
    const uint32_t at = static_cast<uint32_t>(2 * i);
    for (const uint32_t corner : {0u, 2u, 1u, 1u, 2u, 3u}) mesh.index.push_back(at + corner);
  }
  return mesh;
}

TEST(drape, a_rim_shows_the_face_that_the_eye_sees) {
  const auto built = TubeScene::build(white_over_black(), {});
  const auto draped = MeshScene::build(rounded_prism(12, 60, 100));
  ASSERT_TRUE(built && draped) << problem_of(built) << problem_of(draped);
  const std::unique_ptr<TubeScene>& tubes = *built;
  const std::unique_ptr<MeshScene>& mesh = *draped;
  DrapePicture picture;
  picture.width = 1240, picture.height = 2, picture.spp = 8;
  picture.eye = {0, 50, 4000};
  const glm::mat4 view = glm::lookAt(picture.eye, glm::vec3(0, 50, 0), glm::vec3(0, 1, 0));
  picture.clip_to_world = glm::inverse(glm::perspective(2 * std::atan(1.0f / 4000), 62.0f, 100.0f, 8000.0f) * view);
  picture.light_irradiance = glm::vec3(0);
  picture.sky = [](glm::vec3) { return glm::vec3(1); };
  const TracedImage image = trace_drape(*tubes, *mesh, nullptr, picture, {});
  float darkest = 1, lit = 0;
  for (const glm::vec4& p : image.pixels) {
    if (p.a < 0.999f) continue;
    darkest = std::min(darkest, p.r), ++lit;
  }
  EXPECT_GT(lit, 2000);
  EXPECT_GT(darkest, 0.05f) << "the black back, or the inside of a thread, shows at the rim";
}

}  // namespace
}  // namespace weftlight::reference
