#include "texture_set/face_source.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"
#include "light/measure_response.h"

namespace weftlight::texture_set {

using base::for_each_job;
using cloth::MapsSize, cloth::bake, cloth::bake_horizons;
using light::EnginePlane, light::EngineTexels, light::FootprintLobe, light::LobePart, light::check_engine,
    light::engine_texels, light::fit_engine, light::flattened, light::footprint_lobe, light::grain_of,
    light::kFitSamples, light::lobe_window_mm, light::measure_response, light::scaled_covariance, light::score_engine,
    light::refit_engine, light::score_plane, light::straightened, light::thread_spacing_mm;

namespace {

constexpr int kMinSide = 16;
constexpr int kAzimuths = 16;                           // of the horizon that gives the occlusion
constexpr int64_t kMaxCoarseTexels = int64_t{1} << 20;  // about 75 MB of maps
constexpr int64_t kMaxRawTexels = int64_t{1} << 22;     // with the horizons of raw sets
// Of the maps; about 3 MB. Memory of larger pieces went back to the system each time, and new pages cost more than
// filling them.
constexpr int64_t kMaxPieceTexels = int64_t{1} << 14;
constexpr int kMaxPieceSide = 16384;                  // of a window of the maps
constexpr int64_t kMaxBandTexels = int64_t{1} << 18;  // of the maps of a raw set, made on all cores; about 14 MB
constexpr int kSmallSide = 1024;
constexpr int kSamplesPerThread = 4;
// Texels per thread above which one sample per texel is enough, since samples hold the coverage of their thread. Error
// against 16 samples, cotton twill at 64 texels per thread, RMS of linear colour and of normals: 0.032 and 0.059 with
// one sample, 0.013 and 0.019 with four. Only the sharpness of fibres differs; means are equal.
constexpr float kSmoothTexels = 64;
// Enough for far-field properties (fit, footprints, contact sheet): texels per thread, and per side.
constexpr float kCoarseTexels = 32;
constexpr int kCoarseSide = 512;
// Of the part of a large tile, per thread, and most per side of its repeat.
constexpr int kPartTexels = 20, kPartSide = 1024;
constexpr float kOcclusionTexels = 6;    // texels per thread that coarse maps need for occlusion
constexpr int kNodeSteps = 8;            // samples between the middles of two footprints, per side
constexpr float kMeanOcclusion = 0.98f;  // the fit includes all other self-shadowing

/// For the thread system with fewer texels per thread.
float texels_per_thread(const Cloth& cloth, int width, int height) {
  return std::min(static_cast<float>(width) / static_cast<float>(std::max<size_t>(cloth.ends.size(), 1)),
                  static_cast<float>(height) / static_cast<float>(std::max<size_t>(cloth.picks.size(), 1)));
}

/// Factor by which the maps of the whole face are coarser than the samples of the set, per side.
int coarsening(const Cloth& cloth, TextureSize size, int factor, bool horizon) {
  const int64_t most = horizon ? kMaxRawTexels : kMaxCoarseTexels;
  const int width = size.width * factor, height = size.height * factor;
  int shrink = 1;
  while (int64_t{width} / shrink * (int64_t{height} / shrink) > most ||
         std::max(width, height) / shrink > kMaxPieceSide)
    shrink *= 2;
  const auto ample = [&](int by) {
    return std::max(width, height) / by >= kCoarseSide &&
           texels_per_thread(cloth, width / by, height / by) >= kCoarseTexels;
  };
  while (!horizon && ample(2 * shrink)) shrink *= 2;
  return shrink;
}

/// Texels along one repeat of a part.
int part_texels(size_t threads) { return std::clamp(kPartTexels * static_cast<int>(threads), 1, kPartSide); }

/// The mean of all repeats of a plane, each of width x height.
Plane<float> mean_repeat(const Plane<float>& all, int width, int height) {
  Plane<float> out(width, height);
  const float weight = 1.0f / static_cast<float>(all.width / width * (all.height / height));
  for (int y = 0; y < all.height; ++y)
    for (int x = 0; x < all.width; ++x) out.at(x % width, y % height) += all.at(x, y) * weight;
  return out;
}

/// Bilinear lookup along one row of a periodic plane; u and v in periods, 0..1.
template <class T>
class InterpolatedRow {
 public:
  InterpolatedRow(const Plane<T>& plane, float v) : width_(plane.width) {
    const float y = v * static_cast<float>(plane.height) - 0.5f;
    const int y0 = static_cast<int>(std::floor(y));
    weight_ = y - static_cast<float>(y0);
    low_ = plane.row(inside(y0, plane.height)), high_ = plane.row(inside(y0 + 1, plane.height));
  }
  T at(float u) const {
    const float x = u * static_cast<float>(width_) - 0.5f;
    const int x0 = static_cast<int>(std::floor(x)), a = inside(x0, width_), b = inside(x0 + 1, width_);
    const float fx = x - static_cast<float>(x0);
    const auto mix = [](const T& p, const T& q, float t) { return p + (q - p) * t; };
    return mix(mix(low_[a], low_[b], fx), mix(high_[a], high_[b], fx), weight_);
  }

