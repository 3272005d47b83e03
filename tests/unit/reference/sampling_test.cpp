// Chi-square tests of what the tracer draws at random. Each test fails with probability kFalseAlarm for a sound
// sampler with a new seed.

#include "reference/sampling.h"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "../statistics.h"

namespace weftlight::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kDraws = 200'000, kSide = 16;

/// Counts of points of the unit square in kSide x kSide cells of equal area.
std::vector<double> counts_of(const std::function<glm::dvec2(int)>& point, int draws = kDraws) {
  std::vector<double> counts(kSide * kSide);
  for (int i = 0; i < draws; ++i) {
    const glm::dvec2 p = point(i);
    const auto cell = [](double v) { return static_cast<size_t>(std::clamp(v * kSide, 0.0, kSide - 1.0)); };
    ++counts[cell(p.y) * kSide + cell(p.x)];
  }
  return counts;
}

double uniform(const std::vector<double>& counts) { return chi_square(counts, std::vector<double>(counts.size(), 1)); }

/// Azimuth around an axis, 0..1, by a frame that is not the sampler's.
double azimuth(const glm::dvec3& axis, const glm::dvec3& d) {
  const glm::dvec3 least = std::abs(axis.z) < 0.6 ? glm::dvec3(0, 0, 1) : glm::dvec3(0.8, 0.6, 0);
  const glm::dvec3 a = glm::normalize(least - axis * glm::dot(axis, least)), b = glm::cross(axis, a);
  return 0.5 + std::atan2(glm::dot(b, d), glm::dot(a, d)) / (2 * kPi);
}

const glm::vec3 kAxes[] = {{0, 0, 1},
                           {0, 0, -1},
                           {1, 0, 0},
                           glm::normalize(glm::vec3(0.7f, 0.69f, 0.1f)),
                           glm::normalize(glm::vec3(-0.3f, 0.8f, 0.4f))};

TEST(Sampling, RandomNumbersAreUniformWithinAndAcrossStreams) {
  Verdict verdict;
  for (const uint64_t seed : {uint64_t{0}, uint64_t{1}, uint64_t{0x9E3779B97F4A7C15u}}) {
    RandomStream random(seed);
    verdict.add(uniform(counts_of([&](int) {
      const float u = random.next();
      return glm::dvec2(u, random.next());
    })));
  }
  // Pixels have seeds of their own: the first numbers of neighbouring streams, as picture.cpp seeds them.
  for (const uint64_t step : {uint64_t{1}, uint64_t{0x9E3779B97F4A7C15u}}) {
    verdict.add(uniform(counts_of([&](int i) {
      RandomStream random(static_cast<uint64_t>(i) * step + 1);
      const float u = random.next();
      return glm::dvec2(u, random.next());
    })));
    verdict.add(uniform(counts_of([&](int i) {
      RandomStream one(static_cast<uint64_t>(i) * step + 1), next(static_cast<uint64_t>(i + 1) * step + 1);
      return glm::dvec2(one.next(), next.next());
    })));
  }
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed();
}

TEST(Sampling, HemispheresAreCosineWeighted) {
  Verdict verdict;
  for (const glm::vec3& axis : kAxes) {
    RandomStream random(17);
    const auto cells = counts_of([&](int) {
      const glm::dvec3 d = cosine_direction(axis, random);
      EXPECT_NEAR(glm::length(d), 1, 1e-5);
      const double z = glm::dot(d, glm::dvec3(axis));
      return glm::dvec2(z * z, azimuth(axis, d));  // both uniform where the density is the cosine
    });
    verdict.add(uniform(cells));
  }
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed();
}

TEST(Sampling, DiscsOfLightsAreUniformBySolidAngle) {
  Verdict verdict;
  for (const glm::vec3& axis : kAxes)
    for (const float radius : {0.1f, 0.5f, 1.5f}) {
      RandomStream random(23);
      verdict.add(uniform(counts_of([&](int) {
        const glm::dvec3 d = in_disc(axis, radius, random);
        const double half = std::asin(0.5 * glm::length(d - glm::dvec3(axis))), s = std::sin(half),
                     most = std::sin(0.5 * static_cast<double>(radius));
        EXPECT_LE(s, most * 1.001);
        return glm::dvec2(s * s / (most * most), azimuth(axis, d));
      })));
    }
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed();
  RandomStream random(1);
  EXPECT_EQ(in_disc(kAxes[4], 0, random), kAxes[4]) << "a point of light";
}

TEST(Sampling, SamplesOfAPixelCoverItEvenly) {
  // A sequence of low discrepancy is more even than chance: by chi-square, and for the samples of one pixel alone.
  RandomStream random(29);
  Verdict verdict;
  for (const int k : {0, 1, 7, 63, 4095})
    verdict.add(uniform(counts_of([&](int) {
      const float u = random.next();
      return glm::dvec2(pixel_sample(k, {u, random.next()}));
    })));
  EXPECT_TRUE(verdict.holds()) << "over pixels: " << verdict.least() << " is less than " << verdict.needed();
  const auto one = counts_of([&](int k) { return glm::dvec2(pixel_sample(k, {0.3f, 0.6f})); }, 4096);
  const auto [least, most] = std::minmax_element(one.begin(), one.end());
  EXPECT_GE(*least, 13) << "of 16 in each cell";
  EXPECT_LE(*most, 19);
}

TEST(Sampling, TheTestsSeeAWrongDensity) {
  RandomStream random(31);
  // Uniform by solid angle where the cosine belongs, and a disc uniform by angle.
  EXPECT_LT(uniform(counts_of([&](int) {
              const double z = static_cast<double>(random.next());
              return glm::dvec2(z * z, static_cast<double>(random.next()));
            })),
            1e-12);
  // One in a hundred of the numbers is another than it should be.
  EXPECT_LT(uniform(counts_of([&](int) {
              const float u = random.next();
              return glm::dvec2(u < 0.01f ? 0.5f : u, random.next());
            })),
            1e-6);
  EXPECT_NEAR(chi_square({12, 8, 10, 14, 6}, {10, 10, 10, 10, 10}), 0.4060, 1e-3) << "4 degrees of freedom, 4.0";
  EXPECT_EQ(chi_square({10, 10, 1}, {10, 10, 0}), 0) << "where nothing can be";
  EXPECT_NEAR(z_tail(1.959964), 0.05, 1e-6);
  EXPECT_NEAR(sidak(10), 0.001005, 1e-6);
}

}  // namespace
}  // namespace weftlight::reference
