// Lobes of a yarn: energy, reciprocity, edge cases.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "../figures.h"
#include "design/yarn_fields.h"
#include "light/tables.h"
#include "light/yarn_lobes.h"
#include "sampling.h"

namespace weftlight::light {

using design::Lobes, design::clamped;

namespace {

using formulas::YarnLobes;

YarnLobes white_mirror(float along, float across) {
  YarnLobes y;
  y.slope_cov = {along * along, 0, across * across};
  y.f0 = glm::vec3(1);
  y.f90 = 1;
  y.body = y.through = glm::vec3(0);
  y.fuzz_colour = glm::vec3(1);
  y.fuzz = 0;
  y.fuzz_depth = 0.25f;
  y.fibre_layers = 1;
  return y;
}

YarnLobes white_cotton(float along, float across) {
  YarnLobes y = white_mirror(along, across);
  y.f0 = glm::vec3(0.044f);
  y.body = glm::vec3(1);
  return y;
}

struct Range {
  double low = 9, high = -9;
  void add(double v) { low = std::min(low, v), high = std::max(high, v); }
};

Range furnace_range(const YarnLobes& y) {
  Range r;
  for (const float t : {0.0f, 30.0f, 60.0f, 75.0f, 85.0f})
    for (const float p : {0.0f, 30.0f, 60.0f, 90.0f}) r.add(slope_furnace(y, at_degrees(t, p), 100).x);
  return r;
}

TEST(Furnace, RoundLobesReturnAllLight) {
  for (const float s : {0.0f, 0.02f, 0.1f, 0.22f, 0.3f, 0.45f, 0.7f, 1.0f, 1.6f, 2.4f, 3.5f}) {
    const Range mirror = furnace_range(white_mirror(s, s)), cotton = furnace_range(white_cotton(s, s));
    // Beyond an RMS slope of 2 light leaves only among facets steeper than 60 degrees.
    const double tolerance = s <= 2 ? 0.01 : 0.04;
    EXPECT_NEAR(mirror.low, 1, tolerance) << s;
    EXPECT_NEAR(mirror.high, 1, tolerance) << s;
    EXPECT_NEAR(cotton.low, 1, 0.01) << s;
    EXPECT_NEAR(cotton.high, 1, 0.01) << s;
  }
}

TEST(Furnace, YarnsReturnAllLight) {
  // Dielectric lobes as yarns have them, long and turned ones too.
  for (const float a : {0.02f, 0.1f, 0.25f, 0.6f, 1.5f, 4.0f})
    for (const float b : {0.02f, 0.1f, 0.45f, 1.2f, 3.0f}) {
      const Range r = furnace_range(white_cotton(a, b));
      EXPECT_NEAR(r.low, 1, 0.01) << a << " " << b;
      EXPECT_NEAR(r.high, 1, 0.01) << a << " " << b;
    }
}

// Fibre layers: their reflectance is non-linear in that of one layer, so means over facets are fitted, not stored.
TEST(Furnace, PilesOfFibresReturnAllLight) {
  for (const float layers : {2.0f, 4.0f, 8.0f, 16.0f}) {
    const double tolerance = layers <= 4 ? 0.02 : layers <= 8 ? 0.035 : 0.05;
    double worst = 0;
    for (const float width : {0.05f, 0.2f, 0.45f, 0.8f}) {
      Lobes lobes;
      lobes.layers = layers, lobes.inner = 0.2f, lobes.along_width = 0.6f * width, lobes.across_width = width;
      lobes.fuzz = lobes.transmission = 0, lobes.body = 1;
      const Range r = furnace_range(yarn_lobes(lobes, {1, 1, 1}));
      worst = std::max({worst, 1 - r.low, r.high - 1});
      EXPECT_GT(r.low, 1 - tolerance) << layers << ' ' << width;
      EXPECT_LT(r.high, 1 + tolerance) << layers << ' ' << width;
    }
    figure("furnace of " + text(layers) + " layers, largest error", tolerance, worst);
  }
}

TEST(Furnace, LongMirrorsStayWithinTheTableError) {
  // With F = 1 the whole error of the albedo table shows. It is largest between the axes, since the table interpolates
  // linearly between independent and correlated slopes.
  for (const float a : {0.05f, 0.25f, 0.8f, 2.0f})
    for (const float b : {0.1f, 0.5f, 1.3f, 3.0f}) {
      const Range r = furnace_range(white_mirror(a, b));
      EXPECT_NEAR(r.low, 1, 0.035) << a << " " << b;
      EXPECT_NEAR(r.high, 1, 0.035) << a << " " << b;
    }
}

TEST(Furnace, SingleScatteringAloneLosesLight) {
  // Without the compensation a rough white lobe turns dark.
  const YarnLobes y = white_mirror(1, 1);
  const glm::vec3 wo = at_degrees(60, 20);
  const double once = scattered_once(y, wo);
  figure("albedo of single scattering alone", once, 1);
  EXPECT_NEAR(once, 1 - static_cast<double>(formulas::lobe_side(y, formulas::lobe_shared(y), wo).loss), 0.01);
}

TEST(Furnace, FuzzOverWhiteBodyReturnsAllLight) {
  for (const float depth : {0.01f, 0.25f, 1.0f}) {
    YarnLobes y = white_mirror(0.3f, 0.3f);
    y.f90 = 0;
    y.f0 = glm::vec3(0);
    y.body = glm::vec3(1);
    y.fuzz = 1;
    y.fuzz_depth = depth;
    for (const float t : {0.0f, 45.0f, 80.0f, 89.0f}) {
      const glm::vec3 wo = at_degrees(t, 0);
      EXPECT_NEAR(furnace([&](glm::vec3 wi) { return formulas::yarn_reflect(y, wi, wo); }, 400, 4).x, 1, 0.015)
          << depth << " " << t;
    }
  }
}

TEST(Energy, NothingGivesMoreThanItGets) {
  std::mt19937 rng(7);
  for (int k = 0; k < 60; ++k) {
    const YarnLobes y = random_lobes(rng);
    const glm::vec3 wo = random_upper(rng);
    const glm::dvec3 back = slope_furnace(y, wo, 60);
    const glm::dvec3 through = furnace(
        [&](glm::vec3 wi) {
          return formulas::yarn_transmit(y, {wi.x, wi.y, -wi.z}, wo);
        },
        60, 12);
    for (int c = 0; c < 3; ++c) EXPECT_LE(back[c] + through[c], 1.02) << k;
  }
}

TEST(Energy, AlbedoOfAUniformSkyIsTheIntegral) {
  std::mt19937 rng(11);
  for (int k = 0; k < 20; ++k) {
    YarnLobes y = random_lobes(rng);
    y.fuzz *= 0.3f;
    const glm::vec3 wo = random_upper(rng);
    const glm::dvec3 sum = slope_furnace(y, wo, 80);
    const glm::vec3 closed = formulas::yarn_albedo(y, wo);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(closed[c]), sum[c], 0.04) << k;
  }
}

TEST(Reciprocity, LightAndViewChangePlaces) {
  std::mt19937 rng(3);
  for (int k = 0; k < 20000; ++k) {
    const YarnLobes y = random_lobes(rng);
    const glm::vec3 wi = random_upper(rng), wo = random_upper(rng);
    const glm::vec3 a = formulas::yarn_reflect(y, wi, wo), b = formulas::yarn_reflect(y, wo, wi);
    const glm::vec3 below(wi.x, wi.y, -wi.z);
    const glm::vec3 c = formulas::yarn_transmit(y, below, wo);
    // Turned over: the same thread seen from its other side.
    const glm::vec3 d = formulas::yarn_transmit(y, {wo.x, wo.y, -wo.z}, wi);
    for (int i = 0; i < 3; ++i) {
      ASSERT_NEAR(a[i], b[i], 1e-5f * (1 + a[i])) << k;
      ASSERT_NEAR(c[i], d[i], 1e-5f * (1 + c[i])) << k;
    }
  }
}

TEST(Numbers, NeitherNaNNorNegativeNorBlack) {
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> u(0, 1);
  const float roughness[] = {0, 1e-6f, 1e-3f, 0.3f, 1, 30, 1e3f, 1e6f, 1e18f};
  const float cosines[] = {0, 1e-30f, 1e-7f, 1.745e-3f, 0.1f, 0.9999999f, 1};
  for (const float a : roughness)
    for (const float b : roughness)
      for (const float zi : cosines)
        for (const float zo : cosines)
          for (int k = 0; k < 4; ++k) {
            YarnLobes y = random_lobes(rng);
            y.f90 = 1;
            y.f0 = glm::vec3(0.5f);
            y.slope_cov = {a * a, k == 1 ? a * b : (k == 2 ? -a * b : 0.0f), b * b};
            const float phi = k == 0 ? 0.0f : 6.2831853f * u(rng);
            const glm::vec3 wi = direction(zi, k == 3 ? phi + 3.1415927f : phi), wo = direction(zo, phi);
            const glm::vec3 f = formulas::yarn_reflect(y, wi, wo);
            const glm::vec3 t = formulas::yarn_transmit(y, {wi.x, wi.y, -wi.z}, wo);
            const glm::vec3 half = formulas::half_safe(f * wi.z);
            for (int c = 0; c < 3; ++c) {
              ASSERT_TRUE(std::isfinite(f[c]) && f[c] >= 0) << a << " " << b << " " << zi << " " << zo << " " << f[c];
              ASSERT_TRUE(std::isfinite(t[c]) && t[c] >= 0);
              ASSERT_LE(half[c], 65504.0f);
            }
            if (y.fuzz == 0 && zi > 0.05f && zo > 0.05f && a == b && a >= 1) {
              ASSERT_GT(f.x, 0.01f) << a;
            }
          }
}

TEST(Numbers, DirectionsBelowTheHorizonGiveNothing) {
  const YarnLobes y = white_cotton(0.3f, 0.3f);
  EXPECT_EQ(formulas::yarn_reflect(y, at_degrees(95, 0), at_degrees(10, 0)), glm::vec3(0));
  EXPECT_EQ(formulas::yarn_reflect(y, at_degrees(10, 0), at_degrees(95, 0)), glm::vec3(0));
  EXPECT_EQ(formulas::yarn_transmit(y, at_degrees(10, 0), at_degrees(10, 0)), glm::vec3(0));
}

TEST(Facets, SlopesIntegrateToOne) {
  // Integral of D(h) h.z over the hemisphere, from the BRDF's own factors: f = D V with F = 1.
  for (const float a : {0.1f, 0.4f, 1.0f}) {
    const YarnLobes y = white_mirror(a, 0.5f * a + 0.05f);
    const auto s = formulas::lobe_shared(y);
    double sum = 0;
    const int n = 400;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const double z = (i + 0.5) / n;
        const glm::vec3 h = direction(static_cast<float>(z), static_cast<float>((j + 0.5) / n * 2 * M_PI));
        const auto side = formulas::lobe_side(y, s, h);
        const double v = 0.25 / static_cast<double>(2 * side.area * side.mu - side.mu * side.mu);
        sum += static_cast<double>(formulas::lobe_specular(y, s, side, side, h, h).x) / v * z * 2 * M_PI / n / n;
      }
    EXPECT_NEAR(sum, 1, 0.005) << a;
  }
}