 private:
  static int inside(int i, int n) { return i < 0 ? i + n : i >= n ? i - n : i; }
  int width_;
  const T *low_, *high_;
  float weight_;
};

/// The plane averaged down to at most width x height; empty if it is not larger. All sides are powers of two.
Plane<glm::vec3> averaged_down(const Plane<glm::vec3>& fine, int width, int height) {
  if (fine.width <= width && fine.height <= height) return {};
  Plane<glm::vec3> out(std::min(fine.width, width), std::min(fine.height, height));
  const int step_x = fine.width / out.width, step_y = fine.height / out.height;
  const float weight = 1.0f / static_cast<float>(step_x * step_y);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) out.at(x / step_x, y / step_y) += fine.at(x, y) * weight;
  return out;
}

Linear times(const Linear& c, const glm::vec3& f) {
  return {std::min(c.r * f.r, 1.0f), std::min(c.g * f.g, 1.0f), std::min(c.b * f.b, 1.0f)};
}

/// The same for a level of detail, whose material is measured on threads that are finer than its texels.
int supersampling_of(const Cloth& cloth, const FaceOptions& options) {
  constexpr float kSamples = 16;
  constexpr int kLargest = 2048;
  const TextureSize size = options.size;
  int factor = supersampling(cloth, size);
  if (options.detail == ThreadDetail::kAll) return factor;
  while (std::max(size.width, size.height) * factor < kLargest &&
         texels_per_thread(cloth, size.width * factor, size.height * factor) < kSamples)
    factor *= 2;
  return factor;
}

}  // namespace

int supersampling(const Cloth& cloth, TextureSize size) {
  const float texels = texels_per_thread(cloth, size.width, size.height);
  if (texels >= kSmoothTexels) return 1;
  int factor = 2;
  while (factor < 8 && texels * static_cast<float>(factor) < kSamplesPerThread) factor *= 2;
  return factor;
}

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

FaceSource::FaceSource(Tile tile, const FaceOptions& options)
    : tile_(std::move(tile)),
      options_(options),
      factor_(supersampling_of(tile_.cloth, options)),
      light_(options.light) {
  const int width = options.size.width, height = options.size.height;
  if (tile_.part && !options.horizon) make_from_part();
  else make_whole();
  const int64_t row = int64_t{width} * factor_ * factor_;
  band_ = height;
  while (band_ > 1 && row * band_ > kMaxPieceTexels) band_ /= 2;
  measure_lean();
  measure_footprints();
  measure_means();
  measure_mean_texel();
  finish(small_, 0, small_.texels.height, 0);
  measure_range();
}

