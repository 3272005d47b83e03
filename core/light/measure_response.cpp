// Sums what light and eye both see over surface points, for every pair of directions.
// Based on: Westin, Arvo, Torrance 1992, "Predicting reflectance functions from complex surfaces" (a table measured on
// small geometry); Ashikhmin, Premoze, Shirley 2000 (facets that mirror, by their normals).
// Differs: the specular part is measured facet lobe by facet lobe, and stored over its closed form from the measured
// slopes, so that the table is smooth.

#include "light/measure_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "light/cloth_sky.h"
#include "light/facet_regression.h"
#include "light/formulas.h"
#include "light/transmission_response.h"
#include "light/yarn_lobes.h"
#include "platform/vectors.h"

namespace weftlight::light {

using base::for_each_job;
using cloth::Linear, cloth::Slope;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr size_t kV = kResponseViews, kL = kResponseLights;
constexpr float kDark = 1e-4f;           // radiance below which the gradient is ignored
constexpr float kEvenWeave = 0.02f;      // relative variance of the coverage around below which it says nothing
constexpr int kTransmissionSamples = 4;  // for each reflection sample: few of them are both visible and lit
constexpr size_t kCoarseTexels = 16, kMinCoarse = 128, kMaxCoarse = 768;  // across a thread, along a side
constexpr size_t kMaxSlopeSamples = 4096;                                 // at most, of those seen from above
constexpr int kMeanTexels = 512;                                          // texels a side of the map, for plain means

using PerView = std::array<float, kV>;
using PerLight = std::array<float, kL>;

/// Light on a sample from one side of the cloth: cosine times what the lobes do on the way in. shadow: projected area
/// of the microfacets; along, across, mu: the direction in the fibre's frame, mu clamped above the plane.
struct LightOnSample {
  PerLight cosine{}, lit{}, loss{}, veil{}, clear{}, shadow{}, along{}, across{}, mu{};
  LightOnSample() { clear.fill(1), shadow.fill(1), mu.fill(1); }  // lights that do not reach the sample: any value
};

/// A surface sample with one of its normals: its visibility to each view and its light from each direction.
struct Point {
  float area = 0;   // over that of the cloth's plane
  float above = 0;  // projected area visible from above
  int system = 0;
  // Of views: projected area over `area`, and what the lobes do on the way out.
  PerView seen{}, enters{}, loss{}, veil{}, clear{}, shadow{}, along{}, across{}, mu{};
  LightOnSample front;
  float height_mm = 0;
  float around = 0;  // fraction of the crossings around that its system has on top
  FacetMoments facets{};
  glm::vec3 inverse{1, 0, 1};  // of the covariance of the facets' slopes
  float peak = 0;              // density of the slopes at their mean
  float body_scale = 0, multiple = 0, fuzz = 0, again = 0, groove = 1;
  // Means of the channels.
  float f0 = 0, f90 = 0, fibre_layers = 1, fuzz_colour = 0;
  // Colours that the table leaves out, as the renderer applies them.
  float tone = 0, rendered_f0 = 0, rendered_fuzz = 0, rendered_multiple = 0;
};

/// Light from the front; cosine: times the visible fraction. weights: of the channels, of sum 1.
void add_light(LightOnSample& from, size_t i, const formulas::LobeSide& side, const glm::vec3& local, float cosine,
               const glm::vec3& weights) {
  from.cosine[i] = cosine, from.lit[i] = cosine * glm::dot(side.enters, weights);
  from.loss[i] = cosine * side.loss, from.veil[i] = cosine * side.fuzz.y;
  from.clear[i] = side.clear, from.shadow[i] = side.area;
  from.along[i] = local.x, from.across[i] = local.y, from.mu[i] = side.mu;
}

/// Light that fuzz scatters on its way in and out of the body, over the body's colour. It is dyed by both.
float again_of(const formulas::YarnLobes& lobes, const formulas::LobeShared& shared) {
  return channel_mean(lobes.fuzz_colour * lobes.body * shared.mean_enters) / std::max(channel_mean(lobes.body), 1e-6f);
}

/// Evaluates a sample with one of its normals: the normal between plies for the views that it faces, else that of the
/// section.
Point measure(const ThreadSample& sample, const glm::vec3& normal, const std::array<glm::vec3, kV>& w) {
  Point p;
  const formulas::YarnLobes& lobes = sample.lobes;
  const formulas::LobeShared shared = formulas::lobe_shared(lobes);
  p.system = sample.system, p.area = sample.area;
  p.above = sample.area * std::max(sample.side.z, 0.0f) * sample.open[kV - 1];
  const glm::vec3 weights = body_weights(lobes);
  p.fuzz = lobes.fuzz, p.body_scale = glm::dot(shared.body_scale, weights), p.multiple = channel_mean(shared.multiple);
  p.inverse = shared.inverse, p.peak = shared.peak, p.groove = sample.groove;
  p.tone = channel_mean(lobes.body), p.f0 = channel_mean(lobes.f0), p.f90 = lobes.f90,
  p.fibre_layers = lobes.fibre_layers;
  p.fuzz_colour = channel_mean(lobes.fuzz_colour), p.rendered_f0 = channel_mean(sample.rendered.f0);
  p.rendered_fuzz = channel_mean(sample.rendered.fuzz_colour);
  p.rendered_multiple = channel_mean(formulas::mean_fresnel(sample.rendered));
  p.again = lobes.fuzz * again_of(lobes, shared) /
            (kPi * std::max(formulas::lobe_side(lobes, shared, {0, 0, 1}).fuzz.w, 1e-4f));
  p.height_mm = sample.height_mm, p.around = sample.around, p.facets = facet_moments(normal);
  const bool plain = sample.normal == sample.side, own = normal == sample.normal;
  const formulas::LobeFrame frame = formulas::lobe_frame(normal, sample.fibre);
  const float through = channel_mean(lobes.through);
  std::array<formulas::LobeSide, kV> sides;
  for (size_t v = 0; v < kV; ++v) {
    const float facing = glm::dot(sample.side, w[v]);
    p.mu[v] = p.clear[v] = p.shadow[v] = 1;  // not visible: any value
    if (facing <= 0 || sample.open[v] <= 0) continue;
    const glm::vec3 local = formulas::lobe_local(frame, w[v]);
    const formulas::LobeSide& side = sides[v] = formulas::lobe_side(lobes, shared, local);
    if (plain || own == (glm::dot(sample.normal, w[v]) > 0)) p.seen[v] = facing;
    p.enters[v] = glm::dot(side.enters, weights), p.loss[v] = side.loss, p.veil[v] = side.fuzz.y;
    p.clear[v] = side.clear, p.shadow[v] = side.area;
    p.along[v] = local.x, p.across[v] = local.y, p.mu[v] = side.mu;
  }
  for (size_t i = 0; i < kL; ++i) {
    const size_t v = view_of_light(i);
    const glm::vec3 local = formulas::lobe_local(frame, w[v]);
    if (glm::dot(sample.side, w[v]) > 0 && sample.open[v] > 0)
      add_light(p.front, i, sides[v], local, std::max(local.z, 0.0f), weights);
    if (local.z >= 0 || sample.open[v] <= 0 || p.tone <= 0 || through <= 0) continue;
    const glm::vec3 entering = formulas::lobe_side(lobes, shared, {local.x, local.y, -local.z}).enters;
    p.front.lit[i] = -local.z * glm::dot(entering, weights) * through / p.tone;
  }
  return p;
}

/// Sums over points, [view][light]: body, mirrored light, fuzz, multiple scattering of facets.
struct RadianceSums {
  std::vector<float> body, mirror, fuzz, multiple;
  RadianceSums() : body(kV * kL), mirror(kV * kL), fuzz(kV * kL), multiple(kV * kL) {}
};

struct Sums {
  RadianceSums front;
  std::vector<float> all;                                     // front, [view][light]
  std::array<std::vector<float>, kFacetMoments> all_moments;  // all, times each of the point's moments
  PerView seen{}, height{}, visible_around{};
  std::array<PerView, kFacetMoments> visible_moments{};
  Sums() : all(kV * kL) { all_moments.fill(all); }

