#include "texture_set/face_source.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"

namespace weftlight::texture_set {
namespace {

constexpr int kMinSide = 16;
constexpr int kAzimuths = 16;                           // of the horizon, which occlusion is made from
constexpr int64_t kMaxCoarseTexels = int64_t{1} << 20;  // about 75 MB of maps
constexpr int64_t kMaxRawTexels = int64_t{1} << 22;     // with the horizons that raw sets keep
constexpr int64_t kMaxPieceTexels = int64_t{1} << 16;   // of the maps, about 5 MB
constexpr int kMaxPieceSide = 16384;                    // of a window of the maps
constexpr int kSmallSide = 1024;
constexpr int kSamplesAThread = 4;
// Texels a thread from which on one sample each will do: samples know what share of them a thread covers. Of a cotton
// twill at 64, colours then differ from those of 16 samples by 0.032 (RMS of linear light), normals by 0.059; of 4
// samples by 0.013 and 0.019. What differs is how sharp fibres are; means stay.
constexpr float kSmoothTexels = 64;
// What is known from afar (fit, footprints, sheet) needs no more: texels a thread, and a side.
constexpr float kCoarseTexels = 32;
constexpr int kCoarseSide = 512;
constexpr float kOcclusionTexels = 6;    // of the coarse maps, a thread, that show where it is dark
constexpr int kNodeSteps = 8;            // places between the middles of two footprints, a side
constexpr float kMeanOcclusion = 0.98f;  // the fit holds all other shade

/// Of the system that has fewer.
float texels_a_thread(const Cloth& cloth, int width, int height) {
  return std::min(static_cast<float>(width) / static_cast<float>(std::max<size_t>(cloth.ends.size(), 1)),
                  static_cast<float>(height) / static_cast<float>(std::max<size_t>(cloth.picks.size(), 1)));
}

/// Texels baked for each texel of the set, a side: one where threads are wide; else at least two, so that rims are
/// smooth and the spread of normals is known, and more where threads are finer than texels.
int supersampling(const Cloth& cloth, TextureSize size) {
  const float texels = texels_a_thread(cloth, size.width, size.height);
  if (texels >= kSmoothTexels) return 1;
  int factor = 2;
  while (factor < 8 && texels * static_cast<float>(factor) < kSamplesAThread) factor *= 2;
  return factor;
}

/// By how much the maps of the whole are coarser than the samples of the set, a side.
int coarsening(const Cloth& cloth, TextureSize size, int factor, bool horizon) {
  const int64_t most = horizon ? kMaxRawTexels : kMaxCoarseTexels;
  const int width = size.width * factor, height = size.height * factor;
  int shrink = 1;
  while (int64_t{width} / shrink * (int64_t{height} / shrink) > most) shrink *= 2;
  const auto ample = [&](int by) {
    return std::max(width, height) / by >= kCoarseSide &&
           texels_a_thread(cloth, width / by, height / by) >= kCoarseTexels;
  };
  while (!horizon && ample(2 * shrink)) shrink *= 2;
  return shrink;
}

/// A row of a periodic plane, between the middles of its texels; u and v in periods, 0..1.
template <class T>
class RowBetween {
 public:
  RowBetween(const Plane<T>& plane, float v) : width_(plane.width) {
    const float y = v * static_cast<float>(plane.height) - 0.5f;
    const int y0 = static_cast<int>(std::floor(y));
    share_ = y - static_cast<float>(y0);
    low_ = plane.row(inside(y0, plane.height)), high_ = plane.row(inside(y0 + 1, plane.height));
  }
  T at(float u) const {
    const float x = u * static_cast<float>(width_) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), a = inside(x0, width_), b = inside(x0 + 1, width_);
    const float fx = x - static_cast<float>(x0);
    const auto mix = [](const T& p, const T& q, float t) { return p + (q - p) * t; };
    return mix(mix(low_[a], low_[b], fx), mix(high_[a], high_[b], fx), share_);
  }

