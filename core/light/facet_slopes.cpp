// Based on: Walter, Marschner, Li, Torrance 2007, "Microfacet models for refraction through rough surfaces" (density of
// normals and of slopes); here about a normal that is not that of the plane.

#include "light/facet_slopes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "light/formulas.h"
#include "platform/vectors.h"

namespace weftlight::light {
namespace {

constexpr size_t kBins = kSlopeBins;
constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kStep = kPi / kSlopeBins;            // of the angle, radians
constexpr float kMinWidth2 = 0.25f * kStep * kStep;  // a narrower lobe would fall between bins
constexpr float kMinFacing = 0.05f, kMinUp = 0.05f;  // cosines

using Row = std::array<float, kBins>;

/// Slopes of the middles of the bins.
const Row& bin_slopes() {
  static const Row slopes = [] {
    Row out{};
    for (size_t b = 0; b < kBins; ++b) out[b] = std::tan((static_cast<float>(b) + 0.5f) * kStep - 0.5f * kPi);
    return out;
  }();
  return slopes;
}

struct Lobe {
  glm::vec3 t, b, n;
  glm::vec3 inverse;  // of the covariance
  float scale;        // weight times the density at the normal
};

Lobe lobe_of(const FacetsAround& f) {
  const formulas::LobeFrame frame = formulas::lobe_frame(f.normal, f.fibre);
  const float xx = f.cov.x + kMinWidth2, yy = f.cov.z + kMinWidth2, xy = f.cov.y;
  const float det = std::max(xx * yy - xy * xy, 1e-3f * xx * yy);
  const float up = std::max(f.normal.z, kMinUp);
  return {frame.t, frame.b, frame.n, glm::vec3(yy, -xy, xx) / det, f.weight / (2 * kPi * std::sqrt(det) * up)};
}

/// Adds the density of slopes at one slope along y, for all along x: that about the normal, with the measure of the
/// plane.
void add_lobe(Row& row, const Lobe& lobe, float slope_y, const Row& slopes) {
  const glm::vec3 at = slope_y * glm::vec3(lobe.t.y, lobe.b.y, lobe.n.y) + glm::vec3(lobe.t.z, lobe.b.z, lobe.n.z);
  const glm::vec3 rise{lobe.t.x, lobe.b.x, lobe.n.x};
  const float xx = -0.5f * lobe.inverse.x, xy = -lobe.inverse.y, yy = -0.5f * lobe.inverse.z, scale = lobe.scale;
  for (size_t i = 0; i < kBins; ++i) {
    const float x = slopes[i], facing = at.z + rise.z * x, over = 1 / std::max(facing, kMinFacing);
    const float p = (at.x + rise.x * x) * over, q = (at.y + rise.y * x) * over, over2 = over * over;
    const float density = formulas::exp(xx * p * p + xy * p * q + yy * q * q) * over2 * over2 * scale;
    row[i] += facing > kMinFacing ? density : 0.0f;
  }
}

}  // namespace

FacetSlopes facet_slopes(const std::vector<FacetsAround>& facets) {
  std::vector<Lobe> lobes;
  lobes.reserve(facets.size());
  for (const FacetsAround& f : facets)
    if (f.weight > 0) lobes.push_back(lobe_of(f));
  FacetSlopes out(kBins * kBins);
  if (lobes.empty()) return out;
  const Row& slopes = bin_slopes();
  base::for_each_job(kSlopeBins, [&](int y) {
    Row row{};
    const float slope_y = slopes[static_cast<size_t>(y)];
    platform::with_widest_vectors([&] {
      for (const Lobe& lobe : lobes) add_lobe(row, lobe, slope_y, slopes);
    });
    // From slopes to their angles.
    for (size_t x = 0; x < kBins; ++x)
      out[static_cast<size_t>(y) * kBins + x] = row[x] * (1 + slopes[x] * slopes[x]) * (1 + slope_y * slope_y);
  });
  double sum = 0;
  for (const float v : out) sum += static_cast<double>(v);
  const float scale = static_cast<float>(1 / std::max(sum * static_cast<double>(kStep * kStep), 1e-12));
  for (float& v : out) v *= scale;
  return out;
}

float density_at(const FacetSlopes& slopes, const glm::vec2& slope) {
  if (slopes.empty()) return 0;
  const auto place = [](float of) {
    const float at = std::clamp(formulas::slope_coord(of) * kSlopeBins - 0.5f, 0.0f, kSlopeBins - 1.001f);
    const size_t k = static_cast<size_t>(at);
    return std::pair(k, at - static_cast<float>(k));
  };
  const auto [i, s] = place(slope.x);
  const auto [j, t] = place(slope.y);
  const float* low = &slopes[j * kBins + i];
  const float* high = low + kBins;
  return (low[0] + (low[1] - low[0]) * s) * (1 - t) + (high[0] + (high[1] - high[0]) * s) * t;
}

float closed_form(const FacetSlopes& slopes, float fraction, const glm::vec3& l, const glm::vec3& v) {
  const formulas::vec2 h = formulas::half_slopes(l, v);
  return fraction * formulas::facet_density(density_at(slopes, h), h);
}

}  // namespace weftlight::light
