#include "light/thread_error.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/loops.h"
#include "cloth/thread_scene.h"
#include "light/engine_texels.h"
#include "light/thread_samples.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {

namespace thread_formulas = cloth::thread_formulas;

using base::for_each_job;
using cloth::ThreadBody, cloth::ThreadTexture, cloth::thread_textures;
using design::Method;

namespace {

using Scene = thread_formulas::ThreadScene;

constexpr int kPixels = 48;                       // a footprint and view
constexpr float kFewPixels = 1.25f;               // safety factor for the few pixels
constexpr glm::ivec2 kFine{89, 34};               // Fibonacci lattice, as formulas::lattice_of()
constexpr int kViewCells = 48, kLightCells = 24;  // as method_yarn.glsl
// Error of the method against the traced truth without any sampling error (docs/chart.md).
constexpr float kModelError = 0.05f;
// Fall of the error with the samples, and rise with footprints wider than measured: as on the four charted cloths.
constexpr float kFallWithSamples = 0.75f, kRiseBeyond = 0.5f;

glm::vec3 tilted(float azimuth_deg, float degrees) {
  const float a = glm::radians(azimuth_deg), t = glm::radians(degrees);
  return {std::cos(a) * std::sin(t), std::sin(a) * std::sin(t), std::cos(t)};
}

/// Sides of a pixel on the middle plane, mm: across the tilt and along it.
struct PixelSides {
  glm::vec2 x, y;
};

PixelSides pixel_of(const glm::vec3& view, float side_mm) {
  const glm::vec2 slope(view.x, view.y);
  const float length = glm::length(slope), longer = 1 / std::sqrt(view.z);
  const glm::vec2 along = length > 1e-3f ? slope / length : glm::vec2(1, 0);
  return {glm::vec2(-along.y, along.x) * (side_mm / longer), along * (side_mm * longer)};
}

class Sampler {
 public:
  explicit Sampler(const Cloth& cloth)
      : cloth_(cloth), scene_(cloth), grid_(scene_.grid()), patterns_(thread_textures(cloth)) {
    for (size_t s = 0; s < 2; ++s) {
      for (const ThreadBody& body : s == 0 ? cloth.ends : cloth.picks)
        lobes_[s].push_back(yarn_lobes(cloth.yarns[static_cast<size_t>(body.yarn)].lobes, body.colour));
    }
  }
  /// Mean over the points of a lattice, as shade_yarn() in method_yarn.glsl.
  float mean(glm::vec2 middle, const PixelSides& pixel, glm::ivec2 lattice, float turn, const glm::vec3& l,
             const glm::vec3& v) {
    const float part = 1 / std::sqrt(static_cast<float>(lattice.x));
    float sum = 0;
    for (int i = 0; i < lattice.x; ++i) {
      const glm::vec2 r = formulas::lattice_point(lattice, i, 0, turn);
      sum += sample(middle + pixel.x * r.x + pixel.y * r.y, {pixel.x * part, pixel.y * part}, l, v);
    }
    return sum / static_cast<float>(lattice.x);
  }
  glm::vec2 position(int k) const {
    const auto part = [k](double step) { return static_cast<float>(std::fmod(step * (k + 1), 1.0)); };
    return glm::vec2(part(0.7548776662466927), part(0.5698402909980532)) * grid_.period;
  }

 private:
  float length(size_t system) const { return system == 0 ? cloth_.depth_mm : cloth_.width_mm; }
  float sample(glm::vec2 at, const PixelSides& side, const glm::vec3& l, const glm::vec3& v);

