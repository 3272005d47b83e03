// Light on one fibre: energy, reciprocity, sampling, and rays refracted by Snell's law through a smooth cylinder.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "../statistics.h"
#include "light/formulas.h"

namespace weftlight::light {
namespace {

using formulas::FibreOptics;
using glm::dvec3;
using glm::vec3;

constexpr double kPi = std::numbers::pi;

FibreOptics clear_fibre(float index, float along, float across, float turbidity = 0) {
  return {index, vec3(0), along, across, vec3(0), turbidity};
}

/// At an angle to the fibre and an azimuth around it.
vec3 at(double polar, double azimuth) {
  return {std::cos(polar), std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth)};
}

/// Integral over the sphere by the midpoint rule in both angles.
template <class F>
double over_sphere(F f, int rows = 600, int columns = 360) {
  double sum = 0;
  for (int i = 0; i < rows; ++i) {
    const double polar = kPi * (i + 0.5) / rows;
    double ring = 0;
    for (int k = 0; k < columns; ++k) ring += f(at(polar, 2 * kPi * (k + 0.5) / columns));
    sum += ring * std::sin(polar);
  }
  return sum * kPi / rows * 2 * kPi / columns;
}

double scattered(const FibreOptics& f, double h, vec3 wi, vec3 wo) {
  return static_cast<double>(formulas::fibre_scatter(f, static_cast<float>(h), wi, wo).g);
}

/// The mean over the width of the fibre.
double from_afar(const FibreOptics& f, vec3 wi, vec3 wo) {
  constexpr int kOffsets = 1000;
  double sum = 0;
  for (int i = 0; i < kOffsets; ++i) sum += scattered(f, -1 + 2 * (i + 0.5) / kOffsets, wi, wo);
  return sum / kOffsets;
}

TEST(FibreScatter, AFurnaceIsWhiteForEveryIndexWidthAndDirection) {
  for (const float index : {1.0f, 1.33f, 1.55f, 1.7f, 3.0f})
    for (const float along : {0.05f, 0.15f, 0.4f})
      for (const double polar : {0.05, 0.4, 1.0, kPi / 2, 2.9})
        for (const double h : {-0.98, -0.4, 0.0, 0.7}) {
          const FibreOptics f = clear_fibre(index, along, 0.15f, h > 0 ? 0.4f : 0.0f);
          const double energy = over_sphere([&](vec3 wi) { return scattered(f, h, wi, at(polar, 0.3)); }, 400, 180);
          EXPECT_NEAR(energy, 1, 0.005) << index << ' ' << along << ' ' << polar << ' ' << h;
        }
}

TEST(FibreScatter, DyeTakesLightAndNeverGivesIt) {
  FibreOptics f = clear_fibre(1.55f, 0.1f, 0.2f);
  double before = 1.001;
  for (const float dye : {0.0f, 0.02f, 0.1f, 1.0f, 30.0f}) {
    f.absorption = vec3(dye);
    const double energy = over_sphere([&](vec3 wi) { return scattered(f, 0.3, wi, at(1.2, 0)); }, 300, 180);
    EXPECT_LT(energy, before);
    before = energy;
  }
  // What is left is the reflection at the surface.
  const float cosine = std::sin(1.2f) * std::sqrt(1 - 0.09f);
  EXPECT_NEAR(before, static_cast<double>(formulas::fibre_fresnel(cosine, 1.55f)), 0.002);
}

TEST(FibreScatter, AMetallicFibreReflectsItsColourOnly) {
  FibreOptics f = clear_fibre(1.5f, 0.1f, 0.2f);
  f.metal = {0.9f, 0.7f, 0.3f};
  EXPECT_NEAR(over_sphere([&](vec3 wi) { return scattered(f, 0, wi, at(kPi / 2, 0)); }, 300, 180), 0.7, 0.003);
}

TEST(FibreScatter, FromAfarItIsReciprocal) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<double> u(0, 1);
  int lit = 0;
  for (int k = 0; k < 60; ++k) {
    FibreOptics f = clear_fibre(static_cast<float>(1.2 + 0.6 * u(rng)), static_cast<float>(0.05 + 0.35 * u(rng)),
                                static_cast<float>(0.1 + 0.4 * u(rng)), static_cast<float>(0.5 * u(rng)));
    f.absorption = vec3(static_cast<float>(0.5 * u(rng)));
    // Near each other's cones, where there is light.
    const double polar = 0.1 + 2.9 * u(rng), other = std::clamp(kPi - polar + 0.4 * u(rng) - 0.2, 0.05, 3.0);
    const vec3 a = at(polar, 6 * u(rng)), b = at(other, 6 * u(rng));
    const double there = from_afar(f, a, b) / std::sin(polar), back = from_afar(f, b, a) / std::sin(other);
    EXPECT_NEAR(there, back, 0.002 * (there + back) + 1e-6);
    lit += there > 0.01;
  }
  EXPECT_GT(lit, 30);
}