  /// All views from straight above are the same.
  void repeat_top() {
    constexpr size_t kTop = kV - kViewAzimuths;
    const auto rows = [](std::vector<float>& of, size_t width) {
      for (size_t v = kTop + 1; v < kV; ++v)
        std::copy_n(of.begin() + kTop * width, width, of.begin() + static_cast<ptrdiff_t>(v * width));
    };
    const auto one = [](PerView& of) { std::fill(of.begin() + kTop, of.end(), of[kTop]); };
    rows(front.body, kL), rows(front.mirror, kL), rows(front.fuzz, kL), rows(front.multiple, kL);
    rows(all, kL);
    for (auto& of : all_moments) rows(of, kL);
    for (auto* of : {&seen, &height, &visible_around}) one(*of);
    for (auto& of : visible_moments) one(of);
  }
};

/// Schlick's (1 - cosine)^5 at the half vector of each pair.
std::vector<float> grazing_of(const std::array<glm::vec3, kV>& w) {
  std::vector<float> out(kV * kL);
  for (size_t v = 0; v < kV; ++v) {
    for (size_t i = 0; i < kL; ++i) {
      const glm::vec3 half = w[v] + w[view_of_light(i)];
      out[v * kL + i] = std::pow(std::max(1 - 0.5f * glm::length(half), 0.0f), 5.0f);
    }
  }
  return out;
}

/// Fresnel weights of fibre layers (shaders/lobes.glsl, layered_grazing()).
void set_fresnel_weights(PerLight& rising, float fibre_layers, const float* grazing) {
  for (size_t i = 0; i < kL; ++i) rising[i] = fibre_layers * grazing[i] / (1 + (fibre_layers - 1) * grazing[i]);
}

/// Radiance of one point towards one view, by light.
struct ViewRadiance {
  PerLight scattered, mirrored, fuzz, multiple;
};

/// rising: Fresnel weights of this view's row.
void evaluate_lights(ViewRadiance& radiance, const Point& p, const LightOnSample& from, const PerLight& rising,
                     size_t view) {
  const float seen = p.area * p.seen[view], grooved = seen * p.groove;
  const float body = seen * p.enters[view] * p.body_scale,
              over_rendered_fuzz = grooved / std::max(p.rendered_fuzz, 1e-6f);
  const float again = seen * p.veil[view] * p.again, once = over_rendered_fuzz * p.fuzz_colour * p.fuzz / (4 * kPi);
  const float loss = grooved / std::max(p.rendered_multiple, 1e-6f) * p.loss[view] * p.multiple;
  const float glance = 0.25f * grooved * p.peak;
  // Local copies: the compiler then knows that the output does not alias them, and vectorises the loop.
  const float fuzz = p.fuzz, clear = p.clear[view], shadow = p.shadow[view], along = p.along[view],
              across = p.across[view], mu = p.mu[view];
  const float xx = -0.5f * p.inverse.x, xy = -p.inverse.y, yy = -0.5f * p.inverse.z;
  const float f0 = p.f0, rendered_f0 = p.rendered_f0, f90 = p.f90;
  for (size_t i = 0; i < kL; ++i) {
    const float mu_i = from.mu[i], cosine = from.cosine[i], veiled = 1 - clear * from.clear[i],
                unveiled = 1 - fuzz * veiled;
    // Beckmann facets as in lobe_specular() (shaders/lobes.glsl), over the Fresnel term that the renderer applies.
    const float over = 1 / (mu + mu_i), x = (along + from.along[i]) * over, y = (across + from.across[i]) * over;
    const float secant2 = 1 + x * x + y * y;
    const float d = secant2 * secant2 * formulas::exp(xx * x * x + xy * x * y + yy * y * y);
    const float fresnel = (f0 + (f90 - f0) * rising[i]) / (rendered_f0 + (f90 - rendered_f0) * rising[i] + 1e-6f);
    radiance.mirrored[i] = glance * d * cosine * unveiled * fresnel / (from.shadow[i] * mu + shadow * mu_i - mu * mu_i);
    radiance.scattered[i] = body * from.lit[i] * unveiled + again * from.veil[i];
    radiance.fuzz[i] = once * cosine * veiled * over;
    radiance.multiple[i] = loss * from.loss[i];
  }
}

void accumulate(std::vector<float>& to, size_t view, const PerLight& radiance, float scale = 1) {
  float* row = &to[view * kL];
  for (size_t i = 0; i < kL; ++i) row[i] += radiance[i] * scale;
}

void accumulate(RadianceSums& to, size_t view, const ViewRadiance& radiance) {
  accumulate(to.body, view, radiance.scattered);
  accumulate(to.mirror, view, radiance.mirrored);
  accumulate(to.fuzz, view, radiance.fuzz);
  accumulate(to.multiple, view, radiance.multiple);
}

using Grazing = std::vector<float>;

/// Adds a point to all pairs of one view. Pairs are symmetric except for the caller's divisor.
void add(Sums& sums, const Point& p, const Grazing& grazing, size_t view) {
  if (p.seen[view] <= 0) return;
  const float seen = p.area * p.seen[view];
  sums.seen[view] += seen, sums.height[view] += seen * p.height_mm, sums.visible_around[view] += seen * p.around;
  for (size_t k = 0; k < kFacetMoments; ++k) sums.visible_moments[k][view] += seen * p.facets[k];
  ViewRadiance radiance;
  PerLight rising, all;
  set_fresnel_weights(rising, p.fibre_layers, &grazing[view * kL]);
  evaluate_lights(radiance, p, p.front, rising, view);
  accumulate(sums.front, view, radiance);
  const float tone = p.tone, f0 = p.rendered_f0, more = p.f90 - f0, rendered_fuzz = p.rendered_fuzz,
              multiple = p.rendered_multiple;
  for (size_t i = 0; i < kL; ++i)
    all[i] = radiance.scattered[i] * tone + radiance.mirrored[i] * (f0 + more * rising[i]) +
             radiance.fuzz[i] * rendered_fuzz + radiance.multiple[i] * multiple;
  accumulate(sums.all, view, all);
  for (size_t k = 0; k < kFacetMoments; ++k) accumulate(sums.all_moments[k], view, all, p.facets[k]);
}

/// Adds all points to the views of one elevation.
void add_views(std::array<Sums, 2>& sums, const std::vector<Point>& points, const Grazing& grazing, int elevation) {
  const int azimuths = elevation == kResponseElevations - 1 ? 1 : kViewAzimuths;
  for (const Point& p : points)
    for (int a = 0; a < azimuths; ++a)
      add(sums[static_cast<size_t>(p.system)], p, grazing, static_cast<size_t>(elevation * kViewAzimuths + a));
}

void add_views_fast(std::array<Sums, 2>& sums, const std::vector<Point>& points, const Grazing& grazing,
                    int elevation) {
  platform::with_widest_vectors([&] { add_views(sums, points, grazing, elevation); });
}

/// Means over the whole map: without directions many more texels are affordable.
void measure_means(ClothResponse& out, const Maps& maps) {
  const int step_x = std::max(1, maps.coverage.width / kMeanTexels),
            step_y = std::max(1, maps.coverage.height / kMeanTexels);
  float all = 0;
  for (int j = 0; j < maps.coverage.height / step_y; ++j) {
    for (int i = 0; i < maps.coverage.width / step_x; ++i) {
      // Visits every offset within a step in turn, since threads are as regular as texels.
      const int x = i * step_x + (i + j) % step_x, y = j * step_y + i % step_y;
      const float weight = maps.coverage.at(x, y), shade = weight * maps.groove.at(x, y);
      SystemResponse& s = out.systems[maps.system.at(x, y) ? 1 : 0];
      const Linear& c = maps.colour.at(x, y);
      const Slope slope = maps.slope.at(x, y);
      const auto facets = facet_moments(glm::normalize(glm::vec3(slope.x, slope.y, 1)));
      s.fraction += weight, all += weight;
      s.colour.r += c.r * shade, s.colour.g += c.g * shade, s.colour.b += c.b * shade;
      for (size_t k = 0; k < kFacetMoments; ++k) s.facets[k] += weight * facets[k];
      out.sky += weight * maps.occlusion.at(x, y);
    }
  }
  for (SystemResponse& s : out.systems) {
    const float scale = 1 / std::max(s.fraction, 1e-9f);
    s.colour = {s.colour.r * scale, s.colour.g * scale, s.colour.b * scale};
    for (float& f : s.facets) f *= scale;
    s.fraction /= std::max(all, 1e-9f);
  }
  out.sky /= std::max(all, 1e-9f);
}

using Moments = FacetMoments;

/// Moments and fractions of what is visible from above. A texel of a map belongs to one system: where the gaps
/// between threads are narrower than texels, fractions from the map are off by a quarter.
std::array<Moments, 2> measure_top(ClothResponse& out, const ThreadSamples& threads) {
  std::array<Moments, 2> sums{};
  std::array<float, 2> seen{};
  for (const TopSample& p : threads.top) {
    const size_t s = static_cast<size_t>(p.system);
    const Moments m = facet_moments(p.normal);
    for (size_t k = 0; k < kFacetMoments; ++k) sums[s][k] += m[k];
    seen[s] += 1;
  }
  for (size_t s = 0; s < 2; ++s)
    for (float& m : sums[s]) m /= std::max(seen[s], 1.0f);
  if (const float all = seen[0] + seen[1]; threads.whole && all > 0)
    for (size_t s = 0; s < 2; ++s) out.systems[s].fraction = seen[s] / all;
  return sums;
}

/// Change of the warp's visible fraction with its fraction of the crossings around. Samples are uniform over all
/// threads, so the visible part of a system in a region is the mean over its samples there, hidden ones included.
/// Least squares give the change relative to that from above, which is 1. Warp and weft give two estimates.
std::vector<float> visible_rises(const std::array<Sums, 2>& sums, const ThreadSamples& threads) {
  std::vector<float> out(kV);
  for (size_t s = 0; s < 2; ++s) {
    const float mean = std::max(s == 0 ? threads.around_mean : 1 - threads.around_mean, 1e-3f);
    const float variance = threads.around_variance / (mean * mean), known = variance / (variance + kEvenWeave);
    const auto seen = [&](size_t v) { return std::max(sums[0].seen[v] + sums[1].seen[v], 1e-9f); };
    const auto part = [&](size_t v) { return sums[s].seen[v] / seen(v); };
    const auto covariance = [&](size_t v) { return (sums[s].visible_around[v] - sums[s].seen[v] * mean) / seen(v); };
    const float above = covariance(kV - 1), scale = 1 / std::max(threads.around_variance, 1e-6f);
    for (size_t v = 0; v < kV; ++v) {
      const float rise = 1 + (covariance(v) - above) * scale;
      out[v] += 0.5f * (known * rise + (1 - known) * part(v) / mean);
    }
  }
  return out;
}

template <class Weight>
FacetRegression regression(const std::vector<Point>& points, int system, Weight weight_of) {
  FacetRegression out;
  for (const Point& p : points)
    if (p.system == system) out.add(weight_of(p), p.facets);
  out.finish();
  return out;
}

/// Normalises one system by its fraction of the coverage: reflected light, visible area, and the gradient of the
/// former by the visible facets. Returns the scale of the sample areas.
float finish_system(SystemResponse& out, Sums& sums, const std::vector<Point>& points, int system,
                    const Moments& above) {
  const FacetRegression cover = regression(points, system, [](const Point& p) { return p.above; });
  const float scale = out.fraction / std::max(cover.weight, 1e-9f);
  for (size_t v = 0; v < kV; ++v) {
    const FacetRegression visible = regression(points, system, [v](const Point& p) { return p.area * p.seen[v]; });
    Moments products;
    for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.visible_moments[k][v];
    out.height_mm[v] = sums.height[v] / std::max(sums.seen[v], 1e-9f);
    sums.seen[v] *= scale * cover.correction(sums.seen[v], cover.rise(sums.seen[v], products), above);
    for (size_t i = 0; i < kL; ++i) {
      const size_t at = v * kL + i;
      const float all = sums.all[at], least = kDark * std::max(visible.weight, 1e-9f);
      for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.all_moments[k][at];
      const Moments rise = visible.rise(all, products);
      for (size_t k = 0; k < kFacetMoments; ++k)
        out.gradient[kFacetMoments * at + k] = std::clamp(rise[k] / std::max(all, least), -kMaxGradient, kMaxGradient);
      const float correction = scale * cover.correction(all, cover.rise(all, products), above);
      for (std::vector<float>* of : {&sums.front.body, &sums.front.mirror, &sums.front.fuzz, &sums.front.multiple})
        (*of)[at] *= correction;
    }
  }
  return scale;
}

/// A sample with the normal between plies, or that of the section.
struct Measured {
  const ThreadSample* sample;
  bool section = false;
};

/// Evaluates the samples. A normal between plies that faces away from some view needs a second point. Points are large,
/// so only those that are needed are made.
std::vector<Point> points_of(const std::vector<ThreadSample>& samples, const std::array<glm::vec3, kV>& w) {
  const auto turns_away = [&w](const ThreadSample& p) {
    return p.normal != p.side && std::any_of(w.begin(), w.end(), [&p](const glm::vec3& v) {
             return glm::dot(p.normal, v) <= 0 && glm::dot(p.side, v) > 0;
           });
  };
  std::vector<Measured> wanted;
  for (const ThreadSample& p : samples) {
    if (p.area <= 0) continue;
    wanted.push_back({&p});
    if (turns_away(p)) wanted.push_back({&p, true});
  }
  std::vector<Point> points(wanted.size());
  for_each_job(static_cast<int>(wanted.size()), [&](int k) {
    const size_t i = static_cast<size_t>(k);
    const ThreadSample& p = *wanted[i].sample;
    points[i] = measure(p, wanted[i].section ? p.side : p.normal, w);
    if (wanted[i].section) points[i].above = 0;
  });
  return points;
}

/// Of what is visible from above, one in so many that the slopes are not what takes time.
std::array<FacetSlopes, 2> slopes_of(const std::vector<TopSample>& samples) {
  std::array<std::vector<FacetsAround>, 2> facets;
  const size_t step = samples.size() / kMaxSlopeSamples + 1;
  for (size_t i = 0; i < samples.size(); i += step) {
    const TopSample& p = samples[i];
    facets[static_cast<size_t>(p.system)].push_back({1, p.normal, p.fibre, {p.widths2.x, 0, p.widths2.y}});
  }
  return {facet_slopes(facets[0]), facet_slopes(facets[1])};
}

/// Mirrored light is measured at few samples, so it is divided by the slopes of just these; the shader multiplies by
/// those of many.
std::array<FacetSlopes, 2> slopes_of(const std::vector<ThreadSample>& samples) {
  std::array<std::vector<FacetsAround>, 2> facets;
  for (const ThreadSample& p : samples) {
    const float weight = p.area * std::max(p.side.z, 0.0f) * p.open[kV - 1];
    facets[static_cast<size_t>(p.system)].push_back({weight, p.normal, p.fibre, p.lobes.slope_cov});
  }
  return {facet_slopes(facets[0]), facet_slopes(facets[1])};
}

/// few: slopes of the samples that the sums are of.
void write_tables(ClothResponse& out, const std::array<Sums, 2>& sums, const std::array<FacetSlopes, 2>& few,
                  const std::array<glm::vec3, kV>& w) {
  for (size_t v = 0; v < kV; ++v) {
    const float seen = std::max(sums[0].seen[v] + sums[1].seen[v], 1e-9f);
    for (size_t s = 0; s < 2; ++s) {
      SystemResponse& system = out.systems[s];
      const RadianceSums& radiance = sums[s].front;
      for (size_t i = 0; i < kL; ++i) {
        const size_t at = v * kL + i;
        const float density = closed_form(few[s], system.fraction, w[view_of_light(i)], w[v]);
        system.reflected[4 * at] = radiance.body[at] / seen;
        system.reflected[4 * at + 1] =
            formulas::stored_mirror(radiance.mirror[at] / (seen * (density + formulas::kFacetDensityFloor)));
        system.reflected[4 * at + 2] = radiance.fuzz[at] / seen;
        system.reflected[4 * at + 3] = radiance.multiple[at] / seen;
      }
      system.seen[v] = sums[s].seen[v] / seen;
    }
  }
}

}  // namespace

