#include <gtest/gtest.h>

#include <numbers>

#include "light/formulas.h"

namespace weftlight::light {
namespace {

TEST(Flyaway, ScattersNoMoreThanItMeets) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float cosine = -1 + 2 * (static_cast<float>(i) + 0.5f) / kSteps;
    sum += static_cast<double>(formulas::hair_phase(cosine)) * 4 * std::numbers::pi / kSteps;
  }
  EXPECT_NEAR(sum, 1, 1e-4);
}

TEST(Flyaway, IsAsBrightAsAWhiteSkyAtMost) {
  const glm::vec3 white(1), half(0.5f);
  EXPECT_NEAR(formulas::hair_soft(white, white).x, 1, 1e-6);
  EXPECT_LT(formulas::hair_soft(half, half).x, 0.5f);
  EXPECT_GT(formulas::hair_soft(half, half).x, 0);
}

TEST(Flyaway, GlowsAgainstTheLight) {
  const glm::vec3 fibre(0, 1, 0), n(1, 0, 0), l(0, 0, -1), colour(0.5f), body(0.3f);
  const float against = formulas::hair_key(colour, body, fibre, n, l, {0, 0, 1}).x;
  const float aside = formulas::hair_key(colour, body, fibre, n, l, {1, 0, 0}).x;
  EXPECT_GT(against, 3 * aside);
}

}  // namespace
}  // namespace weftlight::light