TEST(FibreScatter, AllLightThatAFibreMeetsLeavesIt) {
  // Over the directions that it leaves to: a fibre shows its width times the sine of the angle to it.
  const FibreOptics f = clear_fibre(1.55f, 0.2f, 0.3f);
  for (const double polar : {0.3, 1.0, kPi / 2}) {
    const vec3 wi = at(polar, 0);
    double sum = 0;
    constexpr int kOffsets = 40;
    for (int i = 0; i < kOffsets; ++i) {
      const double h = -1 + 2 * (i + 0.5) / kOffsets;
      sum += over_sphere(
          [&](vec3 wo) { return scattered(f, h, wi, wo) * std::sqrt(std::max(1 - double{wo.x} * double{wo.x}, 0.0)); },
          200, 90);
    }
    EXPECT_NEAR(sum / kOffsets / std::sin(polar), 1, 0.005) << polar;
  }
}

TEST(FibreScatter, SamplesHaveTheDensityThatIsStated) {
  constexpr int kRows = 24, kColumns = 24, kDraws = 200'000, kFine = 24;
  Verdict verdict;
  std::mt19937 rng(11);
  std::uniform_real_distribution<float> u(0, 1);
  for (const double polar : {0.1, 0.7, 1.5, 2.5})
    for (const float h : {-0.9f, 0.2f}) {
      FibreOptics f = clear_fibre(1.5f, 0.25f, 0.3f);
      f.absorption = vec3(0.1f);
      const vec3 wo = at(polar, 0.4);
      std::vector<double> counted(kRows * kColumns + 1), expected(kRows * kColumns + 1);
      for (int i = 0; i < kDraws; ++i) {
        const float a = u(rng), b = u(rng), c = u(rng);
        const vec3 wi = formulas::fibre_sample(f, h, wo, {a, b, c, u(rng)});
        if (wi == vec3(0)) {
          ++counted.back();
          continue;
        }
        ASSERT_NEAR(glm::length(wi), 1, 1e-5);
        const double row = std::acos(std::clamp(double{wi.x}, -1.0, 1.0)) / kPi * kRows;
        const double column = (std::atan2(double{wi.z}, double{wi.y}) / (2 * kPi) + 0.5) * kColumns;
        ++counted[static_cast<size_t>(std::clamp(row, 0.0, kRows - 1.0)) * kColumns +
                  static_cast<size_t>(std::clamp(column, 0.0, kColumns - 1.0))];
      }
      double inside = 0;
      for (int r = 0; r < kRows * kFine; ++r)
        for (int c = 0; c < kColumns * kFine; ++c) {
          const double angle = kPi * (r + 0.5) / (kRows * kFine),
                       azimuth = 2 * kPi * ((c + 0.5) / (kColumns * kFine) - 0.5);
          const double mass = static_cast<double>(formulas::fibre_density(f, h, at(angle, azimuth), wo)) *
                              std::sin(angle) * kPi / (kRows * kFine) * 2 * kPi / (kColumns * kFine);
          expected[static_cast<size_t>(r / kFine * kColumns + c / kFine)] += mass;
          inside += mass;
        }
      EXPECT_NEAR(inside, 1, 0.002);
      expected.back() = std::max(1 - inside, 1e-9);
      verdict.add(chi_square(counted, expected));
    }
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed();
}