void FaceSource::make_raw() {
  const Cloth& cloth = tile_.cloth;
  const int width = options_.size.width, height = options_.size.height;
  const int shrink = coarsening(cloth, options_.size, factor_, true);
  const int coarse_x = std::max(width * factor_ / shrink, 1), coarse_y = std::max(height * factor_ / shrink, 1);
  horizon_size_ = {std::min({width, kSmallSide, coarse_x}), std::min({height, kSmallSide, coarse_y})};
  // The whole face takes 100 MB at 1024, which is worth it only where its rows are those of the images.
  const int part = std::max(width, height) > kSmallSide ? 2 : 1;
  const int small_x = std::max(horizon_size_.width / part, 1), small_y = std::max(horizon_size_.height / part, 1);
  Maps sky = bake_horizons(cloth, {coarse_x, coarse_y, kAzimuths});
  horizons_ = std::move(sky.horizon);
  small_ = {cloth.width_mm, cloth.depth_mm, Plane<SurfaceTexel>(small_x, small_y)};
  const int block = coarse_y / small_y;
  int band = small_y;
  while (band > 1 && int64_t{coarse_x} * block * band > kMaxBandTexels) band /= 2;
  for (int y = 0; y < small_y; y += band) {
    Maps maps = bake(cloth, {coarse_x, coarse_y, 0}, {0, y * block, coarse_x, (y + band) * block});
    std::copy_n(sky.occlusion.row(y * block), maps.occlusion.at_.size(), maps.occlusion.row(0));
    const SurfaceTexels rows = make_surface(cloth, maps, small_x, band);
    std::ranges::copy(rows.texels.at_, small_.texels.row(y));
  }
  if (whole() != nullptr) return;
  (shrink == 1 ? sharp_occlusion_ : occlusion_) = std::move(sky.occlusion);
  const int threads = static_cast<int>(std::max(cloth.ends.size(), cloth.picks.size()));
  if (static_cast<float>(std::max(coarse_x, coarse_y)) < kOcclusionTexels * static_cast<float>(threads))
    occlusion_ = {};
}

void FaceSource::make_whole() {
  if (options_.horizon) return make_raw();
  const Cloth& cloth = tile_.cloth;
  const int width = options_.size.width, height = options_.size.height;
  const int shrink = coarsening(cloth, options_.size, factor_, false);
  const int coarse_x = std::max(width * factor_ / shrink, 1), coarse_y = std::max(height * factor_ / shrink, 1);
  Maps maps = bake(cloth, {coarse_x, coarse_y, kAzimuths});
  if (options_.fitted) measure(cloth, maps);
  const int small_x = std::min({width, kSmallSide, coarse_x}), small_y = std::min({height, kSmallSide, coarse_y});
  maps.horizon.clear();
  small_ = make_surface(cloth, maps, small_x, small_y);
  if (whole() != nullptr) return;
  if (shrink == 1 && small_x == width && small_y == height) {
    whole_ = small_;
  } else if (shrink == 1) {
    whole_ = make_surface(cloth, maps, width, height);
  } else {
    const float threads = static_cast<float>(std::max(cloth.ends.size(), cloth.picks.size()));
    if (static_cast<float>(std::max(coarse_x, coarse_y)) >= kOcclusionTexels * threads)
      occlusion_ = std::move(maps.occlusion);
  }
}

/// The unfitted face at its full size, if it is kept.
const SurfaceTexels* FaceSource::whole() const {
  if (whole_.texels.width > 0) return &whole_;
  const bool is_small =
      small_.texels.width == options_.size.width && small_.texels.height == options_.size.height && !options_.fitted;
  return is_small ? &small_ : nullptr;
}

void FaceSource::release() {
  small_.texels = {}, whole_.texels = {};
  horizons_ = {};
  occlusion_ = {}, sharp_occlusion_ = {}, footprints_ = {};
}

