// The draped reference at silhouettes, where interpolated normals face away from an eye that still sees the triangle.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "reference/picture.h"

namespace weftlight::reference {

using base::problem_of;
using cloth::Cloth;
using design::Twist, design::Yarn;
using draft::BitMatrix, draft::System;

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

/// The prism from 4 m in front of its axis, 2 mm high, under an even sky.
DrapePicture front_of_prism(int width) {
  DrapePicture picture;
  picture.width = width, picture.height = 2, picture.spp = 8;
  picture.eye = {0, 50, 4000};
  const glm::mat4 view = glm::lookAt(picture.eye, glm::vec3(0, 50, 0), glm::vec3(0, 1, 0));
  picture.clip_to_world = glm::inverse(glm::perspective(2 * std::atan(1.0f / 4000), 62.0f, 100.0f, 8000.0f) * view);
  picture.light_irradiance = glm::vec3(0);
  picture.sky = [](glm::vec3) { return glm::vec3(1); };
  return picture;
}

/// White ends over black picks on a prism of 60 mm around the world's upright axis.
class Drape : public ::testing::Test {
 protected:
  void SetUp() override {
    auto built = TubeScene::build(white_over_black(), {});
    auto draped = MeshScene::build(rounded_prism(12, 60, 100));
    ASSERT_TRUE(built && draped) << problem_of(built) << problem_of(draped);
    tubes_ = std::move(*built), mesh_ = std::move(*draped);
  }
  TracedImage traced(const DrapePicture& picture) const { return trace_drape(*tubes_, *mesh_, nullptr, picture, {}); }

 private:
  std::unique_ptr<TubeScene> tubes_;
  std::unique_ptr<MeshScene> mesh_;
};

TEST_F(Drape, a_rim_shows_the_face_that_the_eye_sees) {
  const TracedImage image = traced(front_of_prism(1240));
  float darkest = 1, lit = 0;
  for (const glm::vec4& p : image.pixels) {
    if (p.a < 0.999f) continue;
    darkest = std::min(darkest, p.r), ++lit;
  }
  EXPECT_GT(lit, 2000);
  EXPECT_GT(darkest, 0.05f) << "the black back, or the inside of a thread, shows at the rim";
}

TEST_F(Drape, layers_say_what_a_pixel_shows) {
  DrapePicture picture = front_of_prism(124);
  picture.bounces = 2, picture.layers = true, picture.spp = 32;
  const TracedImage image = traced(picture);
  ASSERT_EQ(image.layers.size(), image.pixels.size());
  EXPECT_TRUE(traced(front_of_prism(124)).layers.empty()) << "not asked for";
  std::array<float, 2> outwards{};  // the mean normal of the left half and of the right, in x
  for (size_t x = 0; x < 124; ++x) {
    const PixelLayers& l = image.layers[x];
    const glm::vec4& light = image.pixels[x];
    const float at = static_cast<float>(x) + 0.5f - 62;  // mm from the axis
    if (std::abs(at) > 65) {
      EXPECT_EQ(l.thread, -1);
    }
    if (std::abs(at) > 40) continue;
    EXPECT_GT(light.a, 0.99f);
    EXPECT_NEAR(l.depth_mm, 4000 - std::sqrt(60 * 60 - at * at), 3) << at;  // a prism of 12 sides
    outwards[at > 0 ? 1 : 0] += l.normal.x / 40;
    EXPECT_GT(l.normal.z, 0.6f);
    EXPECT_EQ(l.system, System::kWarp);
    EXPECT_TRUE(l.thread >= 0 && l.thread < 4) << l.thread;
    EXPECT_GT(l.albedo.g, 0.95f) << "white";
    EXPECT_GT(l.direct.g, 0.5f * light.g);
    EXPECT_LE(l.direct.g, light.g * 1.0001f);
    EXPECT_NEAR(std::remainder(l.uv_mm.x - 60 * std::asin(at / 60), 2 * kPi * 60), 0, 2.5f) << at;
  }
  // Of round threads at a slant the side towards the eye is seen.
  EXPECT_TRUE(outwards[0] < -0.1f && outwards[0] > -0.35f) << outwards[0];
  EXPECT_TRUE(outwards[1] > 0.1f && outwards[1] < 0.35f) << outwards[1];
}

TEST_F(Drape, another_seed_is_other_noise_around_the_same_mean) {
  DrapePicture picture = front_of_prism(124);
  picture.spp = 32;
  const TracedImage image = traced(picture), again = traced(picture);
  picture.seed = 1;
  const TracedImage other = traced(picture);
  EXPECT_EQ(image.pixels, again.pixels);
  double mean = 0, other_mean = 0;
  int differ = 0;
  for (size_t i = 0; i < image.pixels.size(); ++i) {
    mean += static_cast<double>(image.pixels[i].g), other_mean += static_cast<double>(other.pixels[i].g);
    differ += image.pixels[i] != other.pixels[i] ? 1 : 0;
  }
  EXPECT_GT(differ, 150);
  EXPECT_NEAR(other_mean / mean, 1, 0.03);
}

}  // namespace
}  // namespace weftlight::reference
