// The reference against closed forms: a cylinder, a plane of parallel cylinders, a white furnace.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../centre_height.h"
#include "reference/picture.h"

namespace weftlight::reference {

using base::problem_of;
using cloth::Cloth, cloth::centre_height_mm;
using design::Lobes, design::Twist, design::Yarn;
using draft::BitMatrix, draft::System;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Ends of 1 mm every 2 mm; the weft has no thickness, so there is no crimp and nothing else is visible.
Cloth parallel_cylinders(int count) {
  Cloth cloth;
  Yarn yarn;
  yarn.twist = Twist::kNone;
  yarn.groove_depth = yarn.hairiness = 0;
  yarn.lobes = Lobes{};
  yarn.lobes.specular = yarn.lobes.fuzz = yarn.lobes.transmission = 0;
  yarn.lobes.body = 1;
  cloth.yarns = {yarn};
  for (int i = 0; i < count; ++i) cloth.ends.push_back({1 + 2 * static_cast<float>(i), 2, 1, 1, {1, 1, 1}, 0});
  cloth.picks.push_back({1, 2, 0, 0, {1, 1, 1}, 0});
  cloth.width_mm = 2 * static_cast<float>(count);
  cloth.depth_mm = 2;
  cloth.up = BitMatrix(1, count);
  for (int i = 0; i < count; ++i) cloth.up.set(0, i, true);
  return cloth;
}

std::unique_ptr<TubeScene> tubes_of(const Cloth& cloth) {
  auto tubes = TubeScene::build(cloth, {});
  EXPECT_TRUE(tubes) << problem_of(tubes);
  return std::move(tubes).value_or(nullptr);
}

TEST(tubes, a_ray_meets_the_cylinder_where_it_is) {
  const Cloth cloth = parallel_cylinders(3);
  const auto tubes = tubes_of(cloth);
  const float centre = centre_height_mm(cloth, System::kWarp, 0, 0.3f);
  for (float x : {-0.45f, -0.2f, 0.0f, 0.31f}) {
    for (float far : {0.0f, 600.0f, -3600.0f}) {  // infinite: the same three hundred periods away
      TubeHit hit;
      ASSERT_TRUE(tubes->intersect({1 + x + far, 0.3f, 5}, {0, 0, -1}, 0, hit));
      EXPECT_NEAR(hit.position.z, centre + std::sqrt(0.25f - x * x), 0.01f);
      EXPECT_NEAR(hit.normal.x, x / 0.5f, 0.02f);
      EXPECT_EQ(hit.system, System::kWarp);
    }
  }
}

TEST(tubes, gaps_let_half_of_the_rays_through) {
  const Cloth cloth = parallel_cylinders(2);
  const auto tubes = tubes_of(cloth);
  FlatPicture picture;
  picture.width = 4, picture.height = 1, picture.spp = 4096;
  picture.step_x_mm = {2, 0}, picture.step_y_mm = {0, 2};
  const TracedImage image = trace_flat(*tubes, picture, {});
  for (const glm::vec4& p : image.pixels) EXPECT_NEAR(p.a, 0.5f, 0.005f);
}

TEST(tubes, a_grazing_ray_always_meets_a_thread) {
  const auto tubes = tubes_of(parallel_cylinders(2));
  TubeHit hit;
  const float a = 89.9f * kPi / 180;
  EXPECT_TRUE(tubes->intersect({0, 0.5f, 0.4f}, {std::sin(a), 0, -std::cos(a)}, 0, hit));
}

/// A period of two cylinders in one pixel, lit from the eye.
FlatPicture one_pixel() {
  FlatPicture picture;
  picture.width = picture.height = 1;
  picture.spp = 20000;
  picture.step_x_mm = {4, 0}, picture.step_y_mm = {0, 2};
  picture.around.light_irradiance = glm::vec3(kPi);
  return picture;
}

TEST(trace, a_lambertian_cylinder_lit_from_the_eye_averages_a_quarter_pi) {
  const auto tubes = tubes_of(parallel_cylinders(2));
  FlatPicture picture = one_pixel();
  const TracedImage image = trace_flat(*tubes, picture, {});
  // Radiance cos(theta) over the covered half of the plane. A smooth yarn still shows its single fibres: their tone
  // has the mean 1, but white is clamped, which takes 1.5 %.
  EXPECT_NEAR(image.pixels[0].r, 0.5f * kPi / 4, 0.008f);
}

TEST(trace, cylinders_shade_each_other) {
  const auto tubes = tubes_of(parallel_cylinders(2));
  FlatPicture picture = one_pixel();
  // Light at 80 degrees across the threads: the neighbour's top shades the lower flank. Without shading,
  // the lit part of the section (phi from -90 + 80 to 90 seen from above) would give the first integral.
  const float a = 80 * kPi / 180;
  picture.around.light_towards = {std::sin(a), 0, std::cos(a)};
  const TracedImage image = trace_flat(*tubes, picture, {});
  double lit = 0, shaded = 0;
  const int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double x = -0.5 + (i + 0.5) / n, z = std::sqrt(0.25 - x * x);
    const double angle = 80 * std::numbers::pi / 180;
    const double cosine = (x * std::sin(angle) + z * std::cos(angle)) / 0.5;
    if (cosine <= 0) continue;
    lit += cosine / n;
    // Ray to the light against the next cylinder (centre at x = 2): distance of its centre from the ray.
    const double distance = std::abs((2 - x) * std::cos(angle) + z * std::sin(angle));
    if (distance > 0.5) shaded += cosine / n;
  }
  ASSERT_LT(shaded, 0.9 * lit);
  EXPECT_NEAR(image.pixels[0].r, 0.5 * shaded, 0.01 * lit);
}