void FaceSource::make_from_part() {
  {
    const Cloth& part = *tile_.part;
    const int across = part_texels(part.ends.size() / static_cast<size_t>(tile_.part_across)),
              up = part_texels(part.picks.size() / static_cast<size_t>(tile_.part_up));
    Maps maps = bake(part, {across * tile_.part_across, up * tile_.part_up, kAzimuths});
    if (options_.fitted) measure(part, maps);
    occlusion_ = mean_repeat(maps.occlusion, across, up);
    occlusion_across_ = tile_.across, occlusion_up_ = tile_.up;
  }
  const int small_x = std::min(options_.size.width, kCoarseSide), small_y = std::min(options_.size.height, kCoarseSide);
  small_ = make_surface(tile_.cloth, bake(tile_.cloth, {2 * small_x, 2 * small_y, 0}), small_x, small_y);
  set_occlusion(small_, 0, small_y);
}

void FaceSource::measure_range() {
  small_.low_mm = 1e9f, small_.high_mm = -1e9f;
  double smoothness = 0;
  FaceMeans sum;
  for (const SurfaceTexel& t : small_.texels.at_) {
    small_.low_mm = std::min(small_.low_mm, t.height_mm), small_.high_mm = std::max(small_.high_mm, t.height_mm);
    const GgxAlphas a = ggx_alphas(t);
    const double roughness = std::sqrt(std::sqrt(static_cast<double>(a.wide * a.narrow)));
    smoothness += 1 - roughness, sum.roughness += roughness;
    sum.aspect += a.wide > 0 ? std::clamp((1 - static_cast<double>(a.narrow / a.wide)) / 0.9, 0.0, 1.0) : 0.0;
    sum.sheen += static_cast<double>(std::max({t.sheen.r, t.sheen.g, t.sheen.b}));
    sum.metal += static_cast<double>(t.metal);
    sum.transmitted += static_cast<double>((t.transmitted.r + t.transmitted.g + t.transmitted.b) / 3);
  }
  const auto texels = static_cast<double>(small_.texels.at_.size());
  small_.smoothness = static_cast<float>(smoothness / texels);
  means_ = {sum.roughness / texels, sum.aspect / texels, sum.sheen / texels, sum.metal / texels,
            sum.transmitted / texels};
  small_.first_turn = axis_cut(small_.texels.at_);
}

void FaceSource::measure(const Cloth& cloth, const Maps& maps) {
  const EngineTexels texels = engine_texels(cloth, maps, options_.footprint_mm);
  if (!light_) light_ = std::make_shared<const ClothResponse>(measure_response(cloth, maps, kFitSamples));
  const ClothResponse& response = *light_;
  fit_ = fit_engine(texels, cloth, response, options_.model, options_.near ? &*options_.near : nullptr);
  older_fit_ = options_.older ? refit_engine(texels, cloth, response, *options_.older, fit_) : fit_;
  weight_ = texels.footprint_weight;
  checks_ = check_engine(texels, cloth, response, options_.model, fit_);
  scores_ = score_engine(texels, cloth, response, options_.model, fit_);
  for (const EnginePlane plane : {EnginePlane::kWarp, EnginePlane::kWeft})
    plane_scores_[static_cast<size_t>(plane)] = score_plane(texels, cloth, response, options_.model, fit_, plane);
}

void FaceSource::measure_lean() {
  if (!options_.fitted) return;
  glm::vec3 sum(0, 0, 1e-6f);
  for (const SurfaceTexel& t : small_.texels.at_) sum += t.coverage * t.normal;
  lean_ = glm::vec2(sum) / sum.z;
}

