#include "texture_set/face_source.h"

#include <algorithm>
#include <cmath>

#include "base/loops.h"

namespace weftlight::texture_set {
namespace {

constexpr int kLeastSide = 16;
constexpr int kAzimuths = 16;                            // of the horizon, which occlusion is made from
constexpr int64_t kMostCoarseTexels = int64_t{1} << 20;  // about 75 MB of maps
constexpr int64_t kMostRawTexels = int64_t{1} << 22;     // with the horizons that raw sets keep
constexpr int64_t kMostPieceTexels = int64_t{1} << 21;
constexpr int kMostPieceSide = 16384;  // of a window of the maps
constexpr int kSmallSide = 1024;
constexpr int kSamplesAThread = 4;
constexpr float kOcclusionTexels = 6;    // of the coarse maps, a thread, that show where it is dark
constexpr int kResponsePlaces = 512;     // means of the answer then hold 4 percent
constexpr float kMeanOcclusion = 0.98f;  // the fit holds all other shade

/// Texels baked for each texel of the set, a side: at least two, so that rims are smooth and the spread of normals is
/// known; more where threads are finer than texels.
int supersampling(const Cloth& cloth, TextureSize size) {
  const float texels_x = static_cast<float>(size.width) / static_cast<float>(std::max<size_t>(cloth.ends.size(), 1));
  const float texels_y = static_cast<float>(size.height) / static_cast<float>(std::max<size_t>(cloth.picks.size(), 1));
  int factor = 2;
  while (factor < 8 && std::min(texels_x, texels_y) * static_cast<float>(factor) < kSamplesAThread) factor *= 2;
  return factor;
}

int wrapped(int i, int n) { return (i % n + n) % n; }

/// Of a periodic plane, between the middles of its texels; u and v in periods.
template <class T>
T between(const Plane<T>& plane, float u, float v) {
  const float x = u * static_cast<float>(plane.width) - 0.5f, y = v * static_cast<float>(plane.height) - 0.5f;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const auto at = [&](int i, int j) { return plane.at(wrapped(i, plane.width), wrapped(j, plane.height)); };
  const auto mix = [](const T& a, const T& b, float t) { return a + (b - a) * t; };
  return mix(mix(at(x0, y0), at(x0 + 1, y0), fx), mix(at(x0, y0 + 1), at(x0 + 1, y0 + 1), fx), fy);
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
    return std::clamp(static_cast<int>(power), std::min(kLeastSide, size), size);
  };
  return {side(width_mm), side(depth_mm)};
}

FaceSource::FaceSource(Cloth cloth, const FaceOptions& options)
    : cloth_(std::move(cloth)), options_(options), factor_(supersampling(cloth_, options.size)) {
  const int width = options.size.width, height = options.size.height;
  const int64_t most = options.horizon ? kMostRawTexels : kMostCoarseTexels;
  int shrink = 1;
  while (int64_t{width} * factor_ / shrink * (int64_t{height} * factor_ / shrink) > most) shrink *= 2;
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
  while (band_ > 1 && row * band_ > kMostPieceTexels) band_ /= 2;
  take_footprints();
  take_means();
  finish(small_, 0);
  take_range();
}

void FaceSource::take_range() {
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
  const ClothResponse response = cloth_response(cloth_, maps, kResponsePlaces);
  fit_ = fit_engine(texels, cloth_, response, options_.model);
  share_ = texels.share;
  checks_ = check_engine(texels, cloth_, response, options_.model, fit_);
  scores_ = score_engine(texels, cloth_, response, options_.model, fit_);
}

void FaceSource::take_footprints() {
  const float texel_mm = small_.width_mm / static_cast<float>(small_.texels.width);
  const float window_mm = lobe_window_mm(options_.footprint_mm, thread_spacing_mm(cloth_));
  const int step = 1 << std::max(static_cast<int>(std::lround(std::log2(std::max(window_mm / texel_mm, 1.0f)))), 0);
  if (share_ <= 0) return;
  const int step_x = std::min(step, small_.texels.width), step_y = std::min(step, small_.texels.height);
  footprints_ = Plane<glm::vec4>(small_.texels.width / step_x, small_.texels.height / step_y);
  for_each_job(footprints_.height, [&](int y) {
    for (int x = 0; x < footprints_.width; ++x) {
      std::vector<LobePart> parts;
      for (int j = 0; j < step_y; ++j) {
        for (int i = 0; i < step_x; ++i) {
          const SurfaceTexel& t = small_.texels.at(x * step_x + i, y * step_y + j);
          parts.push_back({t.normal, t.slope_cov, grain_of(t.fibre), t.coverage});
        }
      }
      const FootprintLobe lobe = footprint_lobe(parts);
      footprints_.at(x, y) = glm::vec4(lobe.covariance, lobe.grain.x);
    }
  });
}

void FaceSource::take_footprint(SurfaceTexel& texel, float u, float v) const {
  const glm::vec4 at = between(footprints_, u, v);
  const FootprintLobe lobe{glm::vec3(at), {at.w, 1 - at.w}};
  texel.slope_cov = glm::mix(texel.slope_cov, scaled_covariance(lobe, fit_.lobe), share_);
  // Whose way its lobe runs: so that neighbours agree, as those of one system do.
  const glm::vec2 axis = glm::abs(facet_alphas(texel.slope_cov).axis);
  if (share_ > 0.5f) texel.system = axis.y > axis.x ? 1 : 0;
}

void FaceSource::take_means() {
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

void FaceSource::finish(Surface& surface, int y0) const {
  const int width = surface.texels.width, height = surface.texels.height;
  const bool all = &surface == &small_;
  const float whole_height = static_cast<float>(all ? height : options_.size.height);
  for_each_job(height, [&](int y) {
    const float v = (static_cast<float>(y0 + y) + 0.5f) / whole_height;
    for (int x = 0; x < width; ++x) {
      SurfaceTexel& t = surface.texels.at(x, y);
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(width);
      if (!all && occlusion_.width > 0) t.occlusion = between(occlusion_, u, v);
      if (!options_.fitted) continue;
      if (footprints_.width > 0) take_footprint(t, u, v);
      t.base = times(t.base, fit_.base);
      t.sheen = times(t.sheen, glm::vec3(fit_.sheen));
      t.sheen_roughness = fit_.sheen_roughness;
      t.occlusion = std::min(t.occlusion * occlusion_gain_, 1.0f);
    }
  });
}

Surface FaceSource::piece(int x0, int x1, int y0, int y1) const {
  const MapsSize whole{options_.size.width * factor_, options_.size.height * factor_,
                       occlusion_.width > 0 ? 0 : kAzimuths};
  Maps maps = bake(cloth_, whole, {x0 * factor_, y0 * factor_, x1 * factor_, y1 * factor_});
  maps.horizon.clear();
  return make_surface(cloth_, maps, x1 - x0, y1 - y0);
}

Surface FaceSource::rows(int y0, int y1) const {
  const int width = options_.size.width;
  Surface out{small_.width_mm, small_.depth_mm, Plane<SurfaceTexel>(width, y1 - y0), {}, {}};
  if (whole_.texels.width > 0) {
    std::copy(whole_.texels.row(y0), whole_.texels.row(y0) + static_cast<ptrdiff_t>(width) * (y1 - y0),
              out.texels.at_.begin());
  } else {
    const int step = std::min(width, kMostPieceSide / factor_);
    for (int x = 0; x < width; x += step) {
      const Surface part = piece(x, x + step, y0, y1);
      for (int y = 0; y < y1 - y0; ++y) std::copy_n(part.texels.row(y), step, out.texels.row(y) + x);
    }
  }
  finish(out, y0);
  out.low_mm = small_.low_mm, out.high_mm = small_.high_mm, out.smoothness = small_.smoothness;
  return out;
}

}  // namespace weftlight::texture_set
