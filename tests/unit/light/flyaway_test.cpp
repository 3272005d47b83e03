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
    sum += static_cast<double>(formulas::flyaway_phase(cosine)) * 4 * std::numbers::pi / kSteps;
  }
  EXPECT_NEAR(sum, 1, 1e-4);
}

TEST(Flyaway, IsAsBrightAsAWhiteSkyAtMost) {
  const glm::vec3 white(1), half(0.5f);
  EXPECT_NEAR(formulas::flyaway_sky(white, white).x, 1, 1e-6);
  EXPECT_LT(formulas::flyaway_sky(half, half).x, 0.5f);
  EXPECT_GT(formulas::flyaway_sky(half, half).x, 0);
}

TEST(Flyaway, GlowsAgainstTheLight) {
  const glm::vec3 fibre(0, 1, 0), n(1, 0, 0), l(0, 0, -1), colour(0.5f), body(0.3f);
  const float against = formulas::flyaway_key(colour, body, fibre, n, l, {0, 0, 1}).x;
  const float aside = formulas::flyaway_key(colour, body, fibre, n, l, {1, 0, 0}).x;
  EXPECT_GT(against, 3 * aside);
}

TEST(Flyaway, OfANapReachFromThreadToThreadAndAreNoFewer) {
  constexpr float kSpacing = 0.5f, kDepth = 0.9f, kRaised = 0.96f, kHairy = 0.35f;
  const auto cell = [](float fuzz) { return formulas::face_cell(fuzz, kDepth, kSpacing); };
  const float nap = cell(kRaised);
  EXPECT_GT(formulas::flyaway_reach({nap, nap}), 0.5f * kSpacing) << "half a fibre; it was a quarter of a spacing";
  EXPECT_LE(formulas::face_flyaways_in(kRaised, nap * nap), formulas::max_face_flyaways(kRaised));
  // Hairy yarns that are not raised keep theirs, of which a pixel looks at few.
  EXPECT_EQ(formulas::nap_of(kHairy), 0);
  EXPECT_EQ(formulas::max_face_flyaways(kHairy), formulas::kMaxFaceFlyaways);
}

}  // namespace
}  // namespace weftlight::light