TEST(Facets, ProjectedAreaIsTheMeanOfFacingSlopes) {
  for (const float mu : {0.0f, 0.01f, 0.3f, 1.0f})
    for (const float sigma : {0.0f, 0.05f, 0.5f, 5.0f}) {
      double sum = 0;
      for (int i = 0; i < 20000; ++i) {
        const double z = -8 + 16 * (i + 0.5) / 20000;
        sum += std::max(0.0, static_cast<double>(mu) + static_cast<double>(sigma) * z) * std::exp(-0.5 * z * z) *
               (16.0 / 20000 / std::sqrt(2 * M_PI));
      }
      EXPECT_NEAR(static_cast<double>(formulas::gaussian_area(mu, sigma)), sum, 1e-5 * (1 + sum));
    }
}

TEST(Moments, OneWideLobeStandsForManyTiltedOnes) {
  // A surface whose slopes are Gaussian about a tilt: the mean of its lobes, each in its own frame, against
  // one lobe in the frame of the mean normal, widened by the slopes' covariance.
  YarnLobes y = white_mirror(0.25f, 0.35f);
  y.f0 = glm::vec3(0.04f);
  const glm::vec2 tilt(0.15f, -0.1f);
  const float dx = 0.12f, dy = 0.18f;
  const glm::vec3 fibre(1, 0, 0);
  const glm::vec3 wo = at_degrees(30, 40);
  double off = 0, all = 0;
  for (const float t : {10.0f, 30.0f, 50.0f})
    for (int p = 0; p < 360; p += 30) {
      const glm::vec3 wi = at_degrees(t, static_cast<float>(p));
      double sum = 0, weights = 0;
      for (int i = -6; i <= 6; ++i)
        for (int j = -6; j <= 6; ++j) {
          const float u = static_cast<float>(i) / 2, v = static_cast<float>(j) / 2;
          const glm::vec3 slope(tilt.x + dx * u, tilt.y + dy * v, 1);
          const auto frame = formulas::lobe_frame(glm::normalize(slope), fibre);
          const glm::vec3 li = formulas::lobe_local(frame, wi), lo = formulas::lobe_local(frame, wo);
          // Light and view by the projected area of this part of the surface.
          const double w =
              std::exp(-0.5 * static_cast<double>(u * u + v * v)) * static_cast<double>(glm::length(slope));
          sum += w *
                 static_cast<double>(formulas::yarn_reflect(y, li, lo).x * std::max(li.z, 0.0f) * std::max(lo.z, 0.0f));
          weights += w * static_cast<double>(std::max(lo.z, 0.0f));
        }
      const auto frame = formulas::lobe_frame(glm::normalize(glm::vec3(tilt, 1)), fibre);
      const YarnLobes wide = formulas::yarn_widen(y, formulas::lobe_covariance(frame, {dx * dx, 0, dy * dy}));
      const glm::vec3 li = formulas::lobe_local(frame, wi), lo = formulas::lobe_local(frame, wo);
      const double one = static_cast<double>(formulas::yarn_reflect(wide, li, lo).x * li.z);
      off += (one - sum / weights) * (one - sum / weights);
      all += sum / weights * sum / weights;
    }
  EXPECT_LT(std::sqrt(off / all), 0.10);
}

