// Directional and mean albedos of the lobes by quadrature.
// Based on: Heitz 2014, "Understanding the masking-shadowing function", for the integral over slopes;
//   Koenderink, Pont 2003, "The secret of velvety skin", for the fuzz.

#include "light/tables.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/loops.h"
#include "light/formulas.h"

namespace weftlight::light {

using base::for_each_job;

namespace {

constexpr int kOpenings = 20, kSpreads = 24;  // entries of the albedo table
constexpr int kFuzzOpenings = 32, kFuzzDepths = 16;
constexpr float kWidestSlope = 1.0e3f;  // stands for infinity: the albedo no longer changes
constexpr float kMinSlope = 5.0e-3f;
constexpr float kGaussianReach = 4.25f;  // standard deviations; beyond lie 2e-5 of the facets
constexpr int kAlongNodes = 16, kAcrossNodes = 8, kLineNodes = 24;

float coordinate(int i, int n) { return static_cast<float>(i) / static_cast<float>(n - 1); }

float slope_of(float coordinate) {
  return std::clamp(coordinate / std::max(1.0f - coordinate, 1.0e-6f), kMinSlope, kWidestSlope);
}

template <class V>
V entry(const Table& t, int x, int y, int z) {
  V v;
  const float* p = t.at(x, y, z);
  for (int c = 0; c < V::length(); ++c) v[c] = p[c];
  return v;
}

template <class V>
V plane_at(const Table& t, TableCell x, TableCell y, int z) {
  return glm::mix(glm::mix(entry<V>(t, x.i, y.i, z), entry<V>(t, x.i + 1, y.i, z), x.t),
                  glm::mix(entry<V>(t, x.i, y.i + 1, z), entry<V>(t, x.i + 1, y.i + 1, z), x.t), y.t);
}

glm::vec4 albedo_at(const Table& t, float opening, float along, float across) {
  const TableCell x = cell_of(opening, t.nx), y = cell_of(along, t.ny), z = cell_of(across, t.nz);
  return glm::mix(plane_at<glm::vec4>(t, x, y, z.i), plane_at<glm::vec4>(t, x, y, z.i + 1), z.t);
}

/// A view (sine, 0, mu) of facets with RMS slopes along and across it.
struct FacetView {
  float along, across;  // RMS slopes
  float nu, mu, sine;   // nu: cosine over deviation
  float area;
};
/// Cotangent of the view angle from the normal: the inverse of `opening`.
float cotangent_of(float opening, float along) {
  const float squared = opening * opening;
  return squared / std::max(1.0f - squared, 1.0e-6f) * (along / (1 + along));
}
FacetView facet_view(float opening, float along, float across) {
  const float cotangent = cotangent_of(opening, along);
  FacetView v{along, across, cotangent / along, 0, 0, 0};
  v.sine = 1.0f / std::sqrt(1.0f + cotangent * cotangent);
  v.mu = std::max(cotangent * v.sine, 1.0e-6f);
  v.area = formulas::gaussian_area(v.mu, along * v.sine);
  return v;
}

/// Sums over one row of facets, lane by lane, so that the compiler can vectorise them.
template <int kCount>
struct Row {
  std::array<float, kCount> slope, weight, front{}, albedo{}, fresnel{};
};

/// Quadrature nodes of a slope's Gaussian, uniform in the slope's angle, since only facets up to about 45 degrees
/// reflect upwards however wide the Gaussian is.
template <int kCount>
Row<kCount> slope_row(float first, float last, float rms) {
  Row<kCount> row;
  const float from = std::atan(first * rms), step = (std::atan(last * rms) - from) / kCount;
  const float turn = std::tan(step);
  float slope = std::tan(from + 0.5f * step);
  for (size_t i = 0; i < kCount; ++i, slope = (slope + turn) / (1 - slope * turn)) {
    const float z = slope / rms;
    row.slope[i] = slope;
    row.weight[i] = formulas::exp(-0.5f * z * z) * 0.39894228f * step * (1 + slope * slope) / rms;
  }
  return row;
}

/// Facets of slopes (x, y) = (kx, ky) row.slope + (0, y0): (wo.(s,1))+ mu_i / (A_i mu_o + A_o mu_i - mu_i mu_o), A
/// the projected areas, which is F D G / (4 mu_o) dwi with the measure turned to slopes; and that
/// times (1 - wi.h)^5.
template <bool kCorrelated, int kCount>
void add_facets(Row<kCount>& row, const FacetView& v, float kx, float ky, float y0, float weight) {
  for (size_t i = 0; i < kCount; ++i) {
    const float sx = kx * row.slope[i], sy = y0 + ky * row.slope[i];
    const float faces = std::max(v.mu + v.sine * sx, 0.0f);
    const float secant2 = 1.0f + sx * sx + sy * sy;
    const float twice = 2.0f * faces / secant2;
    const float mu_i = std::max(twice - v.mu, 0.0f);
    const float x = v.along * (twice * sx - v.sine), y = v.across * twice * sy;
    const float sigma_i = kCorrelated ? std::abs(x + y) : std::sqrt(x * x + y * y);
    const float area_i = formulas::gaussian_area(mu_i, sigma_i);
    const float value = faces * mu_i / std::max(area_i * v.mu + v.area * mu_i - mu_i * v.mu, 1.0e-20f);
    const float k = std::max(1.0f - faces / std::sqrt(secant2), 0.0f), k2 = k * k;
    row.front[i] += weight * row.weight[i] * faces;
    row.albedo[i] += weight * row.weight[i] * value;
    row.fresnel[i] += weight * row.weight[i] * value * (k2 * k2 * k);
  }
}

/// The sum of `front` is the projected area, known in closed form: a smooth lobe's quadrature error is the same in its
/// albedo. A rough lobe's steep facets count only in the area.
template <int kCount>
glm::vec2 total(const Row<kCount>& row, const FacetView& v) {
  glm::vec3 sum(0);
  for (size_t i = 0; i < kCount; ++i) sum += glm::vec3(row.front[i], row.albedo[i], row.fresnel[i]);
  const bool smooth = std::max(v.along, v.across) < 1.0f;
  return glm::vec2(sum.y, sum.z) * (smooth ? v.area / std::max(sum.x, 1.0e-20f) : 1.0f);
}

/// Facets with z < -nu face away from the view.
float first_facing(const FacetView& v) { return std::max(-v.nu, -kGaussianReach); }

glm::vec2 independent_albedo(const FacetView& v, const Row<kAcrossNodes>& across) {
  Row<kAlongNodes> along = slope_row<kAlongNodes>(first_facing(v), kGaussianReach, v.along);
  for (size_t j = 0; j < kAcrossNodes; ++j) add_facets<false>(along, v, 1, 0, across.slope[j], 2 * across.weight[j]);
  return total(along, v);
}

glm::vec2 correlated_albedo(const FacetView& v) {
  const float rms = std::sqrt(v.along * v.along + v.across * v.across);
  Row<kLineNodes> row = slope_row<kLineNodes>(first_facing(v), kGaussianReach, rms);
  add_facets<true>(row, v, v.along / rms, v.across / rms, 0, 1);
  return total(row, v);
}

/// The cosine c for which (1 - c)^5 is the mean, over that of the view.
float fresnel_cosine(const FacetView& v, const glm::vec2& albedo) {
  const float ratio = std::clamp(albedo.y / std::max(albedo.x, 1.0e-12f), 0.0f, 1.0f);
  return (1.0f - std::pow(ratio, 0.2f)) / v.mu;
}

Table make_albedo(int threads) {
  Table t(kOpenings, kSpreads, kSpreads, 4);
  for_each_job(kSpreads * kSpreads, threads, [&t](int row) {
    const int y = row % kSpreads, z = row / kSpreads;
    const auto across = slope_row<kAcrossNodes>(0, kGaussianReach, slope_of(coordinate(z, kSpreads)));
    const float slope_along = slope_of(coordinate(y, kSpreads)), slope_across = slope_of(coordinate(z, kSpreads));
    // Within 45 degrees of the normal the Fresnel part is negligible and its cosine is that of the few steepest
    // facets: clamping it to the one at 45 degrees keeps the entries smooth.
    const FacetView half = facet_view(std::sqrt(1 / (1 + slope_along / (1 + slope_along))), slope_along, slope_across);
    const float hold = fresnel_cosine(half, independent_albedo(half, across));
    const float hold_correlated = fresnel_cosine(half, correlated_albedo(half));
    for (int x = 0; x < kOpenings; ++x) {
      const FacetView v = facet_view(coordinate(x, kOpenings), slope_along, slope_across);
      const glm::vec2 a = independent_albedo(v, across), b = correlated_albedo(v);
      const float over_rim = v.mu / (v.mu + v.sine * slope_along / (1 + slope_along));
      float* cell = t.at(x, y, z);
      cell[0] = std::clamp(1.0f - a.x, 0.0f, 1.0f);
      cell[1] = over_rim * (v.mu > half.mu ? hold : fresnel_cosine(v, a));
      cell[2] = std::clamp(1.0f - b.x, 0.0f, 1.0f);
      cell[3] = over_rim * (v.mu > half.mu ? hold_correlated : fresnel_cosine(v, b));
    }
  });
  return t;
}

/// One azimuth of a lobe with principal variances, as lobe_side() looks it up.
struct Slice {
  float along, across, mixed;
};
Slice slice_of(float xx, float yy, float phi) {
  const float c2 = std::cos(phi) * std::cos(phi), along = xx * c2 + yy * (1 - c2), across = xx + yy - along;
  return {along, across, std::clamp(1 - xx * yy / (along * across), 0.0f, 1.0f)};
}

glm::vec2 stored_at(const Table& albedo, const Slice& s, float opening) {
  const glm::vec4 t =
      albedo_at(albedo, opening, formulas::spread_coordinate(s.along), formulas::spread_coordinate(s.across));
  return glm::mix(glm::vec2(t.x, t.y), glm::vec2(t.z, t.w), s.mixed);
}

/// Cosine-weighted means over the hemisphere of the table as it is looked up: of the loss over rings uniform in
/// `opening`, since a smooth lobe loses light only at grazing angles; of the Fresnel part over rings uniform in the
/// cosine.
glm::vec2 mean_of(const Table& albedo, float slope_x, float slope_y) {
  constexpr int kTurns = 12, kRings = 32;
  const float xx = slope_x * slope_x, yy = slope_y * slope_y;
  float loss = 0, fresnel = 0;
  for (int j = 0; j < kTurns; ++j) {
    const Slice s = slice_of(xx, yy, (static_cast<float>(j) + 0.5f) * (formulas::kPi / 2 / kTurns));
    const auto cosine2 = [along = std::sqrt(s.along)](float opening) {
      const float c = cotangent_of(opening, along);
      return c * c / (1 + c * c);
    };
    for (int i = 0; i < kRings; ++i) {
      const float x = static_cast<float>(i) / kRings, half = 0.5f / kRings;
      loss += stored_at(albedo, s, x + half).x * (cosine2(x + 2 * half) - cosine2(x));
      const float mu = x + half;
      const float rim = mu + std::sqrt(1 - mu * mu) * formulas::spread_coordinate(s.along);
      const glm::vec2 t = stored_at(albedo, s, std::sqrt(mu / rim));
      const float k = std::max(1 - t.y * rim, 0.0f);
      fresnel += k * k * k * k * k * (1 - t.x) * 2 * mu / kRings;
    }
  }
  const float v = 0.5f * (xx + yy);
  return {loss / kTurns * (1 + v) / v, fresnel / kTurns};
}

Table make_albedo_mean(const Table& albedo, int threads) {
  Table t(kSpreads, kSpreads, 1, 2);
  for_each_job(kSpreads, threads, [&](int y) {
    for (int x = 0; x <= y; ++x) {
      const glm::vec2 m = mean_of(albedo, slope_of(coordinate(x, kSpreads)), slope_of(coordinate(y, kSpreads)));
      t.at(x, y)[0] = t.at(y, x)[0] = m.x;
      t.at(x, y)[1] = t.at(y, x)[1] = m.y;
    }
  });
  return t;
}

/// Fuzz of optical depth tau: single scattering, and transmittance of diffuse light.
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

Table make_fuzz(int threads) {
  Table t(kFuzzOpenings, kFuzzDepths, 1, 4);
  for_each_job(kFuzzDepths, threads, [&t](int y) {
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
  });
  return t;
}

}  // namespace

LightTables make_light_tables(int threads) {
  LightTables tables;
  tables.albedo = make_albedo(threads);
  tables.albedo_mean = make_albedo_mean(tables.albedo, threads);
  tables.fuzz = make_fuzz(threads);
  return tables;
}

const LightTables& light_tables() {
  static const LightTables tables = make_light_tables();
  return tables;
}

}  // namespace weftlight::light

namespace weftlight::formulas {

using light::Table, light::albedo_at, light::cell_of, light::light_tables, light::plane_at;

vec4 albedo_table(float opening, float along, float across) {
  return albedo_at(light_tables().albedo, opening, along, across);
}

vec2 albedo_mean_table(float major, float minor) {
  const Table& t = light_tables().albedo_mean;
  return plane_at<vec2>(t, cell_of(major, t.nx), cell_of(minor, t.ny), 0);
}

vec4 fuzz_table(float opening, float depth) {
  const Table& t = light_tables().fuzz;
  return plane_at<vec4>(t, cell_of(opening, t.nx), cell_of(depth, t.ny), 0);
}

}  // namespace weftlight::formulas
