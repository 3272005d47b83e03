// Averages surface samples into the texels of the maps, then bakes horizons and occlusion.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "cloth/bake_parts.h"
#include "cloth/layers.h"

namespace weftlight::cloth {

using base::for_each_job;

namespace {

constexpr int kBandRows = 32;
constexpr int kLargestMap = 16384, kLargestWhole = 1 << 22, kMaxAzimuths = 64;
// Threads further than this many spacings away are taken to cast no shadow over nearer ones.
constexpr float kShadowReach = 4.0f;

/// Mean of the samples of one texel, weighted by their coverage.
class TexelSum {
 public:
  void add(const SurfaceSample& s) {
    const float w = s.cover;
    cover_ += w;
    height_ += w * s.height_mm, groove_ += w * s.groove;
    r_ += w * s.colour.r, g_ += w * s.colour.g, b_ += w * s.colour.b;
    sx_ += w * s.slope.x, sy_ += w * s.slope.y;
    Side& side = sides_[s.system];
    side.cover += w;
    side.x += w * s.tangent.x, side.y += w * s.tangent.y, side.z += w * s.tangent.z;
    if (w > side.best) side.best = w, side.thread = s.thread;
  }
  /// Mean over `samples` samples; `ground` is any of them, for a texel without coverage.
  SurfaceSample mean(const SurfaceSample& ground, int samples) const {
    if (cover_ <= 0.0f) return ground;
    const float k = 1.0f / cover_;
    const uint8_t system = sides_[0].cover >= sides_[1].cover ? 0 : 1;
    const Side& side = sides_[system];
    const float length = std::sqrt(side.x * side.x + side.y * side.y + side.z * side.z);
    SurfaceSample s;
    s.height_mm = height_ * k, s.groove = groove_ * k;
    s.cover = std::min(1.0f, cover_ / static_cast<float>(samples));
    s.colour = {r_ * k, g_ * k, b_ * k};
    s.slope = {sx_ * k, sy_ * k};
    s.tangent = length > 0.0f ? Direction{side.x / length, side.y / length, side.z / length} : ground.tangent;
    s.system = system, s.thread = side.thread;
    return s;
  }