TEST(Frame, IsOrthonormalEvenWhereTheFibreStandsUp) {
  for (const glm::vec3 n : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::normalize(glm::vec3(1, -2, 0.1f))})
    for (const glm::vec3 fibre : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0)}) {
      const auto f = formulas::lobe_frame(n, fibre);
      EXPECT_NEAR(glm::length(f.t), 1, 1e-5f);
      EXPECT_NEAR(glm::length(f.b), 1, 1e-5f);
      EXPECT_NEAR(glm::dot(f.t, f.n), 0, 1e-5f);
    }
}

TEST(YarnLobes, KeepWithinTheirRanges) {
  Lobes wild;
  wild.ior = 1e9f;
  wild.along_width = -1;
  wild.across_width = std::numeric_limits<float>::quiet_NaN();
  wild.body = 5;
  wild.transmission = 2;
  wild.fuzz = -3;
  const YarnLobes y = yarn_lobes(wild, {2, -1, std::numeric_limits<float>::infinity()});
  EXPECT_LE(y.body.x + y.through.x, 1);
  EXPECT_EQ(y.fuzz, 0);
  const glm::vec3 f = formulas::yarn_reflect(y, at_degrees(20, 0), at_degrees(20, 180));
  EXPECT_TRUE(std::isfinite(f.x) && std::isfinite(f.z) && f.x >= 0);
}

