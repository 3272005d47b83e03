// Batches of pairs against the formulas one by one, with every kind of vectors of this machine.

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "light/yarn_lobes.h"
#include "sampling.h"

namespace weftlight::light {

using design::Lobes;

namespace {

std::vector<Vectors> kinds() {
  if (widest_vectors() == Vectors::kBaseline) return {Vectors::kBaseline};
  return {Vectors::kBaseline, widest_vectors()};
}

struct Pairs {
  std::vector<glm::vec3> wi, wo, out;
  void add(const glm::vec3& i, const glm::vec3& o) { wi.push_back(i), wo.push_back(o), out.emplace_back(-1.0f); }
};

Pairs random_pairs(std::mt19937& rng, int count) {
  Pairs p;
  for (int k = 0; k < count; ++k)
    p.add(random_upper(rng) * glm::vec3(1, 1, k % 17 ? 1 : -1), random_upper(rng) * glm::vec3(1, 1, k % 23 ? 1 : -1));
  return p;
}

TEST(Batch, EqualsOneByOne) {
  for (const Vectors vectors : kinds()) {
    std::mt19937 rng(13);
    for (int yarn = 0; yarn < 200; ++yarn) {
      const formulas::YarnLobes y = random_lobes(rng);
      Pairs p = random_pairs(rng, 100);
      reflect(y, p.wi, p.wo, p.out, vectors);
      for (size_t k = 0; k < p.out.size(); ++k) {
        const glm::vec3 one = formulas::yarn_reflect(y, p.wi[k], p.wo[k]);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(p.out[k][c], one[c], 1e-4f * one[c] + 1e-7f) << yarn << " " << k;
      }
    }
  }
}

TEST(Batch, TakesAnyCount) {
  std::mt19937 rng(17);
  const formulas::YarnLobes y = yarn_lobes(Lobes{}, {0.6f, 0.3f, 0.1f});
  for (const Vectors vectors : kinds())
    for (const size_t count : {size_t{0}, size_t{1}, size_t{63}, size_t{64}, size_t{65}, size_t{130}}) {
      Pairs p = random_pairs(rng, 200);
      const std::span<glm::vec3> part = std::span(p.out).first(count);
      reflect(y, std::span(p.wi).first(count), std::span(p.wo).first(count), part, vectors);
      if (count > 1) {
        EXPECT_GT(part.back().x, 0) << count;
      }
      for (size_t k = count; k < p.out.size(); ++k) ASSERT_EQ(p.out[k].x, -1) << count;
    }
}

TEST(Batch, LightAndViewChangePlaces) {
  std::mt19937 rng(19);
  for (const Vectors vectors : kinds())
    for (int yarn = 0; yarn < 100; ++yarn) {
      const formulas::YarnLobes y = random_lobes(rng);
      Pairs p = random_pairs(rng, 64);
      std::vector<glm::vec3> swapped(p.out.size());
      reflect(y, p.wi, p.wo, p.out, vectors);
      reflect(y, p.wo, p.wi, swapped, vectors);
      for (size_t k = 0; k < p.out.size(); ++k)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(p.out[k][c], swapped[k][c], 1e-5f * (1 + p.out[k][c])) << yarn;
    }
}

TEST(Batch, NeitherNaNNorNegativeAtTheEdges) {
  std::mt19937 rng(23);
  for (const Vectors vectors : kinds())
    for (const float a : {0.0f, 1e-3f, 0.3f, 30.0f, 1e6f, 1e18f})
      for (const float b : {0.0f, 1e-3f, 0.3f, 30.0f, 1e6f, 1e18f}) {
        formulas::YarnLobes y = random_lobes(rng);
        y.slope_cov = {a * a, a * b, b * b};
        Pairs p;
        for (const float zi : {0.0f, 1e-30f, 1e-7f, 1.745e-3f, 0.1f, 0.9999999f, 1.0f})
          for (const float zo : {0.0f, 1e-30f, 1e-7f, 1.745e-3f, 0.1f, 0.9999999f, 1.0f})
            for (const float turn : {0.0f, 1.0f, 3.1415927f}) p.add(direction(zi, turn), direction(zo, 0));
        reflect(y, p.wi, p.wo, p.out, vectors);
        for (const glm::vec3& f : p.out)
          for (int c = 0; c < 3; ++c) ASSERT_TRUE(std::isfinite(f[c]) && f[c] >= 0) << a << " " << b << " " << f[c];
      }
}

TEST(Batch, DirectionThatIsNoNumberHarmsNoOther) {
  const formulas::YarnLobes y = yarn_lobes(Lobes{}, {0.6f, 0.3f, 0.1f});
  const glm::vec3 none(std::numeric_limits<float>::quiet_NaN()), up(0, 0, 1);
  for (const Vectors vectors : kinds()) {
    Pairs p;
    p.add(none, up), p.add(up, up), p.add(up, none);
    reflect(y, p.wi, p.wo, p.out, vectors);
    EXPECT_NEAR(p.out[1].x, formulas::yarn_reflect(y, up, up).x, 1e-4f);
    EXPECT_EQ(p.out[0].x, 0);
    EXPECT_EQ(p.out[2].x, 0);
  }
}

}  // namespace
}  // namespace weftlight::light
