// Floats and stripes of method irawan: lengths of floats, energy, and the position of the stripes by the half vector.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "cloth/thread_scene.h"
#include "drafts.h"

namespace weftlight::cloth {

using draft::BitMatrix, draft::Face;

namespace thread_formulas {

class IrawanScene : public ThreadScene {
 public:
  using ThreadScene::ThreadScene;
#define FORMULA
#include "shaders/irawan.glsl"
#undef FORMULA
};

}  // namespace thread_formulas

namespace {

using thread_formulas::IrawanScene;
using Point = IrawanScene::IrawanPoint;
using glm::vec2;
using glm::vec3;

constexpr float kSpacing = 0.5f, kWidth = 0.4f;

Cloth cloth_of(int shafts, const BitMatrix& cells) {
  return lay_out(design_of(shafts, shafts, kSpacing, kWidth), cells, Face::kFront, Period::kWholeDraft);
}

/// Ends over three picks and under one.
BitMatrix warp_faced_twill() {
  return cells_of(4, 4, [](int e, int p) { return (e + p) % 4 != 0; });
}

vec3 towards(float cosine, float turn) {
  const float s = std::sqrt(1 - cosine * cosine);
  return {s * std::cos(turn), s * std::sin(turn), cosine};
}

TEST(Irawan, AFloatIsAsLongAsItIsWoven) {
  IrawanScene front(cloth_of(4, warp_faced_twill()));
  const auto g = front.grid();
  for (int e = 0; e < 4; ++e)
    for (int p = 0; p < 4; ++p) {
      const vec2 at{(static_cast<float>(e) + 0.5f) * kSpacing, (static_cast<float>(p) + 0.5f) * kSpacing};
      const bool warp = (e + p) % 4 != 0;
      const Point point = front.irawan_point(g, at);
      EXPECT_EQ(point.system, warp ? 0 : 1);
      EXPECT_TRUE(point.above);
      EXPECT_EQ(point.thread, warp ? e : p);
      EXPECT_NEAR(point.size.y, warp ? 3 * kSpacing : kSpacing, 1e-5f);
      EXPECT_NEAR(point.at.x, 0, 1e-5f);
      // The middle crossing of three lies at the centre of the float.
      if (warp) {
        EXPECT_NEAR(point.at.y, static_cast<float>((e + p) % 4 - 2) * kSpacing, 1e-5f);
      }
    }
  // Between two ends on top the pick below is visible; between both systems nothing is.
  const Point beside = front.irawan_point(g, {kSpacing, 2.5f * kSpacing});
  EXPECT_EQ(beside.system, 1);
  EXPECT_FALSE(beside.above);
  EXPECT_EQ(front.irawan_specular(beside, 0.4f, {0, 0, 1}, {0, 0, 1}), 0);
  EXPECT_EQ(front.irawan_point(g, {kSpacing, kSpacing}).system, -1);
}

TEST(Irawan, TheBackHasItsOwnFloats) {
  IrawanScene back(cloth_of(4, warp_faced_twill()), Face::kBack);
  const Point point = back.irawan_point(back.grid(), {0.5f * kSpacing, 1.5f * kSpacing});
  EXPECT_EQ(point.system, 1);
  EXPECT_NEAR(point.size.y, 3 * kSpacing, 1e-5f);
}

/// Mean radiance times the view's cosine over a float; `count` samples each way.
double mean_over(IrawanScene& s, Point p, float fibre_tan, const vec3& l, const vec3& v, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < count; ++k) {
      p.at = {p.size.x * ((static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f),
              p.size.y * ((static_cast<float>(k) + 0.5f) / static_cast<float>(count) - 0.5f)};
      sum += static_cast<double>(s.irawan_specular(p, fibre_tan, l, v));
    }
  return sum * static_cast<double>(v.z) / (count * count);
}

TEST(Irawan, MirrorsTheShareThatItIsAskedFor) {
  IrawanScene s(cloth_of(4, warp_faced_twill()));
  const Point p = s.irawan_point(s.grid(), {1.5f * kSpacing, 1.5f * kSpacing});
  for (const float fibre_tan : {0.0f, 0.15f, 0.5f, -0.5f, 1.0f})
    for (const float cosine : {1.0f, 0.7f, 0.3f}) {
      const vec3 l = towards(cosine, 0.8f);
      double sent = 0;
      constexpr int kRings = 24, kTurns = 48;
      for (int i = 0; i < kRings; ++i)
        for (int k = 0; k < kTurns; ++k) {
          const float z = (static_cast<float>(i) + 0.5f) / kRings;
          sent += mean_over(s, p, fibre_tan, l, towards(z, (static_cast<float>(k) + 0.5f) / kTurns * 6.2831853f), 16);
        }
      sent *= 6.2831853 / (kRings * kTurns);
      // At normal incidence the required fraction; at a slant its bend catches light that a plane does not.
      EXPECT_NEAR(sent, 1, cosine > 0.9f ? 0.1 : 0.35) << fibre_tan << " " << cosine;
    }
}

TEST(Irawan, IsReciprocal) {
  IrawanScene s(cloth_of(4, warp_faced_twill()));
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> u(0, 1);
  for (int k = 0; k < 5000; ++k) {
    const Point p = s.irawan_point(s.grid(), {u(rng) * 4 * kSpacing, u(rng) * 4 * kSpacing});
    if (p.system < 0) continue;
    const vec3 l = towards(0.05f + 0.95f * u(rng), 6.28f * u(rng)), v = towards(0.05f + 0.95f * u(rng), 6.28f * u(rng));
    const float there = s.irawan_specular(p, 0.4f, l, v) * v.z, back = s.irawan_specular(p, 0.4f, v, l) * l.z;
    EXPECT_NEAR(there, back, 1e-3f * std::max(1.0f, there));
  }
}

TEST(Irawan, ThreadsShineAcrossTheLight) {
  IrawanScene s(cloth_of(4, warp_faced_twill()));
  const Point warp = s.irawan_point(s.grid(), {1.5f * kSpacing, 1.5f * kSpacing});
  ASSERT_EQ(warp.system, 0);
  // Straight fibres mirror only within the bend of the float: across the thread over wide angles, along it at most
  // twice its inclination.
  const vec3 across{0.9f, 0, std::sqrt(1 - 0.81f)}, along{0, 0.9f, std::sqrt(1 - 0.81f)};
  EXPECT_GT(mean_over(s, warp, 0, across, {0, 0, 1}, 64), 0.1);
  EXPECT_EQ(mean_over(s, warp, 0, along, {0, 0, 1}, 64), 0);
  // The stripe of a twisted yarn moves around it towards the light.
  const auto middle = [&](const vec3& l) {
    double sum = 0, weight = 0;
    Point p = warp;
    for (int i = 0; i < 400; ++i) {
      p.at = {p.size.x * ((static_cast<float>(i) + 0.5f) / 400 - 0.5f), 0};
      const double w = static_cast<double>(s.irawan_specular(p, 0.5f, l, {0, 0, 1}));
      sum += w * static_cast<double>(p.at.x), weight += w;
    }
    EXPECT_GT(weight, 0);
    return sum / weight;
  };
  const double none = middle({0, 0, 1}), right = middle(towards(0.8f, 0)), left = middle(towards(0.8f, 3.1415927f));
  EXPECT_GT(right, none);
  EXPECT_LT(left, none);
  // It runs along the whole thread under light level with it.
  Point p = warp;
  for (int k = 0; k < 20; ++k) {
    float most = 0;
    for (int i = 0; i < 64; ++i) {
      p.at = {p.size.x * ((static_cast<float>(i) + 0.5f) / 64 - 0.5f),
              p.size.y * ((static_cast<float>(k) + 0.5f) / 20 - 0.5f)};
      most = std::max(most, s.irawan_specular(p, 1.0f, {0, 0, 1}, {0, 0, 1}));
    }
    EXPECT_GT(most, 0) << k;
  }
}

TEST(Irawan, VonMisesIsADistribution) {
  IrawanScene s(cloth_of(4, warp_faced_twill()));
  for (const float k : {0.5f, 1.5f, 3.7f, 4.0f, 20.0f}) {
    double sum = 0;
    for (int i = 0; i < 2000; ++i)
      sum += static_cast<double>(s.irawan_von_mises(std::cos((static_cast<float>(i) + 0.5f) / 2000 * 6.2831853f), k));
    EXPECT_NEAR(sum * 6.2831853 / 2000, 1, 1e-3) << k;
  }
}

}  // namespace
}  // namespace weftlight::cloth