// A width that the file would clamp to 4 was once drawn unclamped: the picture changed when the design was saved.
TEST(YarnLobes, AreHeldWhereTheFileHoldsThem) {
  Lobes wide;
  wide.along_width = 900;
  EXPECT_EQ(yarn_lobes(wide, {1, 1, 1}).slope_cov, yarn_lobes(clamped(wide), {1, 1, 1}).slope_cov);
}

// n r / (1 + (n - 1) r), at any angle that r stands for.
TEST(YarnLobes, LayersMirrorAsAPileOfPlates) {
  Lobes lobes;
  const float once = fibre_reflectance(lobes).clear;
  EXPECT_NEAR(once, 0.0439f, 1e-4f);
  for (const float n : {1.0f, 2.0f, 5.0f, 16.0f}) {
    lobes.layers = n;
    const YarnLobes y = yarn_lobes(lobes, {0, 0, 0});
    for (const float cosine : {1.0f, 0.7f, 0.3f, 0.05f}) {
      const float one = once + (1 - once) * std::pow(1 - cosine, 5.0f);
      const float layered = y.f0.x + (y.f90 - y.f0.x) * formulas::layered_grazing(y.fibre_layers, 1 - cosine);
      EXPECT_NEAR(layered, n * one / (1 + (n - 1) * one), 1e-5f) << n << ' ' << cosine;
    }
  }
}

