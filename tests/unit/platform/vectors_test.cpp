// Work compiled for several kinds of vectors, each as far as this processor has it.

#include "platform/vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace weftlight::platform {
namespace {

/// Sums of products, which are rounded otherwise where both are one instruction.
std::vector<float> sums_of_products(const std::vector<float>& x) {
  std::vector<float> out(x.size());
  for (size_t k = 0; k < x.size(); ++k) out[k] = x[k] * x[x.size() - 1 - k] + x[k] / (1 + x[k] * x[k]);
  return out;
}

std::vector<float> numbers() {
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> u(-1, 1);
  std::vector<float> x(100003);
  for (float& v : x) v = u(rng);
  return x;
}

TEST(Vectors, TheWidestGiveTheSameBits) {
  const std::vector<float> x = numbers(), plain = sums_of_products(x);
  std::vector<float> wide;
  with_widest_vectors([&] { wide = sums_of_products(x); });
  EXPECT_EQ(wide, plain);
}

TEST(Vectors, EachKindGivesTheSameUpToRounding) {
  const std::vector<float> x = numbers(), plain = sums_of_products(x);
  for (const Vectors kind : {Vectors::kBaseline, widest_vectors()}) {
    std::vector<float> out;
    with_vectors(kind, [&] { out = sums_of_products(x); });
    ASSERT_EQ(out.size(), plain.size());
    for (size_t k = 0; k < x.size(); ++k) ASSERT_NEAR(out[k], plain[k], 1e-6f) << k;
  }
}

}  // namespace
}  // namespace weftlight::platform