 private:
  static int inside(int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; }
  int width_;
  const T *low_, *high_;
  float share_;
};

/// Means of a plane of no more texels than so many a side; empty where it has no more. All sides are powers of two.
Plane<glm::vec3> within(const Plane<glm::vec3>& fine, int width, int height) {
  if (fine.width <= width && fine.height <= height) return {};
  Plane<glm::vec3> out(std::min(fine.width, width), std::min(fine.height, height));
  const int step_x = fine.width / out.width, step_y = fine.height / out.height;
  const float share = 1.0f / static_cast<float>(step_x * step_y);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) out.at(x / step_x, y / step_y) += fine.at(x, y) * share;
  return out;
}

Linear times(const Linear& c, const glm::vec3& f) {
  return {std::min(c.r * f.r, 1.0f), std::min(c.g * f.g, 1.0f), std::min(c.b * f.b, 1.0f)};
}

}  // namespace

TextureSize texture_size(float width_mm, float depth_mm, int size) {
  const float longer = std::max(width_mm, depth_mm);
  auto side = [&](float mm) {
    const double exact =
        static_cast<double>(size) * static_cast<double>(mm) / static_cast<double>(std::max(longer, 1e-6f));
    const double power = std::exp2(std::round(std::log2(std::max(exact, 1.0))));
    return std::clamp(static_cast<int>(power), std::min(kMinSide, size), size);
  };
  return {side(width_mm), side(depth_mm)};
}

FaceSource::FaceSource(Cloth cloth, const FaceOptions& options)
    : cloth_(std::move(cloth)), options_(options), factor_(supersampling(cloth_, options.size)) {
  const int width = options.size.width, height = options.size.height;
  const int shrink = coarsening(cloth_, options.size, factor_, options.horizon);
  const int coarse_x = std::max(width * factor_ / shrink, 1), coarse_y = std::max(height * factor_ / shrink, 1);
  Maps maps = bake(cloth_, {coarse_x, coarse_y, kAzimuths});
  if (options.fitted) measure(maps);
  const int small_x = std::min({width, kSmallSide, coarse_x}), small_y = std::min({height, kSmallSide, coarse_y});
  if (!options.horizon) maps.horizon.clear();
  small_ = make_surface(cloth_, maps, small_x, small_y);
  if (shrink == 1 && small_x == width && small_y == height) {
    whole_ = {small_.width_mm, small_.depth_mm, small_.texels, {}, {}};
  } else if (shrink == 1) {
    maps.horizon.clear();
    whole_ = make_surface(cloth_, maps, width, height);
  } else {
    const float threads = static_cast<float>(std::max(cloth_.ends.size(), cloth_.picks.size()));
    if (static_cast<float>(std::max(coarse_x, coarse_y)) >= kOcclusionTexels * threads)
      occlusion_ = std::move(maps.occlusion);
  }
  const int64_t row = int64_t{width} * factor_ * factor_;
  band_ = height;
  while (band_ > 1 && row * band_ > kMaxPieceTexels) band_ /= 2;
  measure_footprints();
  measure_means();
  finish(small_, 0, small_.texels.height, 0);
  measure_range();
}

void FaceSource::measure_range() {
  small_.low_mm = 1e9f, small_.high_mm = -1e9f;
  double sum = 0;
  for (const SurfaceTexel& t : small_.texels.at_) {
    small_.low_mm = std::min(small_.low_mm, t.height_mm), small_.high_mm = std::max(small_.high_mm, t.height_mm);
    const GgxAlphas a = ggx_alphas(t);
    sum += 1 - std::sqrt(std::sqrt(static_cast<double>(a.wide * a.narrow)));
  }
  small_.smoothness = static_cast<float>(sum / static_cast<double>(small_.texels.at_.size()));
}

