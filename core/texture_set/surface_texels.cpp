// Based on: Olano, Baker, LEAN Mapping, 2010 (moments of slopes); Kaplanyan, Hill, Patney, Lefohn, Filtering
//   Distributions of Normals for Shading Antialiasing, 2016 (alpha^2 grows by twice the variance lost).
// Differs: normals are averaged as unit vectors and slopes are measured about that mean, since the slopes at the edge
// of a
//   round thread are unbounded.

#include "texture_set/surface_texels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/loops.h"
#include "light/engine_fit.h"

namespace weftlight::texture_set {

using base::for_each_job;
using cloth::Direction, cloth::Slope, cloth::ThreadBody, cloth::linear_from_srgb;
using design::Lobes, design::Yarn;
using light::FacetAlphas, light::facet_alphas, light::facet_covariance;

namespace {

// A gap has no colour, but engines filter across its edge, so its colour has a small weight.
constexpr float kGapWeight = 1e-4f;
// Limit for slopes about the mean (76 degrees), so that one grazing texel does not widen the lobe.
constexpr float kMaxSlope = 4.0f;
constexpr float kTurn = 6.28318531f;

glm::vec3 unit(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-9f ? v / length : otherwise;
}

void add(Linear& sum, const Linear& v, float w) {
  sum.r += v.r * w;
  sum.g += v.g * w;
  sum.b += v.b * w;
}

Linear scaled(const Linear& c, float s) { return {c.r * s, c.g * s, c.b * s}; }

/// Tangent frame of a normal, aligned with the axes of the texture.
struct Axes {
  glm::vec3 t, b;
};

Axes axes_over(const glm::vec3& n) {
  const glm::vec3 t = unit({1 - n[0] * n[0], -n[0] * n[1], -n[0] * n[2]}, {0, 0, -1});
  return {t, glm::cross(n, t)};
}

/// The lobes of a yarn with values that are the same for all its texels (see yarn_lobes() in core/light).
struct YarnFacts {
  Lobes lobes;
  Linear tint;
};

std::vector<YarnFacts> yarn_facts(const std::vector<Yarn>& yarns) {
  std::vector<YarnFacts> out;
  for (const Yarn& yarn : yarns) {
    out.push_back({yarn.lobes, scaled(linear_from_srgb(yarn.lobes.specular_tint), yarn.lobes.specular)});
  }
  return out;
}

SurfaceTexel sample(const Cloth& cloth, const std::vector<YarnFacts>& yarns, const Maps& maps, int x, int y) {
  const uint8_t system = maps.system.at(x, y);
  const uint32_t thread = maps.thread.at(x, y);
  const ThreadBody& body = (system == 0 ? cloth.ends : cloth.picks)[thread];
  const auto& [lobes, tint] = yarns[static_cast<size_t>(body.yarn)];
  const Linear dye = maps.colour.at(x, y);
  const Linear colour = scaled(dye, maps.groove.at(x, y));
  SurfaceTexel out;
  out.base =
      lobes.metallic ? Linear{colour.r * tint.r, colour.g * tint.g, colour.b * tint.b} : scaled(colour, lobes.body);
  // Light meets less dye in a single fibre, so the colour is the square root of the dye.
  out.sheen = scaled({std::sqrt(dye.r), std::sqrt(dye.g), std::sqrt(dye.b)}, lobes.fuzz);
  out.transmitted = lobes.metallic ? Linear{} : scaled(out.base, lobes.transmission);
  out.coverage = maps.coverage.at(x, y);
  out.height_mm = maps.height_mm.at(x, y);
  out.occlusion = maps.occlusion.at(x, y);
  out.metal = lobes.metallic ? 1.0f : 0.0f;
  out.sheen_roughness = lobes.fuzz_width;
  const Slope slope = maps.slope.at(x, y);
  const Direction fibre = maps.tangent.at(x, y);
  out.normal = unit({slope.x, slope.y, 1}, {0, 0, 1});
  out.fibre = {fibre.x, fibre.y, fibre.z};
  out.slope_cov = facet_covariance(out.normal, out.fibre, lobes);
  out.thread = thread;
  out.system = system;
  return out;
}

float alpha_of(float variance) { return std::min(std::sqrt(2.0f * std::max(variance, 0.0f)), 1.0f); }

}  // namespace

SurfaceTexels blank_like(const SurfaceTexels& face, int width, int height) {
  SurfaceTexels out{face.width_mm, face.depth_mm, Plane<SurfaceTexel>(width, height)};
  out.low_mm = face.low_mm, out.high_mm = face.high_mm, out.smoothness = face.smoothness,
  out.first_turn = face.first_turn;
  return out;
}

HorizonTexels horizon_rows(const std::vector<Plane<uint8_t>>& planes, int width, int height, int y0, int y1) {
  HorizonTexels out;
  for (const Plane<uint8_t>& sharp : planes) {
    const int block_x = sharp.width / width, block_y = sharp.height / height;
    const float weight = 1.0f / (255.0f * static_cast<float>(block_x * block_y));
    Plane<float> mean(width, y1 - y0), spread(width, y1 - y0);
    for_each_job(y1 - y0, [&](int y) {
      for (int x = 0; x < width; ++x) {
        int64_t sum = 0, squares = 0;
        for (int j = 0; j < block_y; ++j) {
          const uint8_t* row = sharp.row((y0 + y) * block_y + j) + static_cast<ptrdiff_t>(x) * block_x;
          for (int i = 0; i < block_x; ++i) sum += row[i], squares += row[i] * row[i];
        }
        const float m = static_cast<float>(sum) * weight;
        mean.at(x, y) = m;
        spread.at(x, y) = std::sqrt(std::max(static_cast<float>(squares) * weight / 255.0f - m * m, 0.0f));
      }
    });
    out.mean.push_back(std::move(mean));
    out.spread.push_back(std::move(spread));
  }
  return out;
}

SurfaceTexel merged(std::span<const SurfaceTexel> parts) {
  SurfaceTexel out = parts.front();
  if (parts.size() == 1) return out;
  out.base = out.sheen = out.transmitted = {};
  out.coverage = out.height_mm = out.occlusion = out.metal = out.sheen_roughness = 0;
  out.slope_cov = {};
  glm::vec3 normal{}, fibre{};
  float total = 0, most = -1;
  for (const SurfaceTexel& p : parts) total += p.coverage + kGapWeight;
  const float each = 1.0f / static_cast<float>(parts.size());
  for (const SurfaceTexel& p : parts) {
    const float w = (p.coverage + kGapWeight) / total;
    add(out.base, p.base, w);
    add(out.sheen, p.sheen, w);
    add(out.transmitted, p.transmitted, w);
    out.coverage += p.coverage * each;
    out.height_mm += p.height_mm * each;
    out.occlusion += p.occlusion * w;
    out.metal += p.metal * w;
    out.sheen_roughness += p.sheen_roughness * w;
    normal += p.normal * w;
    fibre += p.fibre * (dot(p.fibre, parts.front().fibre) < 0 ? -w : w);  // the direction of a fibre has no sign
    if (w > most) most = w, out.thread = p.thread, out.system = p.system;
  }
  out.normal = unit(normal, {0, 0, 1});
  out.fibre = unit(fibre, parts.front().fibre);
  const Axes axes = axes_over(out.normal);
  for (const SurfaceTexel& p : parts) {
    const float w = (p.coverage + kGapWeight) / total;
    const float up = std::max(dot(p.normal, out.normal), 1.0f / kMaxSlope);
    const float x = std::clamp(dot(p.normal, axes.t) / up, -kMaxSlope, kMaxSlope);
    const float y = std::clamp(dot(p.normal, axes.b) / up, -kMaxSlope, kMaxSlope);
    out.slope_cov += (p.slope_cov + glm::vec3(x * x, x * y, y * y)) * w;
  }
  return out;
}

SurfaceTexels make_surface(const Cloth& cloth, const Maps& maps, int width, int height, int threads) {
  const int block_x = maps.colour.width / width, block_y = maps.colour.height / height;
  assert(block_x * width == maps.colour.width && block_y * height == maps.colour.height);
  SurfaceTexels out{maps.width_mm, maps.depth_mm, Plane<SurfaceTexel>(width, height)};
  const std::vector<YarnFacts> yarns = yarn_facts(cloth.yarns);
  for_each_job(height, threads, [&](int y) {
    std::vector<SurfaceTexel> parts(static_cast<size_t>(block_x) * static_cast<size_t>(block_y));
    for (int x = 0; x < width; ++x) {
      if (parts.size() == 1) {
        out.texels.at(x, y) = sample(cloth, yarns, maps, x, y);
        continue;
      }
      size_t n = 0;
      for (int j = 0; j < block_y; ++j) {
        for (int i = 0; i < block_x; ++i) parts[n++] = sample(cloth, yarns, maps, x * block_x + i, y * block_y + j);
      }
      out.texels.at(x, y) = merged(parts);
    }
  });
  return out;
}

SurfaceTexels half_of(const SurfaceTexels& fine, int threads) {
  const int width = std::max(fine.texels.width / 2, 1), height = std::max(fine.texels.height / 2, 1);
  const int step_x = fine.texels.width / width, step_y = fine.texels.height / height;
  SurfaceTexels out = blank_like(fine, width, height);
  for_each_job(height, threads, [&](int y) {
    std::array<SurfaceTexel, 4> parts;
    for (int x = 0; x < width; ++x) {
      size_t n = 0;
      for (int j = 0; j < step_y; ++j) {
        for (int i = 0; i < step_x; ++i) parts[n++] = fine.texels.at(x * step_x + i, y * step_y + j);
      }
      out.texels.at(x, y) = merged({parts.data(), n});
    }
  });
  return out;
}

GgxAlphas ggx_alphas(const SurfaceTexel& texel) {
  const FacetAlphas a = facet_alphas(texel.slope_cov);
  GgxAlphas out{a.alpha.x, a.alpha.y, {a.axis.x, a.axis.y}};
  // The sign of the axis is free: +u for warp and +v for weft make neighbours agree, so that engines can filter the
  // axis whatever the twist.
  if (out.wide_axis[texel.system] < 0) out.wide_axis = {-out.wide_axis[0], -out.wide_axis[1]};
  return out;
}

float axis_cut(std::span<const SurfaceTexel> texels) {
  constexpr int kBins = 32;
  std::array<float, kBins> axes{};
  const auto turn_of = [](float bin) { return 0.5f * bin / kBins; };
  for (const SurfaceTexel& t : texels) {
    const GgxAlphas a = ggx_alphas(t);
    const int bin = static_cast<int>(2 * kBins * axis_turn(a.wide_axis, 0));
    axes[static_cast<size_t>(std::clamp(bin, 0, kBins - 1))] += t.coverage * (a.wide - a.narrow);
  }
  float cut = 0, least = std::numeric_limits<float>::max();
  for (int at = 0; at < kBins; ++at) {
    float near = 0;
    for (int bin = 0; bin < kBins; ++bin) {
      const float c = std::cos(kTurn * (turn_of(static_cast<float>(bin) + 0.5f) - turn_of(static_cast<float>(at))));
      near += axes[static_cast<size_t>(bin)] * std::pow(c, 8.0f);
    }
    if (near < least) least = near, cut = turn_of(static_cast<float>(at));
  }
  return cut;
}

float axis_turn(const std::array<float, 2>& axis, float first_turn) {
  const float turns = 2 * (std::atan2(axis[1], axis[0]) / kTurn - first_turn), half_turn = turns - std::floor(turns);
  return first_turn + 0.5f * half_turn;
}

std::array<float, 2> ggx_along_across(const SurfaceTexel& texel) {
  const Axes axes = axes_over(texel.normal);
  const float x = dot(texel.fibre, axes.t), y = dot(texel.fibre, axes.b);
  const float length2 = std::max(x * x + y * y, 1e-12f);
  const float xx = texel.slope_cov[0], xy = texel.slope_cov[1], yy = texel.slope_cov[2];
  return {alpha_of((xx * x * x + 2 * xy * x * y + yy * y * y) / length2),
          alpha_of((xx * y * y - 2 * xy * x * y + yy * x * x) / length2)};
}

}  // namespace weftlight::texture_set
