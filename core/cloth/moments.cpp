#include "cloth/moments.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"
#include "cloth/surface.h"

namespace weftlight::cloth {
namespace {

constexpr int kBandRows = 32;

/// Which texels of the longer axis a texel of the shorter one averages, and how much of each.
struct Taps {
  int first = 0;
  std::vector<float> weight;
};

std::vector<Taps> taps(int from, int to) {
  std::vector<Taps> out(static_cast<size_t>(to));
  // Exact in integers: texel i of `to` spans [i * from, (i + 1) * from) of from * to units.
  for (int i = 0; i < to; ++i) {
    const int64_t a = int64_t{i} * from, b = a + from;
    Taps& t = out[static_cast<size_t>(i)];
    t.first = static_cast<int>(a / to);
    for (int64_t j = t.first; j * to < b; ++j) {
      const int64_t overlap = std::min((j + 1) * to, b) - std::max(j * to, a);
      t.weight.push_back(static_cast<float>(static_cast<double>(overlap) / from));
    }
  }
  return out;
}

void add(SystemMoments& m, int x, int y, float weight, const SurfaceSample& s) {
  const float g = weight * s.groove;
  const float xx = s.slope.x * s.slope.x + (s.system == 0 ? s.slope_spread : 0.0f);
  const float yy = s.slope.y * s.slope.y + (s.system == 1 ? s.slope_spread : 0.0f);
  const float values[kMomentPlanes] = {weight,
                                       g * s.colour.r,
                                       g * s.colour.g,
                                       g * s.colour.b,
                                       weight * s.slope.x,
                                       weight * s.slope.y,
                                       weight * xx,
                                       weight * s.slope.x * s.slope.y,
                                       weight * yy};
  for (size_t p = 0; p < kMomentPlanes; ++p) m[p].at(x, y) += values[p];
}

void make_planes(MomentLevel& level, int width, int height) {
  level.width = width, level.height = height;
  for (SystemMoments* side : {&level.warp, &level.weft})
    for (auto& plane : *side) plane = Plane<float>(width, height);
}

/// Samples the surface into the finest level.
MomentLevel finest_level(const Cloth& cloth, int width, int height, int threads) {
  MomentLevel level;
  make_planes(level, width, height);
  if (cloth.ends.empty() || cloth.picks.empty()) return level;
  const SampleGrid grid = sample_grid(cloth, width, height);
  const int nx = grid.per_texel_x, ny = grid.per_texel_y;
  const float share = 1.0f / static_cast<float>(nx * ny);
  for_each_job((height + kBandRows - 1) / kBandRows, threads, [&](int band) {
    const int y0 = band * kBandRows, y1 = std::min(height, y0 + kBandRows);
    SurfaceSampler sampler(cloth, grid, 0, width * nx, y0 * ny, y1 * ny);
    std::vector<SurfaceSample> row(static_cast<size_t>(width * nx));
    std::vector<SurfaceSampler::Beside> beside;
    for (int y = y0 * ny; y < y1 * ny; ++y) {
      sampler.row(y, row, beside);
      const auto put = [&](int x, const SurfaceSample& s) {
        if (s.cover > 0.0f) add(s.system == 0 ? level.warp : level.weft, x / nx, y / ny, s.cover * share, s);
      };
      for (int x = 0; x < width * nx; ++x) put(x, row[static_cast<size_t>(x)]);
      for (const auto& b : beside) put(b.sample, b.shows);
    }
  });
  return level;
}

/// Runs a job for each of the 18 planes of a level.
template <class Job>
void for_each_plane(int threads, const Job& job) {
  for_each_job(2 * kMomentPlanes, threads, [&](int i) {
    job(i < kMomentPlanes ? &MomentLevel::warp : &MomentLevel::weft, static_cast<size_t>(i % kMomentPlanes));
  });
}

uint8_t unorm8(float v) { return static_cast<uint8_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); }

/// Mean and spread of one azimuth's horizon on all levels, weighted by coverage.
void filter_horizon(const Maps& maps, size_t k, std::vector<MomentLevel>& levels) {
  Plane<float> weight = maps.coverage, first = maps.coverage, second = maps.coverage;
  for (size_t i = 0; i < first.at_.size(); ++i) {
    const float s = static_cast<float>(maps.horizon[k].at_[i]) / 255.0f;
    first.at_[i] *= s;
    second.at_[i] *= s * s;
  }
  for (MomentLevel& level : levels) {
    weight = averaged(weight, level.width, level.height);
    first = averaged(first, level.width, level.height);
    second = averaged(second, level.width, level.height);
    Plane<uint8_t> mean(level.width, level.height), spread(level.width, level.height);
    for (size_t i = 0; i < first.at_.size(); ++i) {
      if (weight.at_[i] <= 0.0f) continue;
      const float m = first.at_[i] / weight.at_[i];
      mean.at_[i] = unorm8(m);
      spread.at_[i] = unorm8(std::sqrt(std::max(0.0f, second.at_[i] / weight.at_[i] - m * m)));
    }
    level.horizon[k] = std::move(mean);
    level.horizon_spread[k] = std::move(spread);
  }
}

}  // namespace

