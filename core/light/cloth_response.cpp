// Sums over points of the surface, for every pair of directions, of what both see.
// Based on: Westin, Arvo, Torrance 1992, "Predicting reflectance functions from complex surfaces" (a table
//   measured on small geometry); Ashikhmin, Premoze, Shirley 2000 (facets that mirror, by their normals).
// Differs: visibility comes from the horizons of the maps, not from rays; the specular part is measured facet
//   lobe by facet lobe, and stored over its closed form from the measured slopes, so that the table is smooth.

#include "light/cloth_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "light/formulas.h"
#include "light/parallel.h"
#include "light/yarn_lobes.h"

namespace weftlight {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kD = kResponseDirections;
constexpr float kHorizonSoft = 0.03f;   // sine: a few points stand for many
constexpr float kUnseenFacets = 0.01f;  // density of facets below which their share is taken as that of a plane
constexpr float kStraight = 1e-4f;      // variance of a facet's moments that tells nothing
constexpr float kSteepest = 100.0f;     // rise with a moment, over the mean
constexpr float kDark = 1e-4f;          // radiance whose lean is not seen
constexpr int kMeanTexels = 512;        // along a side of the map, for plain means
constexpr float kThrough = 0.6f;        // widths of a thread that light crosses in it

using PerDirection = std::array<float, kD>;

std::array<glm::vec3, kD> directions() {
  std::array<glm::vec3, kD> out;
  for (int e = 0; e < kResponseElevations; ++e) {
    const float u = static_cast<float>(e) / (kResponseElevations - 1);
    const float z = std::max(u * u, 0.004f), r = std::sqrt(std::max(0.0f, 1 - z * z));
    for (int a = 0; a < kResponseAzimuths; ++a) {
      const float t = 2 * kPi * static_cast<float>(a) / kResponseAzimuths;
      out[static_cast<size_t>(e * kResponseAzimuths + a)] = {r * std::cos(t), r * std::sin(t), z};
    }
  }
  return out;
}

/// One point: what each direction sees of it.
struct Point {
  float weight = 0;         // of the cloth's plane
  int system = 0;
  float inverse_nz = 1;
  glm::vec3 normal{0, 0, 1};
  PerDirection open, cosine, body, lit, clear, area, lost, veil;
  float height_mm = 0;
  std::array<float, kFacetMoments> facets{};
  PerDirection along, across, mu;   // of each direction in the frame of the fibre; mu held above the plane
  glm::vec3 inverse{1, 0, 1};       // of the covariance of the facets' slopes
  float peak = 0;                   // density of those slopes at their mean
  float body_scale = 0, multiple = 0, fuzz = 0, again = 0, groove = 1;
  float tone = 0, f0 = 0, f90 = 0, hair = 0;   // green, of the colours that the table leaves out
};

/// Texel from which light that leaves (x, y) behind enters the thread: most of a thread's width towards it.
std::array<int, 2> entry_of(const Maps& maps, float width_mm, int x, int y, const glm::vec3& w) {
  const float scale = kThrough * width_mm / std::max(std::sqrt(w.x * w.x + w.y * w.y), 1e-4f);
  const int nx = maps.coverage.width, ny = maps.coverage.height;
  const auto wrap = [](int i, int n) { return ((i % n) + n) % n; };
  return {wrap(x + static_cast<int>(std::lround(w.x * scale / maps.width_mm * static_cast<float>(nx))), nx),
          wrap(y + static_cast<int>(std::lround(w.y * scale / maps.depth_mm * static_cast<float>(ny))), ny)};
}

float horizon_of(const Maps& maps, int x, int y, int azimuth) {
  if (maps.azimuths <= 0) return 0;
  const float at = static_cast<float>(azimuth) * static_cast<float>(maps.azimuths) / kResponseAzimuths;
  const int k = static_cast<int>(at);
  const float t = at - static_cast<float>(k);
  const float a = maps.horizon[static_cast<size_t>(k % maps.azimuths)].at(x, y);
  const float b = maps.horizon[static_cast<size_t>((k + 1) % maps.azimuths)].at(x, y);
  return (a + (b - a) * t) / 255.0f;
}

std::array<float, kFacetMoments> facets_of(const glm::vec3& n) { return {n.x, n.y, n.x * n.x, n.y * n.y}; }

Point measure(const Cloth& cloth, const Maps& maps, int x, int y, const std::array<glm::vec3, kD>& w) {
  Point p;
  p.system = maps.system.at(x, y) ? 1 : 0;
  p.weight = maps.coverage.at(x, y);
  const Slope s = maps.slope.at(x, y);
  p.inverse_nz = std::sqrt(1 + s.x * s.x + s.y * s.y);
  p.normal = glm::vec3(s.x, s.y, 1) / p.inverse_nz;
  const auto& threads = p.system ? cloth.picks : cloth.ends;
  const ThreadBody& body = threads[std::min<size_t>(maps.thread.at(x, y), threads.size() - 1)];
  const formulas::YarnLobes lobes = yarn_lobes(cloth.yarns[static_cast<size_t>(body.yarn)].lobes, maps.colour.at(x, y));
  const formulas::LobeShared shared = formulas::lobe_shared(lobes);
  const Direction& t = maps.tangent.at(x, y);
  const formulas::LobeFrame frame = formulas::lobe_frame(p.normal, {t.x, t.y, t.z});
  p.fuzz = lobes.fuzz, p.body_scale = shared.body_scale.g, p.multiple = shared.multiple.g;
  p.inverse = shared.inverse, p.peak = shared.peak, p.groove = maps.groove.at(x, y);
  p.tone = lobes.body.g, p.f0 = lobes.f0.g, p.f90 = lobes.f90;
  p.hair = lobes.fuzz > 0 ? lobes.fuzz_colour.g : p.f0 / std::max(p.f90, 1e-3f);
  p.height_mm = maps.height_mm.at(x, y), p.facets = facets_of(p.normal);
  for (size_t d = 0; d < kD; ++d) {
    const glm::vec3 local = formulas::lobe_local(frame, w[d]);
    const formulas::LobeSide side = formulas::lobe_side(lobes, shared, local);
    const float above = (w[d].z - horizon_of(maps, x, y, static_cast<int>(d) % kResponseAzimuths)) / kHorizonSoft;
    const float facing = std::max(local.z, 0.0f);
    p.open[d] = facing > 0 ? std::clamp(0.5f + above, 0.0f, 1.0f) : 0.0f;
    p.cosine[d] = facing * p.open[d];
    p.body[d] = p.cosine[d] * side.enters.g;
    p.lit[d] = p.body[d];
    if (local.z < 0 && lobes.body.g > 0) {
      const auto [ex, ey] = entry_of(maps, body.width_mm, x, y, w[d]);
      const float clear = (w[d].z - horizon_of(maps, ex, ey, static_cast<int>(d) % kResponseAzimuths)) / kHorizonSoft;
      const float enters = formulas::lobe_side(lobes, shared, {local.x, local.y, -local.z}).enters.g;
      p.lit[d] = -local.z * enters * std::clamp(0.5f + clear, 0.0f, 1.0f) * lobes.through.g / lobes.body.g;
    }
    p.along[d] = local.x, p.across[d] = local.y, p.mu[d] = side.mu;
    p.clear[d] = side.clear, p.area[d] = side.area, p.lost[d] = p.cosine[d] * side.lost, p.veil[d] = p.cosine[d] * side.fuzz.y;
    p.again = lobes.fuzz * lobes.body.g * shared.mean_enters.g / (kPi * std::max(side.fuzz.w, 1e-4f));
  }
  return p;
}

struct Sums {
  std::vector<float> body, mirror, hair, all;
  std::array<std::vector<float>, kFacetMoments> leaning;   // all, times each of the point's moments
  PerDirection seen{}, height{};
  std::array<PerDirection, kFacetMoments> seen_leaning{};
  Sums() : body(kD * kD), mirror(kD * kD), hair(kD * kD), all(kD * kD) { leaning.fill(all); }
};

/// Schlick's (1 - cosine)^5 at the half vector of each pair.
std::vector<float> grazing_of(const std::array<glm::vec3, kD>& w) {
  std::vector<float> out(kD * kD);
  for (size_t v = 0; v < kD; ++v)
    for (size_t i = 0; i < kD; ++i) out[v * kD + i] = std::pow(std::max(1 - 0.5f * glm::length(w[v] + w[i]), 0.0f), 5.0f);
  return out;
}

/// Adds a point to all pairs of a row of views. Pairs are symmetric but for what the caller divides by.
void add(Sums& sums, const Point& p, const std::vector<float>& grazing, size_t view) {
  if (p.open[view] <= 0) return;
  const float area = p.weight * p.inverse_nz, mu = p.mu[view], seen = area * p.cosine[view];
  sums.seen[view] += seen, sums.height[view] += seen * p.height_mm;
  for (size_t k = 0; k < kFacetMoments; ++k) sums.seen_leaning[k][view] += seen * p.facets[k];
  const float from = area * p.body[view] * p.body_scale, veil = area * p.groove * p.veil[view] * p.again;
  const float once = area * p.groove * p.fuzz * p.cosine[view] / (4 * kPi), lost = area * p.groove * p.lost[view] * p.multiple;
  const float glance = 0.25f * area * p.groove * p.peak * p.cosine[view];
  // Kept apart from the sums, which might be any of the point's floats as far as the compiler knows: the loops then run
  // on vectors.
  const float fuzz = p.fuzz, clear = p.clear[view], area_v = p.area[view], along = p.along[view], across = p.across[view];
  const float xx = -0.5f * p.inverse.x, xy = -p.inverse.y, yy = -0.5f * p.inverse.z;
  PerDirection mirrored, scattered, combed, sent;
  for (size_t i = 0; i < kD; ++i) {
    const float mu_i = p.mu[i], cosine = p.cosine[i], veiled = 1 - clear * p.clear[i], unveiled = 1 - fuzz * veiled;
    // Beckmann's facets, as lobe_specular() has them (shaders/lobes.glsl), without Fresnel.
    const float over = 1 / (mu + mu_i), x = (along + p.along[i]) * over, y = (across + p.across[i]) * over;
    const float secant2 = 1 + x * x + y * y;
    const float d = secant2 * secant2 * formulas::exp(xx * x * x + xy * x * y + yy * y * y);
    mirrored[i] = glance * d * cosine * unveiled / (p.area[i] * mu + area_v * mu_i - mu * mu_i);
    scattered[i] = from * p.lit[i] * unveiled;
    combed[i] = once * cosine * veiled * over + veil * p.veil[i] + lost * p.lost[i];
  }
  const float* graze = &grazing[view * kD];
  for (size_t i = 0; i < kD; ++i) {
    sent[i] = scattered[i] * p.tone + mirrored[i] * (p.f0 + (p.f90 - p.f0) * graze[i]) + combed[i] * p.hair;
  }
  const auto accumulate = [view](std::vector<float>& to, const PerDirection& row_of, float scale) {
    float* row = &to[view * kD];
    for (size_t i = 0; i < kD; ++i) row[i] += row_of[i] * scale;
  };
  accumulate(sums.body, scattered, 1);
  accumulate(sums.mirror, mirrored, 1);
  accumulate(sums.hair, combed, 1);
  accumulate(sums.all, sent, 1);
  for (size_t k = 0; k < kFacetMoments; ++k) accumulate(sums.leaning[k], sent, p.facets[k]);
}

void spread_slope(std::array<float, kSlopeBins>& bins, float slope, float sigma, float weight) {
  const float middle = std::atan(slope), deviation = std::max(std::atan(sigma), 0.5f * kPi / kSlopeBins);
  const float step = kPi / kSlopeBins;
  std::array<float, kSlopeBins> bell;
  float sum = 0;
  for (int b = 0; b < kSlopeBins; ++b) {
    const float z = ((static_cast<float>(b) + 0.5f) * step - 0.5f * kPi - middle) / deviation;
    sum += bell[static_cast<size_t>(b)] = std::exp(-0.5f * std::min(z * z, 60.0f));
  }
  for (size_t b = 0; b < kSlopeBins; ++b) bins[b] += weight * bell[b] / (std::max(sum, 1e-20f) * step);
}

void add_slopes(ClothResponse& out, const Cloth& cloth, const Maps& maps, int x, int y, const Point& p) {
  SystemResponse& s = out.systems[static_cast<size_t>(p.system)];
  const auto& threads = p.system ? cloth.picks : cloth.ends;
  const Lobes& lobes = cloth.yarns[static_cast<size_t>(threads[std::min<size_t>(maps.thread.at(x, y), threads.size() - 1)].yarn)].lobes;
  const Slope slope = maps.slope.at(x, y);
  const Direction& t = maps.tangent.at(x, y);
  const float c2 = t.x * t.x / std::max(t.x * t.x + t.y * t.y, 1e-6f);
  const float along2 = lobes.along_width * lobes.along_width, across2 = lobes.across_width * lobes.across_width;
  spread_slope(s.slopes[0], slope.x, std::sqrt(along2 * c2 + across2 * (1 - c2)), p.weight);
  spread_slope(s.slopes[1], slope.y, std::sqrt(along2 * (1 - c2) + across2 * c2), p.weight);
}

/// Means over the whole map, which need no directions and so many more texels.
void take_means(ClothResponse& out, const Maps& maps) {
  const int step_x = std::max(1, maps.coverage.width / kMeanTexels), step_y = std::max(1, maps.coverage.height / kMeanTexels);
  float all = 0;
  for (int j = 0; j < maps.coverage.height / step_y; ++j) {
    for (int i = 0; i < maps.coverage.width / step_x; ++i) {
      // Every place within a step in turn: the threads are as regular as the texels.
      const int x = i * step_x + (i + j) % step_x, y = j * step_y + i % step_y;
      const float weight = maps.coverage.at(x, y), shade = weight * maps.groove.at(x, y);
      SystemResponse& s = out.systems[maps.system.at(x, y) ? 1 : 0];
      const Linear& c = maps.colour.at(x, y);
      const Slope slope = maps.slope.at(x, y);
      const auto facets = facets_of(glm::normalize(glm::vec3(slope.x, slope.y, 1)));
      s.share += weight, all += weight;
      s.colour.r += c.r * shade, s.colour.g += c.g * shade, s.colour.b += c.b * shade;
      for (size_t k = 0; k < kFacetMoments; ++k) s.facets[k] += weight * facets[k];
      out.sky += weight * maps.occlusion.at(x, y);
    }
  }
  for (SystemResponse& s : out.systems) {
    const float scale = 1 / std::max(s.share, 1e-9f);
    s.colour = {s.colour.r * scale, s.colour.g * scale, s.colour.b * scale};
    for (float& f : s.facets) f *= scale;
    s.share /= std::max(all, 1e-9f);
  }
  out.sky /= std::max(all, 1e-9f);
}

/// To a density.
void finish_slopes(SystemResponse& s) {
  for (auto& axis : s.slopes) {
    float sum = 0;
    for (const float v : axis) sum += v;
    for (float& v : axis) v *= kSlopeBins / (kPi * std::max(sum, 1e-9f));
  }
}

using Moments = std::array<float, kFacetMoments>;
using Matrix = std::array<Moments, kFacetMoments>;

/// Inverse by Gauss and Jordan; the matrix is symmetric and positive.
Matrix inverse_of(Matrix m) {
  Matrix out{};
  for (size_t k = 0; k < kFacetMoments; ++k) out[k][k] = 1;
  for (size_t k = 0; k < kFacetMoments; ++k) {
    const float scale = 1 / m[k][k];
    for (size_t c = 0; c < kFacetMoments; ++c) m[k][c] *= scale, out[k][c] *= scale;
    for (size_t r = 0; r < kFacetMoments; ++r) {
      if (r == k) continue;
      const float f = m[r][k];
      for (size_t c = 0; c < kFacetMoments; ++c) m[r][c] -= f * m[k][c], out[r][c] -= f * out[k][c];
    }
  }
  return out;
}

/// Least squares of what a point shows on the moments of its facet, over the points of one system.
struct Regression {
  float weight = 0;
  Moments mean{};    // of the points
  Matrix inverse{};  // of their covariance