TEST(YarnLobes, WhatWentThroughTheFibresTakesTheirColour) {
  Lobes lobes;
  lobes.layers = 3, lobes.inner = 0.25f;
  const float clear = fibre_reflectance(lobes).clear;
  const YarnLobes y = yarn_lobes(lobes, {0.8f, 0.1f, 0});
  EXPECT_NEAR(y.f0.x, 0.75f * clear + 0.25f * 0.8f, 1e-6f);
  EXPECT_NEAR(y.f0.z, 0.75f * clear, 1e-6f);
}

TEST(YarnLobes, AShorterWayThroughTheDyeIsPaler) {
  Lobes lobes;
  lobes.inner = 0.5f;
  const float clear = 0.5f * fibre_reflectance(lobes).clear;
  for (const float depth : {0.5f, 1.0f, 2.0f}) {
    lobes.inner_depth = depth;
    const YarnLobes y = yarn_lobes(lobes, {0.8f, 0.1f, 1});
    EXPECT_NEAR(y.f0.x, clear + 0.5f * std::pow(0.8f, depth), 1e-6f);
    EXPECT_NEAR(y.f0.y, clear + 0.5f * std::pow(0.1f, depth), 1e-6f);
    EXPECT_NEAR(y.f0.z, clear + 0.5f, 1e-6f) << "undyed stays white";
  }
  lobes.metallic = true;
  EXPECT_FLOAT_EQ(yarn_lobes(lobes, {1, 0.7f, 0.3f}).f0.y, 0.7f) << "a metal has no inside";
}

TEST(YarnLobes, MetalHasTheThreadsColourAndNoBody) {
  Lobes gold;
  gold.metallic = true;
  const YarnLobes y = yarn_lobes(gold, {1, 0.7f, 0.3f});
  EXPECT_EQ(y.body, glm::vec3(0));
  EXPECT_FLOAT_EQ(y.f0.y, 0.7f);
}

TEST(Tables, SameBitsWhateverTheThreads) {
  EXPECT_EQ(make_light_tables(1).albedo.values, make_light_tables(3).albedo.values);
}

TEST(Exponential, IsExactToFloat) {
  for (float x = -86; x < 88; x += 0.01137f)
    ASSERT_NEAR(static_cast<double>(formulas::exp(x)) / std::exp(static_cast<double>(x)), 1, 4e-7) << x;
}

TEST(Logarithm, IsExactToFloat) {
  for (float x = 1e-30f; x < 1e30f; x *= 1.0137f)
    ASSERT_NEAR(static_cast<double>(formulas::log_of_normal(x)), std::log(static_cast<double>(x)),
                1e-7 + 2e-7 * std::abs(std::log(static_cast<double>(x))))
        << x;
  EXPECT_EQ(formulas::log_of_normal(1.0f), 0.0f);
}

TEST(Power, IsExactToAFewTimesTheResolutionOfFloat) {
  for (float x = 0.0078125f; x <= 1; x += 0.00137f) {
    for (const float exponent : {0.5f, 1.0f, 2.0f, 12.5f}) {
      const double exact = std::pow(static_cast<double>(x), static_cast<double>(exponent));
      ASSERT_NEAR(static_cast<double>(formulas::pow(x, exponent)) / exact, 1, 5e-7 + 3e-7 * std::abs(std::log(exact)))
          << x << " to the " << exponent;
    }
  }
}

}  // namespace
}  // namespace weftlight::light