  const Cloth& cloth_;
  Scene scene_;
  Scene::ThreadGrid grid_;
  std::array<std::vector<ThreadTexture>, 2> patterns_;
  std::array<std::vector<formulas::YarnLobes>, 2> lobes_;
};

/// Mean of the channels, direct light only: add_sample() of method_yarn.glsl without the tones of fibres.
float Sampler::sample(glm::vec2 at, const PixelSides& side, const glm::vec3& l, const glm::vec3& v) {
  const auto hit = scene_.first_thread(grid_, at, v, kViewCells);
  if (hit.system < 0) return 0;
  const size_t system = static_cast<size_t>(hit.system), thread = static_cast<size_t>(hit.strand.thread);
  const auto p = scene_.thread_point(hit.system, hit.strand, hit.at);
  const ThreadTexture& pattern = patterns_[system][thread];
  const float mm = std::sqrt(std::abs(side.x.x * side.y.y - side.x.y * side.y.x));
  const float period_fraction = p.along / length(system);
  const thread_formulas::SurfaceFrame frame{p.normal, p.axis, p.around};
  const auto detail = thread_formulas::fibre_detail(
      pattern, period_fraction - std::floor(period_fraction), p.turn,
      thread_formulas::sample_size(pattern, mm, p.normal.z, length(system)), length(system));
  const float relief =
      thread_formulas::fibre_relief(lobes_[system][thread].slope_cov.z, formulas::nap_of(lobes_[system][thread].fuzz));
  const glm::vec3 n = thread_formulas::detail_normal(frame, pattern, detail, relief, length(system), v);
  const formulas::YarnLobes lobes =
      formulas::yarn_widen(formulas::detail_lobes(lobes_[system][thread], detail.resolved, relief),
                           scene_.slope_spread(p, detail.fibre_tan, v, side.x, side.y));
  const float radiance =
      channel_mean(formulas::facet_radiance(lobes, n, 1, p.axis + p.around * detail.fibre_tan, glm::vec3(0), l, v).key);
  if (radiance <= 0 || scene_.threads_block(grid_, hit.at, l, kLightCells, hit.system, hit.strand.thread)) return 0;
  const float light = detail.texel.groove * thread_formulas::detail_gain(pattern, detail, relief);
  return radiance * light * thread_formulas::ply_light(frame, pattern, detail, length(system), l);
}

using Errors = std::array<float, kErrorLattices>;

glm::ivec2 lattice_of(size_t i) { return formulas::lattice_of(static_cast<int>(kFirstErrorLattice + i)); }

/// Relative RMSE of each lattice at one footprint and view.
Errors errors_at(Sampler& sampler, float yarns, float spacing_mm, const glm::vec3& l, const glm::vec3& v) {
  const PixelSides pixel = pixel_of(v, yarns * spacing_mm);
  const float shifted = std::clamp(yarns * 4 - 1, 0.0f, 1.0f);
  std::array<double, kErrorLattices> off{};
  double all = 0;
  for (int k = 0; k < kPixels; ++k) {
    const glm::vec2 middle = sampler.position(k);
    const double truth = static_cast<double>(sampler.mean(middle, pixel, kFine, 0, l, v));
    all += truth * truth;
    for (size_t i = 0; i < kErrorLattices; ++i) {
      const float turn = static_cast<float>(k) * shifted;
      const double d = static_cast<double>(sampler.mean(middle, pixel, lattice_of(i), turn, l, v)) - truth;
      off[i] += d * d;
    }
  }
  Errors out{};
  for (size_t i = 0; i < kErrorLattices; ++i) out[i] = static_cast<float>(std::sqrt(off[i] / std::max(all, 1e-12)));
  return out;
}

/// Error for a number of samples, at one of the footprints.
float error_of(const Errors& errors, int samples) {
  size_t k = 0;
  while (k + 1 < kErrorLattices && lattice_of(k + 1).x <= samples) ++k;
  return errors[k] * std::pow(static_cast<float>(lattice_of(k).x) / static_cast<float>(samples), kFallWithSamples);
}

float error_at(const ThreadErrors& errors, int samples, float yarns) {
  constexpr float kWidest = kErrorFootprints.back();
  size_t k = 0;
  while (k + 2 < kErrorFootprints.size() && yarns > kErrorFootprints[k + 1]) ++k;
  const float from = std::log2(kErrorFootprints[k]), to = std::log2(kErrorFootprints[k + 1]);
  const float t = std::clamp((std::log2(yarns) - from) / (to - from), 0.0f, 1.0f);
  const float within = glm::mix(error_of(errors.rel_rmse[k], samples), error_of(errors.rel_rmse[k + 1], samples), t);
  return within * std::pow(std::max(yarns / kWidest, 1.0f), kRiseBeyond);
}

/// Linear fit in the logarithms of errors and samples, which removes noise.
Errors smoothed(const Errors& found) {
  constexpr float kCount = kErrorLattices;
  float x = 0, y = 0, xx = 0, xy = 0;
  for (size_t i = 0; i < kErrorLattices; ++i) {
    const float n = std::log(static_cast<float>(lattice_of(i).x)), e = std::log(std::max(found[i], 1e-4f));
    x += n / kCount, y += e / kCount, xx += n * n / kCount, xy += n * e / kCount;
  }
  const float slope = std::min((xy - x * y) / (xx - x * x), 0.0f);
  Errors out{};
  for (size_t i = 0; i < kErrorLattices; ++i)
    out[i] = std::exp(y + slope * (std::log(static_cast<float>(lattice_of(i).x)) - x));
  return out;
}

}  // namespace