  template <class Weight>
  Regression(const std::vector<Point>& points, int system, Weight weight_of) {
    Matrix square{};
    for (const Point& p : points) {
      if (p.system != system) continue;
      const float w = weight_of(p);
      weight += w;
      for (size_t r = 0; r < kFacetMoments; ++r) {
        mean[r] += w * p.facets[r];
        for (size_t c = 0; c < kFacetMoments; ++c) square[r][c] += w * p.facets[r] * p.facets[c];
      }
    }
    const float scale = 1 / std::max(weight, 1e-9f);
    for (float& m : mean) m *= scale;
    for (size_t r = 0; r < kFacetMoments; ++r) {
      for (size_t c = 0; c < kFacetMoments; ++c) square[r][c] = square[r][c] * scale - mean[r] * mean[c];
      square[r][r] += kStraight;
    }
    inverse = inverse_of(square);
  }
  /// Rise of a quantity with each moment, from its sum over the points and the sums of its products.
  Moments rise(float sum, const Moments& products) const {
    Moments out{};
    for (size_t r = 0; r < kFacetMoments; ++r)
      for (size_t c = 0; c < kFacetMoments; ++c) out[r] += inverse[r][c] * (products[c] - mean[c] * sum);
    return out;
  }
  /// Share by which the quantity is larger over the whole map, whose moments are known, than over the points.
  float correction(float sum, const Moments& rise, const Moments& whole) const {
    float more = 0;
    for (size_t k = 0; k < kFacetMoments; ++k) more += rise[k] * (whole[k] - mean[k]);
    return sum > 0 ? std::clamp(1 + more / sum, 0.5f, 2.0f) : 1.0f;
  }
};

/// Density of the facets that mirror light along `l` to `v`, as the shader takes it from the measured slopes.
float closed_form(const SystemResponse& s, const glm::vec3& l, const glm::vec3& v) {
  const formulas::vec2 h = formulas::half_slopes(l, v);
  const auto density = [](const std::array<float, kSlopeBins>& bins, float slope) {
    const float at = std::clamp(formulas::slope_coord(slope) * kSlopeBins - 0.5f, 0.0f, kSlopeBins - 1.001f);
    const size_t k = static_cast<size_t>(at);
    return bins[k] + (bins[k + 1] - bins[k]) * (at - static_cast<float>(k));
  };
  return s.share * formulas::facet_density({density(s.slopes[0], h.x), density(s.slopes[1], h.y)}, h);
}

/// Of one system, per its share of the cover: what it sends, what is seen of it, and how the first leans with the
/// facets that are seen.
void finish_system(SystemResponse& out, Sums& sums, const std::vector<Point>& points, int system) {
  const Regression cover(points, system, [](const Point& p) { return p.weight; });
  const float scale = out.share / std::max(cover.weight, 1e-9f);
  for (size_t v = 0; v < kD; ++v) {
    const Regression visible(points, system, [v](const Point& p) { return p.weight * p.inverse_nz * p.cosine[v]; });
    Moments products;
    for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.seen_leaning[k][v];
    out.height_mm[v] = sums.height[v] / std::max(sums.seen[v], 1e-9f);
    sums.seen[v] *= scale * cover.correction(sums.seen[v], cover.rise(sums.seen[v], products), out.facets);
    for (size_t i = 0; i < kD; ++i) {
      const size_t at = v * kD + i;
      const float all = sums.all[at], least = kDark * std::max(visible.weight, 1e-9f);
      for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.leaning[k][at];
      const Moments rise = visible.rise(all, products);
      for (size_t k = 0; k < kFacetMoments; ++k)
        out.lean[kFacetMoments * at + k] = std::clamp(rise[k] / std::max(all, least), -kSteepest, kSteepest);
      const float correction = scale * cover.correction(all, cover.rise(all, products), out.facets);
      sums.body[at] *= correction, sums.mirror[at] *= correction, sums.hair[at] *= correction;
    }
  }
}

}  // namespace

