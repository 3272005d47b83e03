// Fibres on the surface of threads that are seen near (shaders/fibre_detail.glsl).

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "cloth/thread_texture.h"
#include "design/yarn_presets.h"

namespace weftlight::cloth {

using design::Twist, design::yarn_presets;

namespace {

using thread_formulas::mean_texel, thread_formulas::SurfaceFrame;

constexpr float kLength_mm = 12;
constexpr glm::vec2 kNear{1e-5f, 1e-5f};  // turns around, periods along

ThreadTexture texture_of(const Yarn& yarn, int thread = 3) {
  const ThreadBody body{0, 1.2f * yarn.diameter_mm, yarn.diameter_mm, yarn.flattening * yarn.diameter_mm, {}, 0};
  return thread_texture(yarn, body, System::kWarp, thread, kLength_mm);
}

/// What a weaver can make: the ready yarns, and odd ones.
std::vector<Yarn> many_yarns() {
  std::vector<Yarn> yarns(yarn_presets().begin(), yarn_presets().end());
  Yarn odd;
  odd.plies = 8, odd.turns_per_m = 5000, odd.diameter_mm = 0.02f, odd.hairiness = 1, odd.melange = 1;
  yarns.push_back(odd);
  odd.plies = 1, odd.twist = Twist::kNone, odd.fibre_um = 2000;
  yarns.push_back(odd);
  odd.diameter_mm = 50, odd.fibre_um = 1, odd.twist = Twist::kS;
  yarns.push_back(odd);
  return yarns;
}

/// Means over a thread of what is seen of its fibres.
struct Means {
  double groove = 0, tone = 0, across = 0, along = 0;  // variances of the slopes
};

Means means_of(const ThreadTexture& x, glm::vec2 size, int points = 40'000) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> u(0, 1);
  Means m;
  for (int i = 0; i < points; ++i) {
    const FibreDetail d = fibre_detail(x, u(rng), u(rng) - 0.5f, size, kLength_mm);
    const glm::vec2 fibre = glm::normalize(glm::vec2(d.fibre_tan, 1)), across(fibre.y, -fibre.x);
    const double a = static_cast<double>(glm::dot(across, d.slope)), b = static_cast<double>(glm::dot(fibre, d.slope));
    m.groove += static_cast<double>(d.texel.groove) / points, m.tone += static_cast<double>(d.texel.tone) / points;
    m.across += a * a / points, m.along += b * b / points;
  }
  return m;
}

TEST(FibreDetail, NothingIsLeftOfItFarAway) {
  for (const Yarn& yarn : yarn_presets()) {
    const ThreadTexture x = texture_of(yarn);
    // A sample as wide as the thread.
    const FibreDetail d = fibre_detail(x, 0.37f, 0.1f, {0.32f, 0.3f}, kLength_mm);
    const Texel mean = mean_texel(x);
    EXPECT_EQ(d.slope, glm::vec2(0)) << yarn.name;
    EXPECT_EQ(d.resolved, glm::vec2(0)) << yarn.name;
    EXPECT_EQ(d.fibre_tan, x.fibre_tan) << yarn.name;
    EXPECT_FLOAT_EQ(d.texel.tone, mean.tone) << yarn.name;
    EXPECT_FLOAT_EQ(d.texel.groove, mean.groove * (x.plies > 1 ? 1 - x.depth / 7 : 1)) << yarn.name;
    EXPECT_EQ(thread_formulas::detail_gain(x, d, 1), 1) << yarn.name;
    const glm::vec3 v(0.3f, 0, 0.954f);
    const SurfaceFrame frame{glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)};
    EXPECT_EQ(thread_formulas::detail_normal(frame, x, d, 1, kLength_mm, v), frame.normal) << yarn.name;
  }
}

TEST(FibreDetail, KeepsTheMeansOfTheThread) {
  for (const Yarn& yarn : yarn_presets()) {
    const ThreadTexture x = texture_of(yarn);
    const Means near = means_of(x, kNear), far = means_of(x, {1, 1});
    EXPECT_NEAR(near.groove / far.groove, 1, 0.05) << yarn.name;
    EXPECT_NEAR(near.tone / far.tone, 1, 0.05) << yarn.name;
  }
}

// Of a few threads: each has few tufts.
TEST(FibreDetail, AMelangeHasTheColourOfItsThreads) {
  constexpr int kThreads = 24;
  for (Yarn yarn : yarn_presets()) {
    yarn.melange = 1;
    double near = 0, far = 0;
    for (int thread = 0; thread < kThreads; ++thread) {
      const ThreadTexture x = texture_of(yarn, thread);
      near += means_of(x, kNear, 4000).tone, far += means_of(x, {1, 1}, 1).tone;
    }
    EXPECT_NEAR(near / far, 1, 0.05) << yarn.name;
  }
}

// What the lobes lose is what the normals have.
TEST(FibreDetail, TellsHowMuchOfTheSlopesItResolves) {
  for (const Yarn& yarn : yarn_presets()) {
    const ThreadTexture x = texture_of(yarn);
    for (const float part : {0.0f, 0.5f}) {
      const float size = part / x.lanes;
      const FibreDetail d = fibre_detail(x, 0.2f, 0, {size, 0}, kLength_mm);
      const Means found = means_of(x, {size, 0});
      EXPECT_NEAR(found.across, static_cast<double>(d.resolved.y), 0.2 * found.across + 0.01) << yarn.name;
      EXPECT_NEAR(found.along, static_cast<double>(d.resolved.x), 0.3 * found.along + 0.005) << yarn.name;
    }
  }
}

TEST(FibreDetail, FadesInWithoutAJump) {
  for (const Yarn& yarn : yarn_presets()) {
    const ThreadTexture x = texture_of(yarn);
    std::mt19937 rng(9);
    std::uniform_real_distribution<float> u(0, 1);
    for (int i = 0; i < 200; ++i) {
      const float along = u(rng), turn = u(rng) - 0.5f;
      FibreDetail before = fibre_detail(x, along, turn, {1, 0}, kLength_mm);
      for (int step = 0; step < 610; ++step) {  // down to 1e-4
        const auto size = static_cast<float>(std::pow(0.985, step));
        const FibreDetail d = fibre_detail(x, along, turn, {size, 0}, kLength_mm);
        ASSERT_LT(glm::length(d.slope - before.slope), 0.15f) << yarn.name << ' ' << size;
        ASSERT_LT(std::abs(d.texel.groove - before.texel.groove), 0.05f) << yarn.name << ' ' << size;
        ASSERT_LT(std::abs(d.texel.tone - before.texel.tone), 0.08f) << yarn.name << ' ' << size;
        before = d;
      }
    }
  }
}

// Fibres go on in the next repeat of the cloth. Stray fibres do not: they end at a node.
TEST(FibreDetail, TheTileCloses) {
  for (Yarn yarn : yarn_presets()) {
    yarn.hairiness = 0;
    for (int thread = 0; thread < 8; ++thread) {
      const ThreadTexture x = texture_of(yarn, thread);
      int off = 0;
      for (int i = 0; i < 100; ++i) {
        const float turn = -0.3f + 0.006f * static_cast<float>(i);
        const FibreDetail end = fibre_detail(x, 1 - 1e-6f, turn, kNear, kLength_mm);
        const FibreDetail start = fibre_detail(x, 0, turn, kNear, kLength_mm);
        off += glm::length(end.slope - start.slope) > 0.1f;
      }
      EXPECT_LE(off, 3) << yarn.name << ", thread " << thread;
    }
  }
}

TEST(FibreDetail, IsFiniteForAnyYarn) {
  std::mt19937 rng(2);
  std::uniform_real_distribution<float> u(0, 1);
  for (const Yarn& yarn : many_yarns()) {
    const ThreadTexture x = texture_of(yarn);
    for (int i = 0; i < 3000; ++i) {
      const glm::vec2 size = glm::pow(glm::vec2(10), glm::vec2(-8 * u(rng), -8 * u(rng)));
      const FibreDetail d = fibre_detail(x, u(rng), u(rng) - 0.25f, size, kLength_mm);
      ASSERT_TRUE(std::isfinite(d.slope.x + d.slope.y + d.fibre_tan + d.resolved.x + d.resolved.y)) << yarn.name;
      ASSERT_TRUE(d.texel.groove >= 0 && d.texel.groove <= 1 && d.texel.tone > 0) << yarn.name;
      const glm::vec3 v = glm::normalize(glm::vec3(u(rng) - 0.5f, u(rng) - 0.5f, 0.01f + u(rng)));
      const SurfaceFrame frame{glm::vec3(0, 0, 1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0)};
      const glm::vec3 n = thread_formulas::detail_normal(frame, x, d, 1, kLength_mm, v);
      ASSERT_NEAR(glm::length(n), 1, 1e-4f) << yarn.name;
      ASSERT_GT(glm::dot(n, v), 0) << yarn.name;
      const float light = thread_formulas::ply_light(frame, x, d, kLength_mm, -v);
      ASSERT_TRUE(light >= 0 && light <= 1) << yarn.name;
    }
  }
}

// Told apart at sight: wool is untidy and fuzzy, flax lies in bundles, filament is parallel and smooth.
TEST(FibreDetail, FibresDifferAsTheirYarnsDo) {
  const auto of = [](const char* name) {
    for (const Yarn& yarn : yarn_presets())
      if (yarn.name == name) return texture_of(yarn);
    ADD_FAILURE() << name;
    return ThreadTexture{};
  };
  const ThreadTexture cotton = of("Cotton"), linen = of("Linen"), wool = of("Wool"),
                      polyester = of("Polyester filament");
  EXPECT_GT(linen.bundling, 2 * cotton.bundling);
  EXPECT_GT(wool.disorder, cotton.disorder);
  EXPECT_GT(cotton.disorder, 3 * polyester.disorder);
  EXPECT_GT(cotton.convolution, 2 * polyester.convolution);
  EXPECT_GT(wool.hairiness, 10 * polyester.hairiness);
}

}  // namespace
}  // namespace weftlight::cloth
