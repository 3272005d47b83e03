// Based on: Olano, Baker, LEAN Mapping, 2010 (moments of slopes); Kaplanyan, Hill, Patney, Lefohn, Filtering
//   Distributions of Normals for Shading Antialiasing, 2016 (alpha^2 grows by twice the variance lost).
// Differs: normals are averaged as unit vectors and slopes are measured about that mean, since the slopes at the edge
// of a
//   round thread are unbounded.

#include "texture_set/surface_texels.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/loops.h"
#include "light/engine_fit.h"
#include "light/engine_texels.h"
#include "platform/vectors.h"

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

/// Texels of a row of the maps, whose normals, lobes and roots are computed at once for all of them, by vectors.
class MapRow {
 public:
  MapRow(const Cloth& cloth, const std::vector<YarnFacts>& yarns, const Maps& maps)
      : cloth_(cloth), yarns_(yarns), maps_(maps), blocks_(static_cast<size_t>(maps.colour.width) / kBlock + 1) {}

  void go_to(int y) {
    y_ = y;
    for (int x = 0; x < maps_.colour.width; ++x) {
      const Lobes& lobes = facts_at(x).lobes;
      Block& block = blocks_[static_cast<size_t>(x) / kBlock];
      block.along2[static_cast<size_t>(x) % kBlock] = lobes.along_width * lobes.along_width;
      block.across2[static_cast<size_t>(x) % kBlock] = lobes.across_width * lobes.across_width;
    }
    platform::with_widest_vectors([&] {
      for (size_t b = 0, first = 0; b < blocks_.size(); ++b, first += kBlock)
        measure(blocks_[b], std::min(static_cast<size_t>(maps_.colour.width) - first, kBlock),
                maps_.slope.row(y_) + first, maps_.tangent.row(y_) + first, maps_.colour.row(y_) + first);
    });
  }

  SurfaceTexel at(int x) const {
    const auto& [lobes, tint] = facts_at(x);
    const Block& block = blocks_[static_cast<size_t>(x) / kBlock];
    const size_t i = static_cast<size_t>(x) % kBlock;
    const Linear colour = scaled(maps_.colour.at(x, y_), maps_.groove.at(x, y_));
    const Direction fibre = maps_.tangent.at(x, y_);
    SurfaceTexel out;
    out.base =
        lobes.metallic ? Linear{colour.r * tint.r, colour.g * tint.g, colour.b * tint.b} : scaled(colour, lobes.body);
    // Light meets less dye in a single fibre, so the colour is the square root of the dye.
    out.sheen = scaled({block.r[i], block.g[i], block.b[i]}, lobes.fuzz);
    out.transmitted = lobes.metallic ? Linear{} : scaled(out.base, lobes.transmission);
    out.coverage = maps_.coverage.at(x, y_);
    out.height_mm = maps_.height_mm.at(x, y_);
    out.occlusion = maps_.occlusion.at(x, y_);
    out.metal = lobes.metallic ? 1.0f : 0.0f;
    out.sheen_roughness = lobes.fuzz_width;
    out.normal = {block.x[i], block.y[i], block.z[i]};
    out.fibre = {fibre.x, fibre.y, fibre.z};
    out.slope_cov = {block.xx[i], block.xy[i], block.yy[i]};
    out.thread = maps_.thread.at(x, y_);
    out.system = maps_.system.at(x, y_);
    return out;
  }

 private:
  static constexpr size_t kBlock = 64;
  using Values = std::array<float, kBlock>;
  struct Block {
    Values along2, across2;  // squared widths of the lobe
    Values x, y, z;          // normal
    Values xx, xy, yy;       // covariance of the lobe
    Values r, g, b;          // roots of the dye
  };

  const YarnFacts& facts_at(int x) const {
    const ThreadBody& body = (maps_.system.at(x, y_) == 0 ? cloth_.ends : cloth_.picks)[maps_.thread.at(x, y_)];
    return yarns_[static_cast<size_t>(body.yarn)];
  }
  static void measure(Block& __restrict out, size_t count, const Slope* __restrict slope,
                      const Direction* __restrict fibre, const Linear* __restrict dye) {
    for (size_t i = 0; i < count; ++i) {
      const float sx = slope[i].x, sy = slope[i].y, length = std::sqrt(sx * sx + sy * sy + 1.0f);
      const float x = sx / length, y = sy / length, z = 1.0f / length;
      const auto [xx, xy, yy] =
          facet_covariance(x, y, z, fibre[i].x, fibre[i].y, fibre[i].z, out.along2[i], out.across2[i]);
      out.x[i] = x, out.y[i] = y, out.z[i] = z;
      out.xx[i] = xx, out.xy[i] = xy, out.yy[i] = yy;
    }
    for (size_t i = 0; i < count; ++i)
      out.r[i] = std::sqrt(dye[i].r), out.g[i] = std::sqrt(dye[i].g), out.b[i] = std::sqrt(dye[i].b);
  }

  const Cloth& cloth_;
  const std::vector<YarnFacts>& yarns_;
  const Maps& maps_;
  int y_ = 0;
  std::vector<Block> blocks_;
};

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
    std::vector<MapRow> rows(static_cast<size_t>(block_y), MapRow(cloth, yarns, maps));
    for (int j = 0; j < block_y; ++j) rows[static_cast<size_t>(j)].go_to(y * block_y + j);
    for (int x = 0; block_x * block_y == 1 && x < width; ++x) out.texels.at(x, y) = rows.front().at(x);
    if (block_x * block_y == 1) return;
    std::vector<SurfaceTexel> parts(static_cast<size_t>(block_x) * static_cast<size_t>(block_y));
    for (int x = 0; x < width; ++x) {
      size_t n = 0;
      for (const MapRow& row : rows) {
        for (int i = 0; i < block_x; ++i) parts[n++] = row.at(x * block_x + i);
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