Plane<float> averaged(const Plane<float>& in, int width, int height) {
  if (in.width == width && in.height == height) return in;
  const std::vector<Taps> across = taps(in.width, width), down = taps(in.height, height);
  Plane<float> out(width, height);
  std::vector<float> column(static_cast<size_t>(in.width));
  for (int y = 0; y < height; ++y) {
    const Taps& rows = down[static_cast<size_t>(y)];
    std::fill(column.begin(), column.end(), 0.0f);
    for (size_t j = 0; j < rows.weight.size(); ++j) {
      const float* row = in.row(rows.first + static_cast<int>(j));
      for (size_t x = 0; x < column.size(); ++x) column[x] += rows.weight[j] * row[x];
    }
    for (int x = 0; x < width; ++x) {
      const Taps& t = across[static_cast<size_t>(x)];
      float sum = 0;
      for (size_t i = 0; i < t.weight.size(); ++i) sum += t.weight[i] * column[static_cast<size_t>(t.first) + i];
      out.at(x, y) = sum;
    }
  }
  return out;
}

std::vector<MomentLevel> moments(const Cloth& cloth, const Maps& maps, int width, int height, int threads) {
  std::vector<MomentLevel> levels;
  if (maps.coverage.at_.empty()) return levels;
  width = std::clamp(width, 1, maps.coverage.width);
  height = std::clamp(height, 1, maps.coverage.height);
  levels.push_back(finest_level(cloth, width, height, threads));
  while (width > 1 || height > 1) {
    width = std::max(1, width / 2), height = std::max(1, height / 2);
    MomentLevel level;
    level.width = width, level.height = height;
    for_each_plane(threads, [&](SystemMoments MomentLevel::*side, size_t p) {
      (level.*side)[p] = averaged((levels.back().*side)[p], width, height);
    });
    levels.push_back(std::move(level));
  }
  for (MomentLevel& level : levels) {
    level.horizon.resize(maps.horizon.size());
    level.horizon_spread.resize(maps.horizon.size());
  }
  for_each_job(static_cast<int>(maps.horizon.size()), threads,
               [&](int k) { filter_horizon(maps, static_cast<size_t>(k), levels); });
  return levels;
}

Facet facet_at(const SystemMoments& m, int x, int y) {
  Facet f;
  f.weight = m[kWeight].at(x, y);
  if (f.weight <= 1e-7f) return Facet{};
  const auto mean = [&](MomentPlane p) { return m[p].at(x, y) / f.weight; };
  f.colour = {mean(kRed), mean(kGreen), mean(kBlue)};
  f.slope = {mean(kSlopeX), mean(kSlopeY)};
  f.xx = std::max(0.0f, mean(kSlopeXX) - f.slope.x * f.slope.x);
  f.yy = std::max(0.0f, mean(kSlopeYY) - f.slope.y * f.slope.y);
  const float most = std::sqrt(f.xx * f.yy);
  f.xy = std::clamp(mean(kSlopeXY) - f.slope.x * f.slope.y, -most, most);
  return f;
}

}  // namespace weftlight::cloth