Maps coarse_maps(const Cloth& cloth) {
  const auto texels = [](size_t threads) {
    return static_cast<int>(std::clamp<size_t>(threads * kCoarseTexels, kMinCoarse, kMaxCoarse));
  };
  return cloth::bake(cloth, {texels(cloth.ends.size()), texels(cloth.picks.size()), 0});
}

ClothResponse measure_response(const Cloth& cloth, const Maps& maps, int samples) {
  ClothResponse out;
  out.sky = 0;
  for (SystemResponse& s : out.systems) {
    s.reflected.assign(4 * kV * kL, 0.0f), s.gradient.assign(kFacetMoments * kV * kL, 0.0f);
    s.seen.assign(kV, 0.0f), s.height_mm.assign(kV, 0.0f), s.transmitted.assign(4 * kV * kTransmissionLights, 0.0f);
    s.transmission_gradient = s.transmitted, s.sky.assign(4 * kV, 0.0f);
  }
  out.sky_from.assign(kV, {glm::vec3(0, 0, 1), glm::vec3(0, 0, 1)});
  out.near_sky.assign(kV, glm::vec4(1, 1, 0, 0));
  out.hidden.assign(kV, glm::vec4(0));
  out.visible_rise.assign(kV, 1.0f);
  if (cloth.ends.empty() || cloth.picks.empty() || maps.coverage.width <= 0 || maps.coverage.height <= 0) return out;
  const std::array<glm::vec3, kV> w = response_views();
  const ThreadSamples threads = thread_samples(cloth, samples, kTransmissionSamples * samples);
  const std::vector<Point> points = points_of(threads.samples, w);
  measure_means(out, maps);
  const std::array<Moments, 2> moments = measure_top(out, threads);
  const Grazing grazing = grazing_of(w);
  std::array<Sums, 2> sums;
  for_each_job(kResponseElevations, [&](int e) { add_views_fast(sums, points, grazing, e); });
  for (Sums& s : sums) s.repeat_top();
  out.visible_rise = visible_rises(sums, threads);
  std::array<FacetSlopes, 2> slopes = slopes_of(threads.top);
  std::array<float, 2> scale{};
  for (size_t s = 0; s < 2; ++s) {
    out.systems[s].slopes = std::move(slopes[s]);
    scale[s] = finish_system(out.systems[s], sums[s], points, static_cast<int>(s), moments[s]);
  }
  write_tables(out, sums, slopes_of(threads.samples), w);
  PerView seen;
  for (size_t v = 0; v < kV; ++v) seen[v] = sums[0].seen[v] + sums[1].seen[v];
  measure_transmission(out, cloth, threads, seen);
  measure_sky(out, cloth, threads.samples, scale, seen);
  return out;
}

}  // namespace weftlight::light