ClothResponse cloth_response(const Cloth& cloth, const Maps& maps, int samples) {
  ClothResponse out;
  out.sky = 0;
  for (SystemResponse& s : out.systems) {
    s.broad.assign(size_t{4} * kD * kD, 0.0f), s.lean.assign(kFacetMoments * kD * kD, 0.0f);
    s.height_mm.assign(kD, 0.0f);
  }
  const int width = maps.coverage.width, height = maps.coverage.height;
  if (cloth.ends.empty() || cloth.picks.empty() || width <= 0 || height <= 0) return out;
  const std::array<glm::vec3, kD> w = directions();
  std::vector<Point> points;
  for (int k = 0; k < samples; ++k) {
    // R2 sequence (Roberts 2018).
    const double u = std::fmod(0.7548776662466927 * (k + 1), 1.0), v = std::fmod(0.5698402909980532 * (k + 1), 1.0);
    const int x = std::min(width - 1, static_cast<int>(u * width)), y = std::min(height - 1, static_cast<int>(v * height));
    if (maps.coverage.at(x, y) < 0.02f) continue;
    points.push_back(measure(cloth, maps, x, y, w));
    add_slopes(out, cloth, maps, x, y, points.back());
  }
  take_means(out, maps);
  const std::vector<float> grazing = grazing_of(w);
  std::array<Sums, 2> sums;
  in_parallel(kResponseElevations, 2, [&](int e) {
    for (const Point& p : points)
      for (int a = 0; a < kResponseAzimuths; ++a)
        add(sums[static_cast<size_t>(p.system)], p, grazing, static_cast<size_t>(e * kResponseAzimuths + a));
  });
  for (size_t s = 0; s < 2; ++s) {
    finish_system(out.systems[s], sums[s], points, static_cast<int>(s));
    finish_slopes(out.systems[s]);
  }
  for (size_t v = 0; v < kD; ++v) {
    const float seen = std::max(sums[0].seen[v] + sums[1].seen[v], 1e-9f);
    for (size_t s = 0; s < 2; ++s) {
      for (size_t i = 0; i < kD; ++i) {
        const size_t at = v * kD + i;
        float* to = &out.systems[s].broad[4 * at];
        to[0] = sums[s].body[at] / seen;
        to[1] = (sums[s].mirror[at] / seen + kUnseenFacets * 0.25f) / (closed_form(out.systems[s], w[i], w[v]) + kUnseenFacets);
        to[2] = sums[s].hair[at] / seen;
        to[3] = sums[s].seen[v] / seen;
      }
    }
  }
  return out;
}

}  // namespace weftlight