void FaceSource::measure_footprints() {
  const float texel_mm = small_.width_mm / static_cast<float>(small_.texels.width);
  const float window_mm = lobe_window_mm(options_.footprint_mm, thread_spacing_mm(tile_.cloth));
  const int step = 1 << std::max(static_cast<int>(std::lround(std::log2(std::max(window_mm / texel_mm, 1.0f)))), 0);
  if (weight_ <= 0) return;
  const int step_x = std::min(step, small_.texels.width), step_y = std::min(step, small_.texels.height);
  Plane<glm::vec4> nodes(small_.texels.width / step_x,
                         small_.texels.height / step_y);  // covariance; xx of the fibre direction
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
  // Sampled densely enough for linear interpolation.
  footprints_ =
      Plane<glm::vec3>(nodes.width * std::min(step_x, kNodeSteps), nodes.height * std::min(step_y, kNodeSteps));
  for_each_job(footprints_.height, [&](int y) {
    const InterpolatedRow row(nodes, (static_cast<float>(y) + 0.5f) / static_cast<float>(footprints_.height));
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
  // The smallest gain that reaches the mean; occlusion is capped at 1.
  std::vector<std::array<float, 2>> seen_texels;  // coverage, occlusion
  for (const SurfaceTexel& t : small_.texels.at_) seen_texels.push_back({t.coverage, t.occlusion});
  float low = 1, high = 8;
  for (int step = 0; step < 12; ++step) {
    const float gain = 0.5f * (low + high);
    double sum = 0;
    for (const auto& [covered, occlusion] : seen_texels)
      sum += static_cast<double>(covered * std::min(occlusion * gain, 1.0f));
    (sum * over < static_cast<double>(kMeanOcclusion) ? low : high) = gain;
  }
  occlusion_gain_ = high;
}

void FaceSource::measure_mean_texel() {
  if (options_.detail == ThreadDetail::kAll || !options_.fitted) return;
  SurfaceTexels all = small_;
  if (options_.model.each_texel)
    for (SurfaceTexel& t : all.texels.at_) fit_facets(t);
  while (all.texels.at_.size() > 1) all = half_of(all);
  mean_texel_ = all.texels.at(0, 0);
  mean_texel_.normal = {0, 0, 1}, mean_texel_.fibre = {1, 0, 0};
  if (footprints_.width > 0) {
    const Plane<glm::vec3> one = averaged_down(footprints_, 1, 1);
    mean_texel_.slope_cov = one.width > 0 ? one.at(0, 0) : footprints_.at(0, 0);
  }
  mean_texel_.system = mean_texel_.slope_cov.z > mean_texel_.slope_cov.x ? 1 : 0;
}

/// Of a fitted texel.
void FaceSource::leave_out_threads(SurfaceTexel& t) const {
  if (options_.detail == ThreadDetail::kAll) return;
  t.occlusion = kMeanOcclusion, t.height_mm = 0;
  t.sheen = times(mean_texel_.sheen, fit_.sheen);
  if (options_.detail != ThreadDetail::kColours) return;
  t.normal = mean_texel_.normal, t.fibre = mean_texel_.fibre, t.slope_cov = mean_texel_.slope_cov;
  t.metal = mean_texel_.metal, t.transmitted = mean_texel_.transmitted;
  t.system = mean_texel_.system, t.thread = 0;
}

void FaceSource::finish(SurfaceTexels& surface, int y0, int level_height, int threads) const {
  if (!options_.fitted) return;
  const int width = surface.texels.width, height = surface.texels.height;
  const Plane<glm::vec3> coarser = averaged_down(footprints_, width, level_height);
  const Plane<glm::vec3>& footprints = coarser.width > 0 ? coarser : footprints_;
  for_each_job(height, threads, [&](int y) {
    SurfaceTexel* const row = surface.texels.row(y);
    if (footprints.width > 0) {
      const InterpolatedRow lobes(footprints, (static_cast<float>(y0 + y) + 0.5f) / static_cast<float>(level_height));
      for (int x = 0; x < width; ++x)
        measure_footprint(row[x], lobes.at((static_cast<float>(x) + 0.5f) / static_cast<float>(width)));
    }
    for (int x = 0; x < width; ++x) {
      SurfaceTexel& t = row[x];
      t.base = times(t.base, fit_.base);
      t.sheen = times(t.sheen, fit_.sheen);
      fit_facets(t);
      t.sheen_roughness = fit_.sheen_roughness;
      t.occlusion = std::min(t.occlusion * occlusion_gain_, 1.0f);
      leave_out_threads(t);
    }
  });
}

void FaceSource::fit_facets(SurfaceTexel& t) const {
  if (options_.model.each_texel) t.slope_cov = scaled_covariance({t.slope_cov, grain_of(t.fibre)}, fit_.lobe);
  t.normal = flattened(straightened(t.normal, lean_), fit_.relief);
}

void FaceSource::measure_footprint(SurfaceTexel& texel, const glm::vec3& lobe) const {
  texel.slope_cov = glm::mix(texel.slope_cov, lobe, weight_);
  // The system whose direction the wider axis follows, so that neighbours have the same sense of the axis.
  if (weight_ > 0.5f) texel.system = texel.slope_cov.z > texel.slope_cov.x ? 1 : 0;
}

SurfaceTexels FaceSource::piece(int x0, int x1, int y0, int y1) const {
  const bool has_occlusion = occlusion_.width > 0 || sharp_occlusion_.width > 0;
  const MapsSize all{options_.size.width * factor_, options_.size.height * factor_, has_occlusion ? 0 : kAzimuths, 1};
  Maps maps = bake(tile_.cloth, all, {x0 * factor_, y0 * factor_, x1 * factor_, y1 * factor_});
  maps.horizon.clear();
  for (int y = 0; sharp_occlusion_.width > 0 && y < maps.occlusion.height; ++y)
    std::copy_n(sharp_occlusion_.row(y0 * factor_ + y) + x0 * factor_, maps.occlusion.width, maps.occlusion.row(y));
  return make_surface(tile_.cloth, maps, x1 - x0, y1 - y0, 1);
}

SurfaceTexels FaceSource::rows(int y0, int y1) const { return finished(raw_rows(y0, y1), y0, options_.size.height); }

SurfaceTexels FaceSource::finished(SurfaceTexels raw, int y0, int level_height) const {
  finish(raw, y0, level_height, 1);
  return raw;
}

SurfaceTexels FaceSource::raw_rows(int y0, int y1) const {
  const int width = options_.size.width, height = y1 - y0;
  SurfaceTexels out = blank_like(small_, 0, 0);
  if (const SurfaceTexels* all = whole()) {
    out.texels.width = width, out.texels.height = height;
    out.texels.at_.assign(all->texels.row(y0), all->texels.row(y0) + static_cast<ptrdiff_t>(width) * height);
    return out;
  }
  const int step = std::min(width, kMaxPieceSide / factor_);
  out.texels = step == width ? piece(0, width, y0, y1).texels : Plane<SurfaceTexel>(width, height);
  for (int x = 0; step < width && x < width; x += step) {
    const SurfaceTexels part = piece(x, x + step, y0, y1);
    for (int y = 0; y < height; ++y) std::copy_n(part.texels.row(y), step, out.texels.row(y) + x);
  }
  set_occlusion(out, y0, options_.size.height);
  return out;
}

void FaceSource::set_occlusion(SurfaceTexels& surface, int y0, int level_height) const {
  const int width = surface.texels.width;
  const auto within = [](float periods) { return periods - std::floor(periods); };
  for (int y = 0; occlusion_.width > 0 && y < surface.texels.height; ++y) {
    const float v = (static_cast<float>(y0 + y) + 0.5f) / static_cast<float>(level_height);
    const InterpolatedRow seen(occlusion_, within(v * static_cast<float>(occlusion_up_)));
    for (int x = 0; x < width; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
      surface.texels.at(x, y).occlusion = seen.at(within(u * static_cast<float>(occlusion_across_)));
    }
  }
}

}  // namespace weftlight::texture_set
