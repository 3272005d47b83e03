// Sections of threads, from an ellipse to nearly a rectangle: the formulas of shaders/thread_section.glsl agree with
// each other.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/thread_texture.h"

namespace weftlight::cloth {
namespace {

using glm::vec2, glm::vec4;
using thread_formulas::section_curvature, thread_formulas::section_fullness, thread_formulas::section_gradient,
    thread_formulas::section_norm, thread_formulas::section_point, thread_formulas::section_top;

class ThreadSectionShape : public testing::TestWithParam<float> {};

TEST_P(ThreadSectionShape, PointsLieOnIt) {
  const float q = GetParam();
  for (int tenth = -30; tenth < 30; ++tenth) {
    const float angle = 0.1f * static_cast<float>(tenth);
    const vec4 p = section_point(angle, q);
    EXPECT_NEAR(section_norm(p.x * p.x, p.y * p.y, q), 1, 1e-5f) << angle;
    EXPECT_NEAR(section_norm(0.09f * p.x * p.x, 0.09f * p.y * p.y, q), 0.3f, 1e-5f) << angle;
    EXPECT_NEAR(std::atan2(p.x, p.y), angle, 1e-5f);
    // Below that the height changes faster than a float can tell.
    if (p.y > 0.05f) {
      EXPECT_NEAR(section_top(p.x, q), p.y, 1e-3f) << angle;
    }
  }
}

TEST_P(ThreadSectionShape, NormalsAndCurvatureAreThoseOfThePoints) {
  const float q = GetParam();
  const vec2 half(0.4f, 0.25f);
  constexpr float kStep = 1e-2f;
  for (int tenth = -30; tenth < 30; ++tenth) {
    const float angle = 0.1f * static_cast<float>(tenth);
    const vec4 p = section_point(angle, q), before = section_point(angle - kStep, q),
               after = section_point(angle + kStep, q);
    const vec2 step = (vec2(after) - vec2(before)) / (2 * kStep);
    EXPECT_NEAR(p.z, step.x, 2e-3f) << angle;
    EXPECT_NEAR(p.w, step.y, 2e-3f) << angle;
    const vec2 out = section_gradient(p.x, p.y, q) / half, way = half * step;
    EXPECT_NEAR(glm::dot(glm::normalize(out), glm::normalize(way)), 0, 3e-3f) << angle;
    const vec2 a = half * (vec2(p) - vec2(before)), b = half * (vec2(after) - vec2(p));
    const float turn = std::asin((a.x * b.y - a.y * b.x) / (glm::length(a) * glm::length(b)));
    const float bent = -turn / (0.5f * (glm::length(a) + glm::length(b)));
    EXPECT_NEAR(section_curvature(p.x, p.y, q, 1.0f / half), bent, 0.02f * bent + 0.01f) << angle;
  }
}

TEST_P(ThreadSectionShape, ItsFullnessIsItsArea) {
  constexpr int kParts = 100'000;
  double sum = 0;
  for (int i = 0; i < kParts; ++i)
    sum += static_cast<double>(section_top((static_cast<float>(i) + 0.5f) / kParts, GetParam()));
  EXPECT_NEAR(static_cast<double>(section_fullness(GetParam())), sum / kParts * 4 / std::numbers::pi, 5e-4);
}

INSTANTIATE_TEST_SUITE_P(FromEllipseToRectangle, ThreadSectionShape, testing::Values(0.0f, 0.3f, 0.5f, 0.75f));

}  // namespace
}  // namespace weftlight::cloth