void FaceSource::measure(const Maps& maps) {
  const EngineTexels texels = engine_texels(cloth_, maps, options_.footprint_mm);
  const ClothResponse response = cloth_response(cloth_, maps, kFitPlaces);
  fit_ = fit_engine(texels, cloth_, response, options_.model);
  older_fit_ = options_.older ? fit_engine(texels, cloth_, response, *options_.older) : fit_;
  share_ = texels.share;
  checks_ = check_engine(texels, cloth_, response, options_.model, fit_);
  scores_ = score_engine(texels, cloth_, response, options_.model, fit_);
}

void FaceSource::measure_footprints() {
  const float texel_mm = small_.width_mm / static_cast<float>(small_.texels.width);
  const float window_mm = lobe_window_mm(options_.footprint_mm, thread_spacing_mm(cloth_));
  const int step = 1 << std::max(static_cast<int>(std::lround(std::log2(std::max(window_mm / texel_mm, 1.0f)))), 0);
  if (share_ <= 0) return;
  const int step_x = std::min(step, small_.texels.width), step_y = std::min(step, small_.texels.height);
  Plane<glm::vec4> nodes(small_.texels.width / step_x, small_.texels.height / step_y);  // covariance; xx of the grain
  for_each_job(nodes.height, [&](int y) {
    for (int x = 0; x < nodes.width; ++x) {
      std::vector<LobePart> parts;
      for (int j = 0; j < step_y; ++j) {
        for (int i = 0; i < step_x; ++i) {
          const SurfaceTexel& t = small_.texels.at(x * step_x + i, y * step_y + j);
          parts.push_back({t.normal, t.slope_cov, grain_of(t.fibre), t.coverage});
        }
      }
      const FootprintLobe lobe = footprint_lobe(parts);
      nodes.at(x, y) = glm::vec4(lobe.covariance, lobe.grain.x);
    }
  });
  // Scaled at places so close that a straight line will do between them.
  footprints_ =
      Plane<glm::vec3>(nodes.width * std::min(step_x, kNodeSteps), nodes.height * std::min(step_y, kNodeSteps));
  for_each_job(footprints_.height, [&](int y) {
    const RowBetween row(nodes, (static_cast<float>(y) + 0.5f) / static_cast<float>(footprints_.height));
    for (int x = 0; x < footprints_.width; ++x) {
      const glm::vec4 at = row.at((static_cast<float>(x) + 0.5f) / static_cast<float>(footprints_.width));
      footprints_.at(x, y) = scaled_covariance({glm::vec3(at), {at.w, 1 - at.w}}, fit_.lobe);
    }
  });
}

void FaceSource::measure_means() {
  double cover = 0, count = 0, seen = 0;
  std::array<double, 3> base{};
  for (const SurfaceTexel& t : small_.texels.at_) {
    const double w = static_cast<double>(t.coverage);
    cover += w, count += 1, seen += w * static_cast<double>(t.occlusion);
    base[0] += w * static_cast<double>(t.base.r), base[1] += w * static_cast<double>(t.base.g);
    base[2] += w * static_cast<double>(t.base.b);
  }
  coverage_ = static_cast<float>(cover / std::max(count, 1.0));
  const double over = 1 / std::max(cover, 1e-9);
  mean_base_ = times(
      {static_cast<float>(base[0] * over), static_cast<float>(base[1] * over), static_cast<float>(base[2] * over)},
      fit_.base);
  if (!options_.fitted) return;
  // The least gain whose mean is wanted; what is bright already stays at 1.
  std::vector<std::array<float, 2>> seen_texels;  // coverage, occlusion
  for (const SurfaceTexel& t : small_.texels.at_) seen_texels.push_back({t.coverage, t.occlusion});
  float low = 1, high = 8;
  for (int round = 0; round < 12; ++round) {
    const float gain = 0.5f * (low + high);
    double sum = 0;
    for (const auto& [covered, occlusion] : seen_texels)
      sum += static_cast<double>(covered * std::min(occlusion * gain, 1.0f));
    (sum * over < static_cast<double>(kMeanOcclusion) ? low : high) = gain;
  }
  occlusion_gain_ = high;
}