ThreadErrors thread_errors(const Cloth& whole) {
  ThreadErrors out;
  if (whole.ends.empty() || whole.picks.empty()) return out;
  constexpr int kSide = 64;
  const int ends = static_cast<int>(whole.ends.size()), picks = static_cast<int>(whole.picks.size());
  const bool large = static_cast<size_t>(ends) * static_cast<size_t>(picks) > kWholeCrossings;
  if (large && !whole.layers.empty()) return out;
  const int wide = std::min(ends, kSide), high = std::min(picks, kSide), e = (ends - wide) / 2, p = (picks - high) / 2;
  const Cloth part = large ? cut(whole, {e, e + wide, p, p + high}) : Cloth{};
  const Cloth& cloth = large ? part : whole;
  Sampler sampler(cloth);
  const glm::vec3 light = tilted(35, 40);
  const std::array views{tilted(0, 0), tilted(-73, 72), tilted(17, 72)};
  std::array<std::array<Errors, views.size()>, kErrorFootprints.size()> found;
  for_each_job(static_cast<int>(views.size() * kErrorFootprints.size()), [&](int i) {
    const size_t f = static_cast<size_t>(i) / views.size(), v = static_cast<size_t>(i) % views.size();
    found[f][v] = errors_at(sampler, kErrorFootprints[f], thread_spacing_mm(cloth), light, views[v]);
  });
  for (size_t f = 0; f < kErrorFootprints.size(); ++f) {
    for (size_t i = 0; i < kErrorLattices; ++i) {
      const auto& [above, one, other] = found[f];
      out.rel_rmse[f][i] = std::max(above[i], std::sqrt(0.5f * (one[i] * one[i] + other[i] * other[i])));
    }
  }
  for (size_t f = 0; f < kErrorFootprints.size(); ++f) {
    Errors& errors = out.rel_rmse[f];
    errors = smoothed(errors);
    for (size_t i = 0; f > 0 && i < kErrorLattices; ++i) errors[i] = std::max(errors[i], out.rel_rmse[f - 1][i]);
  }
  out.measured = true;
  return out;
}

LodTable fitted(LodTable lod_table, const ThreadErrors& errors) {
  if (!errors.measured) return lod_table;
  for (LodPoint& p : lod_table) {
    if (p.method != Method::kYarn) continue;
    const float own = kFewPixels * error_at(errors, p.samples, p.yarns_per_pixel);
    p.filtering_error = std::min(own, p.filtering_error);
    p.model_error = std::min(std::sqrt(own * own + kModelError * kModelError), p.model_error);
  }
  return lod_table;
}

}  // namespace weftlight::light
