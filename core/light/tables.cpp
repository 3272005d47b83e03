// Directional and mean albedos of the lobes by quadrature.
// Based on: Heitz 2014, "Understanding the masking-shadowing function", for the integral over slopes;
//   Koenderink, Pont 2003, "The secret of velvety skin", for the fuzz.

#include "light/tables.h"

#include <algorithm>
#include <cmath>

#include "light/formulas.h"
#include "light/parallel.h"

namespace weftlight {
namespace {

constexpr int kOpenings = 16, kSpreads = 16;   // entries of the albedo table
constexpr int kFuzzOpenings = 32, kFuzzDepths = 16;
constexpr float kWidestSlope = 1.0e3f;         // stands for infinity: the albedo no longer changes
constexpr float kLeastSlope = 5.0e-3f;
constexpr float kGaussianReach = 4.25f;        // deviations; beyond lie 2e-5 of the facets
constexpr int kAlongNodes = 24, kAcrossNodes = 12;

float coordinate(int i, int n) { return static_cast<float>(i) / static_cast<float>(n - 1); }

float slope_of(float coordinate) {
  return std::clamp(coordinate / std::max(1.0f - coordinate, 1.0e-6f), kLeastSlope, kWidestSlope);
}

glm::vec2 lerp(const glm::vec2& a, const glm::vec2& b, float t) { return a + (b - a) * t; }

struct Cell {
  int i;
  float t;
};
Cell cell_of(float coordinate, int n) {
  const float x = std::clamp(coordinate, 0.0f, 1.0f) * static_cast<float>(n - 1);
  const int i = std::min(static_cast<int>(x), n - 2);
  return {i, x - static_cast<float>(i)};
}

glm::vec2 pair_at(const Table& t, int x, int y, int z) {
  const float* p = t.at(x, y, z);
  return {p[0], p[1]};
}

glm::vec2 mix_plane(const Table& t, Cell x, Cell y, int z) {
  return lerp(lerp(pair_at(t, x.i, y.i, z), pair_at(t, x.i + 1, y.i, z), x.t),
              lerp(pair_at(t, x.i, y.i + 1, z), pair_at(t, x.i + 1, y.i + 1, z), x.t), y.t);
}

glm::vec2 albedo_at(const Table& t, float opening, float along, float across) {
  const Cell x = cell_of(opening, t.nx), y = cell_of(along, t.ny), z = cell_of(across, t.nz);
  return lerp(mix_plane(t, x, y, z.i), mix_plane(t, x, y, z.i + 1), z.t);
}

/// Albedo of single scattering with F = 1, and with F = (1 - wi.h)^5, seen along (sine, 0, mu).
/// Integral over the slopes s of the facets: P(s) (wo.(s,1))+ mu_i / (A_i mu_o + A_o mu_i - mu_i mu_o),
/// A the projected areas: the reflection of wo about each facet, with the measure turned to slopes.
glm::vec2 facet_albedo(float opening, float slope_along, float slope_across) {
  const float nu = opening / std::max(1.0f - opening, 1.0e-6f);  // cosine over deviation
  const float cotangent = nu * slope_along;
  const float sine = 1.0f / std::sqrt(1.0f + cotangent * cotangent);
  const float mu = std::max(cotangent * sine, 1.0e-6f);
  const float area = formulas::gaussian_area(mu, slope_along * sine);
  const float first = std::max(-nu, -kGaussianReach);  // facets below turn away from wo
  const float step_a = (kGaussianReach - first) / kAlongNodes, step_b = kGaussianReach / kAcrossNodes;
  glm::vec2 sum(0.0f);
  float weights = 0.0f;  // of the whole bell across, so that the cut tail is not lost
  for (int j = 0; j < kAcrossNodes; ++j) {
    const float b = (static_cast<float>(j) + 0.5f) * step_b, sy = b * slope_across;
    const float weight_b = std::exp(-0.5f * b * b);
    weights += weight_b;
    for (int i = 0; i < kAlongNodes; ++i) {
      const float a = first + (static_cast<float>(i) + 0.5f) * step_a, sx = a * slope_along;
      const float faces = mu + sine * sx;
      const float secant2 = 1.0f + sx * sx + sy * sy;
      const float twice = 2.0f * faces / secant2;
      const float mu_i = twice - mu;
      if (faces <= 0.0f || mu_i <= 0.0f) continue;
      const float xi = twice * sx - sine, yi = twice * sy;
      const float sigma_i = std::sqrt(slope_along * slope_along * xi * xi + slope_across * slope_across * yi * yi);
      const float area_i = formulas::gaussian_area(mu_i, sigma_i);
      const float k = std::max(1.0f - faces / std::sqrt(secant2), 0.0f);
      const float value = weight_b * std::exp(-0.5f * a * a) * faces * mu_i /
                          std::max(area_i * mu + area * mu_i - mu_i * mu, 1.0e-20f);
      sum += value * glm::vec2(1.0f, k * k * k * k * k);
    }
  }
  return glm::min(sum * (step_a * 0.39894228f / weights), glm::vec2(1.0f));
}

Table make_albedo(int threads) {
  Table t(kOpenings, kSpreads, kSpreads, 2);
  in_parallel(kSpreads * kSpreads, threads, [&t](int row) {
    const int y = row % kSpreads, z = row / kSpreads;
    for (int x = 0; x < kOpenings; ++x) {
      const glm::vec2 a = facet_albedo(coordinate(x, kOpenings), slope_of(coordinate(y, kSpreads)),
                                       slope_of(coordinate(z, kSpreads)));
      t.at(x, y, z)[0] = a.x;
      t.at(x, y, z)[1] = a.y;
    }
  });
  return t;
}

/// Cosine-weighted mean over the hemisphere, of the table as it is looked up.
glm::vec2 mean_of(const Table& albedo, float slope_x, float slope_y) {
  constexpr int kTurns = 12, kRings = 24;
  const float xx = slope_x * slope_x, yy = slope_y * slope_y;
  glm::vec2 sum(0.0f);
  for (int j = 0; j < kTurns; ++j) {
    const float phi = (static_cast<float>(j) + 0.5f) * (formulas::kPi / 2 / kTurns);
    const float c2 = std::cos(phi) * std::cos(phi), along = xx * c2 + yy * (1 - c2);
    for (int i = 0; i < kRings; ++i) {
      // Squared, so that grazing directions, where the albedo bends, are met often enough.
      const float u = (static_cast<float>(i) + 0.5f) / kRings, mu = u * u;
      const float sigma = std::sqrt(along * (1 - mu * mu));
      const float weight = mu * 2.0f * u;  // cosine times dmu / du
      sum += weight * albedo_at(albedo, mu / (mu + sigma), formulas::spread_coordinate(along),
                                formulas::spread_coordinate(xx + yy - along));
    }
  }
  return sum * (2.0f / (kTurns * kRings));
}

Table make_albedo_mean(const Table& albedo, int threads) {
  Table t(kSpreads, kSpreads, 1, 2);
  in_parallel(kSpreads, threads, [&](int y) {
    for (int x = 0; x < kSpreads; ++x) {
      const glm::vec2 m = mean_of(albedo, slope_of(coordinate(x, kSpreads)), slope_of(coordinate(y, kSpreads)));
      t.at(x, y)[0] = m.x;
      t.at(x, y)[1] = m.y;
    }
  });
  return t;
}

/// Fuzz of optical depth tau: (scattered once, share of a diffuse light that comes through).
glm::vec2 fuzz_once(float mu, float tau) {
  constexpr int kRings = 48;
  float once = 0, through = 0;
  for (int i = 0; i < kRings; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / kRings, mu_i = u * u, d = 2 * u / kRings;
    once += d * 0.5f * mu_i * (1 - std::exp(-tau / mu_i - tau / mu)) / (mu_i + mu);
    through += d * 2 * mu_i * std::exp(-tau / mu_i);
  }
  return {once, through};
}

Table make_fuzz() {
  Table t(kFuzzOpenings, kFuzzDepths, 1, 4);
  for (int y = 0; y < kFuzzDepths; ++y) {
    const float d = coordinate(y, kFuzzDepths), tau = std::clamp(d / std::max(1 - d, 1e-6f), 1e-4f, 1e3f);
    const auto loss = [tau](float mu) {
      const glm::vec2 f = fuzz_once(mu, tau);
      return std::clamp(1 - f.x - std::exp(-tau / mu) * f.y, 0.0f, 1.0f);
    };
    float mean = 0;
    constexpr int kRings = 24;
    for (int i = 0; i < kRings; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / kRings;
      mean += 4 * u * u * u / kRings * loss(u * u);
    }
    for (int x = 0; x < kFuzzOpenings; ++x) {
      const float o = coordinate(x, kFuzzOpenings);
      const float mu = std::clamp(tau * o / std::max(1 - o, 1e-6f), 1e-5f, 10.0f);
      const glm::vec2 f = fuzz_once(mu, tau);
      const float entry[4] = {f.x, loss(mu), f.y, mean};
      std::copy(entry, entry + 4, t.at(x, y));
    }
  }
  return t;
}

}  // namespace

LightTables make_light_tables(int threads) {
  LightTables tables;
  tables.albedo = make_albedo(threads);
  tables.albedo_mean = make_albedo_mean(tables.albedo, threads);
  tables.fuzz = make_fuzz();
  return tables;
}

const LightTables& light_tables() {
  static const LightTables tables = make_light_tables();
  return tables;
}

namespace formulas {

vec2 albedo_table(float opening, float along, float across) {
  return albedo_at(light_tables().albedo, opening, along, across);
}

vec2 albedo_mean_table(float major, float minor) {
  const Table& t = light_tables().albedo_mean;
  return mix_plane(t, cell_of(major, t.nx), cell_of(minor, t.ny), 0);
}

vec4 fuzz_table(float opening, float depth) {
  const Table& t = light_tables().fuzz;
  const Cell x = cell_of(opening, t.nx), y = cell_of(depth, t.ny);
  const auto entry = [&t](int i, int j) {
    const float* p = t.at(i, j);
    return vec4(p[0], p[1], p[2], p[3]);
  };
  return glm::mix(glm::mix(entry(x.i, y.i), entry(x.i + 1, y.i), x.t),
                  glm::mix(entry(x.i, y.i + 1), entry(x.i + 1, y.i + 1), x.t), y.t);
}

}  // namespace formulas
}  // namespace weftlight