TEST(trace, white_cloth_in_a_white_furnace_is_white) {
  Cloth cloth = parallel_cylinders(4);
  cloth.picks = {
      {1, 2, 1, 1, {1, 1, 1}, 0}, {3, 2, 1, 1, {1, 1, 1}, 0}, {5, 2, 1, 1, {1, 1, 1}, 0}, {7, 2, 1, 1, {1, 1, 1}, 0}};
  cloth.depth_mm = 8;
  cloth.up = BitMatrix(4, 4);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e) cloth.up.set(p, e, (p + e) % 2);
  const auto tubes = tubes_of(cloth);
  FlatPicture picture;
  picture.width = picture.height = 2;
  picture.spp = 4000;
  picture.bounces = 40;
  picture.step_x_mm = {4, 0}, picture.step_y_mm = {0, 4};
  picture.around.light_irradiance = glm::vec3(0);
  picture.around.sky = [](glm::vec3) { return glm::vec3(1); };
  // No energy is gained; losses are where threads are pressed into each other, and in the tone of the single fibres,
  // 1.5 % a bounce.
  const auto expect_white = [&](const TubeScene& scene) {
    for (const glm::vec4& p : trace_flat(scene, picture, {}).pixels) {
      EXPECT_LT(p.r, p.a * 1.005f);
      EXPECT_GT(p.r, p.a * 0.95f);
    }
  };
  expect_white(*tubes);
  cloth.yarns[0].lobes.specular = 1;  // energy-compensated: still white
  expect_white(*tubes_of(cloth));
}

TEST(trace, pictures_repeat_bit_for_bit) {
  const auto tubes = tubes_of(parallel_cylinders(2));
  FlatPicture picture;
  picture.width = picture.height = 8, picture.spp = 16;
  picture.around.light_radius_rad = 0.1f;
  const auto once = trace_flat(*tubes, picture, {}), again = trace_flat(*tubes, picture, {});
  EXPECT_EQ(once.pixels, again.pixels);
}

TEST(tubes, a_draft_too_large_to_trace_is_refused_in_words) {
  Cloth cloth = parallel_cylinders(20000);
  cloth.picks.resize(20000, cloth.picks[0]);
  cloth.up = BitMatrix(20000, 20000);
  EXPECT_NE(problem_of(TubeScene::build(cloth, {})).find("20000"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::reference