void FaceSource::finish(Surface& surface, int y0, int whole_height, int threads) const {
  if (!options_.fitted) return;
  const int width = surface.texels.width, height = surface.texels.height;
  const Plane<glm::vec3> coarser = within(footprints_, width, whole_height);
  const Plane<glm::vec3>& footprints = coarser.width > 0 ? coarser : footprints_;
  for_each_job(height, threads, [&](int y) {
    SurfaceTexel* const row = surface.texels.row(y);
    if (footprints.width > 0) {
      const RowBetween lobes(footprints, (static_cast<float>(y0 + y) + 0.5f) / static_cast<float>(whole_height));
      for (int x = 0; x < width; ++x)
        measure_footprint(row[x], lobes.at((static_cast<float>(x) + 0.5f) / static_cast<float>(width)));
    }
    for (int x = 0; x < width; ++x) {
      SurfaceTexel& t = row[x];
      t.base = times(t.base, fit_.base);
      t.sheen = times(t.sheen, glm::vec3(fit_.sheen));
      t.sheen_roughness = fit_.sheen_roughness;
      t.occlusion = std::min(t.occlusion * occlusion_gain_, 1.0f);
    }
  });
}

void FaceSource::measure_footprint(SurfaceTexel& texel, const glm::vec3& lobe) const {
  texel.slope_cov = glm::mix(texel.slope_cov, lobe, share_);
  // Whose way its lobe runs, the longer part of the wider axis: so that neighbours agree, as those of one system do.
  if (share_ > 0.5f) texel.system = texel.slope_cov.z > texel.slope_cov.x ? 1 : 0;
}

Surface FaceSource::piece(int x0, int x1, int y0, int y1) const {
  const MapsSize whole{options_.size.width * factor_, options_.size.height * factor_,
                       occlusion_.width > 0 ? 0 : kAzimuths, 1};
  Maps maps = bake(cloth_, whole, {x0 * factor_, y0 * factor_, x1 * factor_, y1 * factor_});
  maps.horizon.clear();
  return make_surface(cloth_, maps, x1 - x0, y1 - y0, 1);
}

Surface FaceSource::rows(int y0, int y1) const { return finished(raw_rows(y0, y1), y0, options_.size.height); }

Surface FaceSource::finished(Surface raw, int y0, int level_height) const {
  finish(raw, y0, level_height, 1);
  return raw;
}

Surface FaceSource::raw_rows(int y0, int y1) const {
  const int width = options_.size.width;
  Surface out{small_.width_mm, small_.depth_mm, Plane<SurfaceTexel>(width, y1 - y0), {}, {}};
  out.low_mm = small_.low_mm, out.high_mm = small_.high_mm, out.smoothness = small_.smoothness;
  if (whole_.texels.width > 0) {
    std::copy(whole_.texels.row(y0), whole_.texels.row(y0) + static_cast<ptrdiff_t>(width) * (y1 - y0),
              out.texels.at_.begin());
    return out;
  }
  const int step = std::min(width, kMaxPieceSide / factor_);
  for (int x = 0; x < width; x += step) {
    const Surface part = piece(x, x + step, y0, y1);
    for (int y = 0; y < y1 - y0; ++y) std::copy_n(part.texels.row(y), step, out.texels.row(y) + x);
  }
  for (int y = y0; occlusion_.width > 0 && y < y1; ++y) {
    const RowBetween seen(occlusion_, (static_cast<float>(y) + 0.5f) / static_cast<float>(options_.size.height));
    for (int x = 0; x < width; ++x)
      out.texels.at(x, y - y0).occlusion = seen.at((static_cast<float>(x) + 0.5f) / static_cast<float>(width));
  }
  return out;
}

}  // namespace weftlight::texture_set
