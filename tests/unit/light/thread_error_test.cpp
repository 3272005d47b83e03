// Sampling error measured on a cloth's threads, and the LOD table fitted to it.

#include "light/thread_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plain_cloth.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Linear, cloth::ThreadBody;
using design::Method, design::Yarn;

namespace {

Cloth plain() { return plain_cloth(16, 0.5f, 0.45f); }

/// Errors of the worst cloths, for a number of samples at any footprint.
LodTable of_the_worst() {
  LodTable lod_table;
  for (int i = 0; i < formulas::kLattices; ++i) {
    for (const float yarns : kErrorFootprints) {
      const int samples = formulas::lattice_of(i).x;
      const float error = 1.2f * std::sqrt(yarns / static_cast<float>(samples));
      lod_table.push_back({Method::kYarn, yarns, 10.0f * static_cast<float>(samples), error, error, samples});
    }
  }
  lod_table.push_back({Method::kRepeat, 1, 1, 0.1f, 0.1f, 1});
  return lod_table;
}

TEST(ThreadErrors, FallWithSamplesAndAreTheSameEveryTime) {
  const ThreadErrors errors = thread_errors(plain());
  EXPECT_TRUE(errors.measured);
  EXPECT_EQ(errors, thread_errors(plain()));
  for (size_t f = 0; f < kErrorFootprints.size(); ++f) {
    for (const float e : errors.rel_rmse[f]) EXPECT_TRUE(e > 0 && e < 1) << kErrorFootprints[f] << ' ' << e;
    EXPECT_LT(errors.rel_rmse[f].back(), errors.rel_rmse[f].front()) << kErrorFootprints[f];
  }
  EXPECT_GT(errors.rel_rmse.back()[1], 1.5f * errors.rel_rmse.front()[1]);
  // Regular weaves in one colour: an eighth of the error of a black picture.
  EXPECT_LT(errors.rel_rmse.back().back(), 0.125f);
}

// A metal sends nothing in the channels that it has not.
TEST(ThreadErrors, OfAPureColourAreThoseOfTheOthers) {
  Yarn metal;
  metal.lobes.metallic = true;
  metal.lobes.fuzz = 0;
  Cloth cloth = plain_cloth(16, 0.5f, 0.45f, metal);
  const auto in = [&cloth](const Linear& colour) {
    for (auto* threads : {&cloth.ends, &cloth.picks})
      for (ThreadBody& thread : *threads) thread.colour = colour;
    return thread_errors(cloth);
  };
  const ThreadErrors red = in({1, 0, 0}), green = in({0, 1, 0});
  for (size_t f = 0; f < kErrorFootprints.size(); ++f)
    for (size_t i = 0; i < kErrorLattices; ++i) EXPECT_NEAR(red.rel_rmse[f][i], green.rel_rmse[f][i], 1e-3f);
}

TEST(ThreadErrors, FitTheLodTableToTheCloth) {
  const LodTable any = of_the_worst();
  const Plan plan = plan_of(any, {0.15f}), own = plan_of(fitted(any, thread_errors(plain())), {0.15f});
  EXPECT_LT(samples_at(own, 0.5f), samples_at(plan, 0.5f));
  EXPECT_GE(samples_at(own, 1), samples_at(own, 0.25f));
  // Other methods, and unmeasured cloths, keep their rows.
  EXPECT_EQ(expected_error(fitted(any, thread_errors(plain())), Method::kRepeat, 1), 0.1f);
  EXPECT_EQ(expected_error(fitted(any, {}), Method::kYarn, 1, 5), expected_error(any, Method::kYarn, 1, 5));
}

TEST(ThreadErrors, OfNoThreadsAreNotMeasured) {
  EXPECT_FALSE(thread_errors({}).measured);
  // A LOD table without rows of method yarn stays as it is.
  const LodTable none{{Method::kRepeat, 1, 1, 0.1f, 0.1f, 1}};
  EXPECT_EQ(expected_error(fitted(none, thread_errors(plain())), Method::kRepeat, 1), 0.1f);
}

}  // namespace
}  // namespace weftlight::light
