#include "cloth/horizon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drafts.h"

namespace weftlight::cloth {

using draft::Face;

namespace {

constexpr double kPi = std::numbers::pi;

double sine_at(const Plane<uint8_t>& plane, int x, int y) { return plane.at(x, y) / 255.0; }

Plane<uint8_t> towards(const Plane<float>& z, double azimuth, float dx = 1, float dy = 1, float reach = 1e6f) {
  return horizon(z, sweep_towards(azimuth, z.width, z.height, dx, dy, reach));
}

TEST(Horizon, FlatFieldSeesTheWholeSky) {
  const Plane<float> z(33, 20, 1.5f);
  for (int k = 0; k < 16; ++k)
    for (uint8_t v : towards(z, k * kPi / 8).at_) EXPECT_EQ(v, 0);
}

TEST(Horizon, WallHidesByHeightOverDistance) {
  // A wall one texel thick across the whole field at x = 80.
  Plane<float> z(100, 40);
  for (int y = 0; y < 40; ++y) z.at(80, y) = 7.0f;
  for (double azimuth : {0.0, 0.3, -0.5, kPi / 4, -kPi / 4, 0.7}) {
    const Plane<uint8_t> h = towards(z, azimuth);
    for (int x : {30, 50, 70, 78}) {
      const double distance = (80 - x) / std::cos(azimuth), slope = 7.0 / distance;
      EXPECT_NEAR(sine_at(h, x, 13), slope / std::hypot(1.0, slope), 0.004) << azimuth << " " << x;
    }
    EXPECT_EQ(h.at(80, 5), 0);
  }
  const Plane<uint8_t> from_left = towards(z, kPi);
  EXPECT_NEAR(sine_at(from_left, 90, 3), 7.0 / std::hypot(7.0, 10.0), 0.004);
  // Across the border: from x = 10 the wall is 30 texels to the left.
  EXPECT_NEAR(sine_at(from_left, 10, 3), 7.0 / std::hypot(7.0, 30.0), 0.004);
}

TEST(Horizon, TexelsNeedNotBeSquare) {
  Plane<float> z(60, 90);
  for (int x = 0; x < 60; ++x) z.at(x, 70) = 2.0f;
  const float dx = 0.5f, dy = 0.25f;
  for (double azimuth : {kPi / 2, kPi / 3, 2.0, 1.0}) {
    const Plane<uint8_t> h = towards(z, azimuth, dx, dy);
    const double distance = 30 * 0.25 / std::sin(azimuth);
    EXPECT_NEAR(sine_at(h, 20, 40), 2.0 / std::hypot(2.0, distance), 0.006) << azimuth;
  }
}

TEST(Horizon, SmoothRidgeAgreesWithASearchAtEveryAzimuth) {
  const int n = 256;
  Plane<float> z(n, n);
  const auto field = [&](double x, double y) {
    return 11.0 * std::sin(2 * kPi * x / n) + 8.0 * std::cos(2 * kPi * (x + 2 * y) / n);
  };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) z.at(x, y) = static_cast<float>(field(x, y));
  for (int k = 0; k < 16; ++k) {
    const double azimuth = k * kPi / 8 + 0.05;
    const Plane<uint8_t> h = towards(z, azimuth);
    for (int y = 3; y < n; y += 37)
      for (int x = 5; x < n; x += 31) {
        // The height field is sampled at whole steps of the sweep, so the search starts there.
        const double step = 1 / std::max(std::abs(std::cos(azimuth)), std::abs(std::sin(azimuth)));
        double slope = 0;
        for (double d = step; d < 1.45 * n; d += 0.5)
          slope = std::max(slope, (field(x + d * std::cos(azimuth), y + d * std::sin(azimuth)) - field(x, y)) / d);
        EXPECT_NEAR(sine_at(h, x, y), slope / std::hypot(1.0, slope), 0.03) << k << " " << x << " " << y;
      }
  }
}

TEST(Horizon, OneTexelAndThinFields) {
  EXPECT_EQ(towards(Plane<float>(1, 1, 2.0f), 0.3).at(0, 0), 0);
  Plane<float> line(50, 1);
  line.at(25, 0) = 5.0f;
  EXPECT_NEAR(sine_at(towards(line, 0.0), 20, 0), 5 / std::hypot(5.0, 5.0), 0.004);
}

TEST(ShadowMap, AgreesWithTheHorizonAndDarkensAsTheLightSinks) {
  const Cloth cloth = lay_out(design_of(8, 8, 0.5f, 0.45f), satin(8, 8), Face::kFront, Period::kWholeDraft);
  const Maps m = bake(cloth, {128, 128, 16, 2});
  int before = 0;
  for (float elevation : {0.0f, 0.1f, 0.4f, 0.8f, 1.57f}) {
    int lit = 0;
    for (uint8_t v : shadow_map(m, 0.9f, elevation).at_) lit += v;
    EXPECT_GE(lit, before);
    before = lit;
  }
  EXPECT_GT(before, 128 * 128 * 9 / 10);
  for (uint8_t v : shadow_map(m, 0.9f, -0.2f).at_) EXPECT_EQ(v, 0);
}

TEST(Occlusion, IsOneOnTheFlatAndLessBetweenThreads) {
  const Cloth cloth = lay_out(design_of(4, 4, 0.5f, 0.4f), plain(4, 4), Face::kFront, Period::kWholeDraft);
  const Maps m = bake(cloth, {160, 160, 16, 2});
  EXPECT_GT(m.occlusion.at(20, 20), 0.95f);  // crest of a crossing
  EXPECT_LT(m.occlusion.at(0, 0), 0.5f);     // gap
}

}  // namespace
}  // namespace weftlight::cloth