TEST(FibreScatter, SamplesCarryTheEnergyWithBoundedWeights) {
  std::mt19937 rng(12);
  std::uniform_real_distribution<float> u(0, 1);
  for (const float along : {0.05f, 0.2f, 0.4f})
    for (const double polar : {0.05, 0.6, 1.57, 2.2, 3.1}) {
      const FibreOptics f = clear_fibre(1.6f, along, 0.2f);
      const vec3 wo = at(polar, 1);
      double sum = 0;
      constexpr int kDraws = 40'000;
      for (int i = 0; i < kDraws; ++i) {
        const float h = 2 * u(rng) - 1, a = u(rng), b = u(rng), c = u(rng);
        const vec3 wi = formulas::fibre_sample(f, h, wo, {a, b, c, u(rng)});
        if (wi == vec3(0)) continue;
        const double weight =
            scattered(f, double{h}, wi, wo) / static_cast<double>(formulas::fibre_density(f, h, wi, wo));
        EXPECT_LT(weight, 2.0);
        sum += weight;
      }
      EXPECT_NEAR(sum / kDraws, 1, 0.015) << along << ' ' << polar;
    }
}

/// A ray through a smooth cylinder by Snell's law alone: where it leaves, after how long inside.
struct Refracted {
  dvec3 reflected, through, inner;
  double chord = 0;
};

dvec3 outward(dvec3 p) { return glm::normalize(dvec3(0, p.y, p.z)); }

/// To the other side of the cylinder.
double length_inside(dvec3 p, dvec3 d) { return -2 * (p.y * d.y + p.z * d.z) / (d.y * d.y + d.z * d.z); }

Refracted refracted(double index, double h, dvec3 wo) {
  const dvec3 o = outward(wo), b = glm::cross(dvec3(1, 0, 0), o);
  dvec3 p = o * std::sqrt(1 - h * h) + b * h;
  Refracted r;
  r.reflected = glm::reflect(-wo, outward(p));
  dvec3 d = glm::refract(-wo, outward(p), 1 / index);
  r.chord = length_inside(p, d);
  p += d * r.chord;
  r.through = glm::refract(d, -outward(p), index);
  d = glm::reflect(d, -outward(p));
  p += d * length_inside(p, d);
  r.inner = glm::refract(d, -outward(p), index);
  return r;
}

TEST(FibreScatter, LobesLieWhereSnellsLawSendsTheLight) {
  for (const double index : {1.2, 1.55, 2.0})
    for (const double polar : {0.5, 1.1, kPi / 2, 2.3})
      for (const double h : {-0.8, -0.3, 0.05, 0.6}) {
        const vec3 wo = at(polar, 0.7);
        const Refracted r = refracted(index, h, dvec3(wo));
        const FibreOptics f = clear_fibre(static_cast<float>(index), 0.05f, 0.05f);
        const dvec3 expected[3] = {r.reflected, r.through, r.inner};
        for (int part = 0; part < 3; ++part) {
          const dvec3 d = glm::normalize(expected[part]);
          EXPECT_NEAR(d.x, -std::cos(polar), 1e-6) << "on the cone";
          const glm::vec2 angle =
              formulas::fibre_half_difference(formulas::fibre_polar(vec3(d)), formulas::fibre_polar(wo));
          const double off =
              static_cast<double>(formulas::fibre_turn(formulas::fibre_azimuth(f, static_cast<float>(h), angle, part) -
                                                       formulas::fibre_azimuth_between(vec3(d), wo)));
          EXPECT_NEAR(off, 0, 2e-3) << index << ' ' << polar << ' ' << h << ' ' << part;
        }
        FibreOptics dyed = f;
        dyed.absorption = vec3(0.4f);
        const glm::vec2 angle =
            formulas::fibre_half_difference(static_cast<float>(kPi - polar), static_cast<float>(polar));
        const double through = static_cast<double>(formulas::fibre_parts(dyed, static_cast<float>(h), angle).through.g /
                                                   formulas::fibre_parts(f, static_cast<float>(h), angle).through.g);
        EXPECT_NEAR(through, std::exp(-0.4 * r.chord), 1e-3);
      }
}

TEST(FibreScatter, ATurbidFibreScattersMoreToTheSide) {
  const vec3 from = at(kPi / 2, 0), side = at(kPi / 2, kPi / 2);
  const FibreOptics clear = clear_fibre(1.55f, 0.1f, 0.1f), turbid = clear_fibre(1.55f, 0.1f, 0.1f, 0.5f);
  EXPECT_GT(scattered(turbid, 0, from, side), 10 * scattered(clear, 0, from, side));
  EXPECT_NEAR(scattered(turbid, 0, from, at(kPi / 2, kPi)), 0.5 * scattered(clear, 0, from, at(kPi / 2, kPi)),
              0.1 * scattered(clear, 0, from, at(kPi / 2, kPi)));
}

}  // namespace
}  // namespace weftlight::light