 private:
  struct Side {
    float cover = 0, x = 0, y = 0, z = 0, best = 0;
    uint32_t thread = 0;
  };
  float cover_ = 0, height_ = 0, groove_ = 0, r_ = 0, g_ = 0, b_ = 0, sx_ = 0, sy_ = 0;
  Side sides_[2];
};

/// Writes everything but the height.
void put(Maps& m, int x, int y, const SurfaceSample& s) {
  m.coverage.at(x, y) = s.cover;
  m.colour.at(x, y) = s.colour;
  m.groove.at(x, y) = s.groove;
  m.slope.at(x, y) = s.slope;
  m.tangent.at(x, y) = s.tangent;
  m.system.at(x, y) = s.system;
  m.thread.at(x, y) = s.thread;
}

/// Calls put(x, y, sample) for the texels of a rectangle inside the period.
template <class Put>
void sample_texels(const Cloth& cloth, std::span<const Cloth> layers, const SampleGrid& grid, const TexelRect& r,
                   const Put& put) {
  const int nx = grid.per_texel_x, ny = grid.per_texel_y;
  LayeredSampler sampler(cloth, layers, grid, r.x0 * nx, r.x1 * nx, r.y0 * ny, r.y1 * ny);
  const size_t texels = static_cast<size_t>(r.x1 - r.x0);
  std::vector<SurfaceSample> row(texels * static_cast<size_t>(nx));
  std::vector<LayeredSampler::Beside> beside;
  std::vector<TexelSum> sums;
  for (int y = r.y0; y < r.y1; ++y) {
    if (nx * ny == 1) {
      sampler.row(y, row, beside);
      for (const auto& b : beside) {
        SurfaceSample& s = row[static_cast<size_t>(b.sample)];
        TexelSum sum;
        sum.add(s);
        sum.add(b.shows);
        s = sum.mean(s, 1);
      }
      for (size_t t = 0; t < texels; ++t) put(r.x0 + static_cast<int>(t), y, row[t]);
      continue;
    }
    sums.assign(texels, {});
    for (int j = 0; j < ny; ++j) {
      sampler.row(y * ny + j, row, beside);
      for (size_t i = 0; i < row.size(); ++i) sums[i / static_cast<size_t>(nx)].add(row[i]);
      for (const auto& b : beside) sums[static_cast<size_t>(b.sample / nx)].add(b.shows);
    }
    for (size_t t = 0; t < texels; ++t)
      put(r.x0 + static_cast<int>(t), y, sums[t].mean(row[t * static_cast<size_t>(nx)], nx * ny));
  }
}

/// Runs over bands of rows.
template <class Job>
void for_each_row_band(int rows, int threads, const Job& job) {
  for_each_job((rows + kBandRows - 1) / kBandRows, threads,
               [&](int band) { job(band * kBandRows, std::min(rows, (band + 1) * kBandRows)); });
}

int width_of(const TexelRect& r) { return r.x1 - r.x0; }
int height_of(const TexelRect& r) { return r.y1 - r.y0; }

Maps empty_maps(int w, int h, const MapsSize& size) {
  Maps m;
  m.azimuths = std::clamp(size.azimuths, 0, kMaxAzimuths);
  m.horizon.resize(static_cast<size_t>(m.azimuths));
  // Filling the planes is bound by memory, so it runs in parallel too.
  const auto make = [&](int i) {
    switch (i) {
      case 0:
        m.coverage = Plane<float>(w, h);
        break;
      case 1:
        m.colour = Plane<Linear>(w, h);
        break;
      case 2:
        m.groove = Plane<float>(w, h, 1.0f);
        break;
      case 3:
        m.slope = Plane<Slope>(w, h);
        break;
      case 4:
        m.tangent = Plane<Direction>(w, h);
        break;
      case 5:
        m.system = Plane<uint8_t>(w, h);
        break;
      case 6:
        m.thread = Plane<uint32_t>(w, h);
        break;
      default:
        m.occlusion = Plane<float>(w, h, 1.0f);
        break;
    }
  };
  for_each_job(8, size.threads, make);
  return m;
}

/// The heights that the horizons of a window depend on, cut to one period.
TexelRect field_around(const TexelRect& window, const std::vector<Sweep>& sweeps, int w, int h) {
  int x = 0, y = 0;
  for (const Sweep& s : sweeps) {
    const int along = s.block + s.ahead;
    const int aside = static_cast<int>(std::ceil(std::abs(s.shear) * along)) + kSweepMargin;
    x = std::max(x, s.along_x ? along : aside), y = std::max(y, s.along_x ? aside : along);
  }
  TexelRect field{window.x0 - x, window.y0 - y, window.x1 + x, window.y1 + y};
  if (width_of(field) >= w) field.x0 = 0, field.x1 = w;
  if (height_of(field) >= h) field.y0 = 0, field.y1 = h;
  return field;
}

/// Cuts a window out of a field; both are in texels of a period of w x h.
template <class T>
Plane<T> cut_out(Plane<T> field, const TexelRect& at, const TexelRect& window, int w, int h) {
  if (field.width == width_of(window) && field.height == height_of(window) && at.x0 == window.x0 && at.y0 == window.y0)
    return field;
  Plane<T> out(width_of(window), height_of(window));
  for (int y = 0; y < out.height; ++y) {
    const T* from = field.row(wrap(window.y0 + y - at.y0, h));
    for (int x = 0, f = wrap(window.x0 - at.x0, w); x < out.width; ++x, f = f + 1 == w ? 0 : f + 1)
      out.at(x, y) = from[f];
  }
  return out;
}

/// Returns the heights of the field and bakes everything else of the window into `maps`.
Plane<float> bake_field(Maps& maps, const Cloth& cloth, const SampleGrid& grid, const TexelRect& field,
                        const TexelRect& window, int threads) {
  const int w = grid.width, h = grid.height;
  std::vector<TexelRect> bands;
  for (const TexelRect& r : pieces(field, w, h))
    for (int y = r.y0; y < r.y1; y += kBandRows) bands.push_back({r.x0, y, r.x1, std::min(r.y1, y + kBandRows)});
  Plane<float> height(width_of(field), height_of(field));
  const std::vector<Cloth> layers = layers_apart(cloth);
  const int wx = wrap(window.x0, w), wy = wrap(window.y0, h);
  for_each_job(static_cast<int>(bands.size()), threads, [&](int i) {
    const TexelRect& r = bands[static_cast<size_t>(i)];
    const int to_x = wrap(r.x0 - field.x0, w) - r.x0, to_y = wrap(r.y0 - field.y0, h) - r.y0;
    sample_texels(cloth, layers, grid, r, [&](int x, int y, const SurfaceSample& s) {
      height.at(x + to_x, y + to_y) = s.height_mm;
      const int in_x = x < wx ? x - wx + w : x - wx, in_y = y < wy ? y - wy + h : y - wy;
      if (in_x < maps.coverage.width && in_y < maps.coverage.height) put(maps, in_x, in_y, s);
    });
  });
  return height;
}

std::vector<Sweep> sweeps_of(const Cloth& cloth, int w, int h, int azimuths) {
  std::vector<Sweep> sweeps;
  for (int k = 0; k < azimuths; ++k) sweeps.push_back(sweep_of(cloth, w, h, azimuths, k));
  return sweeps;
}

/// The horizons of a window from the heights of the field around it.
void sweep_field(Maps& maps, const Plane<float>& height, const std::vector<Sweep>& sweeps, const TexelRect& field,
                 const TexelRect& window, const MapsSize& whole) {
  const Plane<float> turned = maps.azimuths > 0 ? transposed(height) : Plane<float>{};
  for_each_job(maps.azimuths, whole.threads, [&](int k) {
    Sweep s = sweeps[static_cast<size_t>(k)];
    s.first = s.along_x ? field.x0 : field.y0, s.first_line = s.along_x ? field.y0 : field.x0;
    maps.horizon[static_cast<size_t>(k)] =
        cut_out(horizon(height, turned, s, window), field, window, whole.width, whole.height);
  });
}

void bake_occlusion_rows(Maps& maps, int width, int height, int threads) {
  for_each_row_band(height, threads, [&](int y0, int y1) { bake_occlusion(maps, {0, y0, width, y1}); });
}

TexelRect cut_to_period(const TexelRect& window, int w, int h) {
  const int x1 = window.x0 + std::clamp(width_of(window), 1, std::min(w, kLargestMap));
  const int y1 = window.y0 + std::clamp(height_of(window), 1, std::min(h, kLargestMap));
  return {window.x0, window.y0, x1, y1};
}

}  // namespace

Sweep sweep_of(const Cloth& cloth, int width, int height, int azimuths, int k) {
  const double azimuth = 2.0 * std::numbers::pi * k / azimuths;
  const float layers = static_cast<float>(layer_count(cloth));
  const float spacing = std::max(layers * cloth.width_mm / static_cast<float>(cloth.ends.size()),
                                 layers * cloth.depth_mm / static_cast<float>(cloth.picks.size()));
  return sweep_towards(azimuth, width, height, cloth.width_mm / static_cast<float>(width),
                       cloth.depth_mm / static_cast<float>(height), kShadowReach * spacing);
}

void bake_occlusion(Maps& maps, const TexelRect& r) {
  if (maps.azimuths == 0) return;
  const float scale = 1.0f / (255.0f * 255.0f * static_cast<float>(maps.azimuths));
  std::vector<int> sum(static_cast<size_t>(r.x1 - r.x0));
  for (int y = r.y0; y < r.y1; ++y) {
    std::fill(sum.begin(), sum.end(), 0);
    for (const auto& plane : maps.horizon) {
      const uint8_t* row = plane.row(y) + r.x0;
      for (size_t i = 0; i < sum.size(); ++i) sum[i] += row[i] * row[i];
    }
    float* out = maps.occlusion.row(y) + r.x0;
    for (size_t i = 0; i < sum.size(); ++i) out[i] = 1.0f - static_cast<float>(sum[i]) * scale;
  }
}

void bake_surface(Maps& maps, const Cloth& cloth, const SampleGrid& grid, const TexelRect& r) {
  sample_texels(cloth, layers_apart(cloth), grid, r, [&](int x, int y, const SurfaceSample& s) {
    maps.height_mm.at(x, y) = s.height_mm;
    put(maps, x, y, s);
  });
}

Maps bake(const Cloth& cloth, const MapsSize& size) {
  MapsSize whole = size;
  whole.width = std::clamp(size.width, 1, kLargestMap), whole.height = std::clamp(size.height, 1, kLargestMap);
  return bake(cloth, whole, {0, 0, whole.width, whole.height});
}

Maps bake(const Cloth& cloth, const MapsSize& size, const TexelRect& window) {
  MapsSize whole = size;
  whole.width = std::clamp(size.width, 1, kLargestWhole), whole.height = std::clamp(size.height, 1, kLargestWhole);
  const int w = whole.width, h = whole.height;
  const TexelRect shown = cut_to_period(window, w, h);
  Maps maps = empty_maps(width_of(shown), height_of(shown), whole);
  maps.width_mm = cloth.width_mm * (static_cast<float>(width_of(shown)) / static_cast<float>(w));
  maps.depth_mm = cloth.depth_mm * (static_cast<float>(height_of(shown)) / static_cast<float>(h));
  if (is_empty(cloth)) {
    maps.height_mm = Plane<float>(width_of(shown), height_of(shown));
    for (auto& plane : maps.horizon) plane = Plane<uint8_t>(width_of(shown), height_of(shown));
    return maps;
  }
  const std::vector<Sweep> sweeps = sweeps_of(cloth, w, h, maps.azimuths);
  const TexelRect field = field_around(shown, sweeps, w, h);
  Plane<float> height =
      bake_field(maps, cloth, sample_grid(cloth, w, h, whole.samples_a_thread), field, shown, whole.threads);
  sweep_field(maps, height, sweeps, field, shown, whole);
  maps.height_mm = cut_out(std::move(height), field, shown, w, h);
  bake_occlusion_rows(maps, width_of(shown), height_of(shown), whole.threads);
  return maps;
}

Maps bake_horizons(const Cloth& cloth, const MapsSize& size) {
  MapsSize whole = size;
  whole.width = std::clamp(size.width, 1, kLargestMap), whole.height = std::clamp(size.height, 1, kLargestMap);
  const int w = whole.width, h = whole.height;
  const TexelRect all{0, 0, w, h};
  Maps maps;
  maps.width_mm = cloth.width_mm, maps.depth_mm = cloth.depth_mm;
  maps.azimuths = std::clamp(whole.azimuths, 0, kMaxAzimuths);
  maps.horizon.resize(static_cast<size_t>(maps.azimuths));
  maps.occlusion = Plane<float>(w, h, 1.0f);
  if (is_empty(cloth)) {
    for (auto& plane : maps.horizon) plane = Plane<uint8_t>(w, h);
    return maps;
  }
  // No texel is in maps whose planes are empty, so that only heights are kept.
  const Plane<float> height =
      bake_field(maps, cloth, sample_grid(cloth, w, h, whole.samples_a_thread), all, all, whole.threads);
  sweep_field(maps, height, sweeps_of(cloth, w, h, maps.azimuths), all, all, whole);
  bake_occlusion_rows(maps, w, h, whole.threads);
  return maps;
}

Plane<uint8_t> shadow_map(const Maps& maps, float light_azimuth_rad, float light_elevation_rad) {
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  Plane<uint8_t> lit(w, h);
  if (w == 0 || h == 0 || !(maps.width_mm > 0.0f) || !(maps.depth_mm > 0.0f)) return lit;
  const float dx = maps.width_mm / static_cast<float>(w), dy = maps.depth_mm / static_cast<float>(h);
  const Sweep sweep =
      sweep_towards(static_cast<double>(light_azimuth_rad), w, h, dx, dy, std::max(maps.width_mm, maps.depth_mm));
  const Plane<uint8_t> sines = horizon(maps.height_mm, sweep);
  const float light = 255.0f * std::sin(light_elevation_rad);
  for (size_t i = 0; i < lit.at_.size(); ++i) lit.at_[i] = light > static_cast<float>(sines.at_[i]) ? 1 : 0;
  return lit;
}

}  // namespace weftlight::cloth
