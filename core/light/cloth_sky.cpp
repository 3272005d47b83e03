// Based on: Heitz, d'Eon 2014, "Importance sampling microfacet-based BSDFs using the distribution of visible normals"
// (facets by their projected area towards the view); Heitz 2014 (their masking, as shaders/lobes.glsl).
// Differs: slopes are Gaussian deviates of a lattice, a few different ones at each sample; what they miss at one
// sample they cover at others.

#include "light/cloth_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>
#include <numeric>

#include "base/loops.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {

using base::for_each_job;
using cloth::Linear;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kRings = 20, kTurns = 40;               // lights of equal solid angle over the hemisphere
constexpr float kPart = 2 * kPi / (kRings * kTurns);  // sr
constexpr size_t kDeviates = 1021;                    // prime, so that samples do not repeat the same run
constexpr size_t kFacets = 4;                         // a sample and view
constexpr float kMinFactor = 0.4f, kMaxFactor = 2.5f;
constexpr float kMinTone = 1e-3f;  // of a colour that a table is divided by
constexpr float kMinHalfHidden = 0.1f;

/// For each light node of the tables, the part of a uniform sky that it stands for (responses are linear between
/// nodes): sum of directions, and solid angle in sr.
std::vector<glm::vec4> sky_parts() {
  std::vector<glm::vec4> out(kResponseLights, glm::vec4(0));
  for (int k = 0; k < kRings * kTurns; ++k) {
    const float z = (static_cast<float>(k / kTurns) + 0.5f) / kRings, r = std::sqrt(1 - z * z);
    const float turn = 2 * kPi * (static_cast<float>(k % kTurns) + 0.5f) / kTurns;
    const glm::vec3 towards(r * std::cos(turn), r * std::sin(turn), z);
    const formulas::vec2 at = formulas::response_coord(towards);
    const float x = at.x * kLightAzimuths, low = std::floor(x), across = x - low;
    const float up = std::min(std::floor(at.y), kResponseElevations - 2.0f), above = at.y - up;
    for (size_t c = 0; c < 4; ++c) {
      const bool next = c & 1, higher = c & 2;
      out[(static_cast<size_t>(up) + higher) * kLightAzimuths + (static_cast<size_t>(low) + next) % kLightAzimuths] +=
          kPart * (next ? across : 1 - across) * (higher ? above : 1 - above) * glm::vec4(towards, 1);
    }
  }
  return out;
}

/// Pairs of normal deviates (Roberts' R2, by Box and Muller).
std::vector<glm::vec2> deviates() {
  std::vector<glm::vec2> out;
  for (size_t k = 0; k < kDeviates; ++k) {
    const auto part = [k](double step) {
      return static_cast<float>(std::fmod(0.5 + step * static_cast<double>(k), 1));
    };
    const float r = std::sqrt(-2 * std::log(std::max(part(0.7548776662466927), 1e-4f)));
    const float turn = 2 * kPi * part(0.5698402909980532);
    out.push_back(r * glm::vec2(std::cos(turn), std::sin(turn)));
  }
  return out;
}

/// Visibility of direction `l` at a sample, interpolated between views.
float open_towards(const ThreadSample& p, const glm::vec3& l) {
  const formulas::vec2 at = formulas::response_coord(l);
  const float x = at.x * kViewAzimuths, across = x - std::floor(x);
  const size_t low = static_cast<size_t>(x) % kViewAzimuths, high = (low + 1) % kViewAzimuths;
  const float up = std::min(std::floor(at.y), kResponseElevations - 2.0f), above = at.y - up;
  const float* row = &p.open[static_cast<size_t>(up) * kViewAzimuths];
  const float* over = row + kViewAzimuths;
  return (row[low] * (1 - across) + row[high] * across) * (1 - above) +
         (over[low] * (1 - across) + over[high] * across) * above;
}

/// A sample with what all views share.
struct Facets {
  const ThreadSample* sample;
  formulas::LobeShared shared;
  float f0 = 0, rendered_f0 = 0;  // means of the channels
  glm::vec3 root{0};              // of the slope covariance: lower triangle xx, xy, yy
};

std::vector<Facets> facets_of(const std::vector<ThreadSample>& samples) {
  std::vector<Facets> out;
  out.reserve(samples.size());
  for (const ThreadSample& p : samples) {
    Facets f{&p, formulas::lobe_shared(p.lobes), channel_mean(p.lobes.f0), channel_mean(p.rendered.f0)};
    f.root.x = std::sqrt(f.shared.cov.x), f.root.y = f.shared.cov.y / f.root.x;
    f.root.z = std::sqrt(std::max(f.shared.cov.z - f.root.y * f.root.y, 0.0f));
    out.push_back(f);
  }
  return out;
}

/// One system along one view, under a uniform sky. Directions are weighted by their light.
struct Mirrored {
  float all = 0, rising = 0;  // without the Fresnel term; times its rise at grazing
  float light = 0;
  glm::vec3 from{0};
};
struct YarnMethodSky {  // as method `yarn` estimates it
  float all = 0, glossy = 0;
  glm::vec3 from{0};
  float unhidden = 0;  // light if no thread hid any of it
  float squares = 0;   // light times the visible fraction of the sky
};

/// Adds the sky light that a sample mirrors. weight: its area towards the view.
void add_mirrored(Mirrored& sum, const Facets& facets, const formulas::LobeFrame& frame, const formulas::LobeSide& side,
                  const glm::vec3& wo, const glm::vec2* slopes, float weight) {
  const ThreadSample& p = *facets.sample;
  const formulas::YarnLobes& y = p.lobes;
  for (size_t k = 0; k < kFacets; ++k) {
    const glm::vec3 slope(facets.root.x * slopes[k].x, facets.root.y * slopes[k].x + facets.root.z * slopes[k].y, 1);
    const float towards = glm::dot(wo, slope);
    if (towards <= 0) continue;
    const float over = 1 / glm::length(slope), facing = towards * over;
    const glm::vec3 wi = 2 * facing * over * slope - wo;
    const glm::vec3 l = frame.t * wi.x + frame.b * wi.y + frame.n * wi.z;
    if (wi.z <= 0 || l.z <= 0 || glm::dot(p.side, l) <= 0) continue;
    const float open = open_towards(p, l);
    if (open <= 0) continue;
    const float mu = std::max(wi.z, formulas::kMinCosine);
    const float area = formulas::gaussian_area(mu, std::sqrt(formulas::variance_along(facets.shared.cov, wi.x, wi.y)));
    const float masked = mu / (area * side.mu + side.area * mu - mu * side.mu);  // over side.area: projected
    const float rising = formulas::layered_grazing(y.fibre_layers, std::max(1 - facing, 0.0f));
    const float fresnel = facets.f0 + (y.f90 - facets.f0) * rising;
    const float clear = y.fuzz > 0 ? std::exp(-std::min(y.fuzz_depth / mu, 80.0f)) : 1.0f;
    const float radiance = weight * open * towards * masked * (1 - y.fuzz * (1 - side.clear * clear)) / kFacets;
    const float drawn = facets.rendered_f0 + (y.f90 - facets.rendered_f0) * rising;
    const float weighted = radiance * fresnel / (drawn + 1e-6f);
    sum.all += weighted, sum.rising += weighted * rising;
    sum.light += radiance * fresnel, sum.from += radiance * fresnel * l;
  }
}

void add_sample(Mirrored& mirrored, YarnMethodSky& drawn, const Facets& facets, const glm::vec3& v,
                const glm::vec2* slopes) {
  const ThreadSample& p = *facets.sample;
  const float weight = p.area * glm::dot(p.side, v) * p.groove;
  const glm::vec3 n = glm::dot(p.normal, v) > 0 ? p.normal : p.side;
  const formulas::LobeFrame frame = formulas::lobe_frame(n, p.fibre);
  const glm::vec3 wo = formulas::lobe_local(frame, v);
  const formulas::LobeSide side = formulas::lobe_side(p.lobes, facets.shared, wo);
  const formulas::Reflected sky = formulas::facet_sky(p.lobes, facets.shared, side);
  const glm::vec3 reflected = glm::reflect(-v, n);
  const float glossy = weight * channel_mean(sky.glossy) * formulas::mirrored_sky_visibility(reflected);
  const float scattered = weight * channel_mean(sky.diffuse), open = formulas::facet_sky_visibility(n);
  drawn.all += scattered * open + glossy;
  drawn.unhidden += scattered + weight * channel_mean(sky.glossy);
  drawn.squares += scattered * open * open + glossy * formulas::mirrored_sky_visibility(reflected);
  drawn.glossy += glossy, drawn.from += glossy * formulas::mirrored_sky_direction(reflected);
  add_mirrored(mirrored, facets, frame, side, wo, slopes, weight);
}

/// Reflected sky light along one view: xyz directions times light, w light.
struct SkyRadiance {
  glm::vec4 diffuse{0}, glossy{0};
  YarnMethodSky drawn;
};

class SkyMeasurer {
 public:
  SkyMeasurer(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& samples)
      : response_(response), parts_(sky_parts()), deviates_(deviates()), facets_(facets_of(samples)) {
    deviates_.insert(deviates_.end(), deviates_.begin(), deviates_.begin() + kFacets);
    for (size_t s = 0; s < 2; ++s) {
      const Linear& c = response.systems[s].colour;
      yarns_[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), {c.r, c.g, c.b});
    }
  }
  void measure(size_t view, const glm::vec3& v, const std::array<float, 2>& scale, float seen);
  float sent(size_t view) const;

 private:
  glm::vec3 scattered(size_t system, size_t view, SkyRadiance& radiance) const;

  ClothResponse& response_;
  std::vector<glm::vec4> parts_;
  std::vector<glm::vec2> deviates_;
  std::vector<Facets> facets_;
  std::array<formulas::YarnLobes, 2> yarns_;
};

/// Body; fuzz; multiple scattering of facets.
glm::vec3 SkyMeasurer::scattered(size_t system, size_t view, SkyRadiance& radiance) const {
  const float* row = &response_.systems[system].reflected[4 * view * kResponseLights];
  const glm::vec3 tones(channel_mean(yarns_[system].body), channel_mean(yarns_[system].fuzz_colour),
                        channel_mean(formulas::mean_fresnel(yarns_[system])));
  glm::vec3 sum(0);
  for (size_t i = 0; i < kResponseLights; ++i) {
    const glm::vec3 reflected(row[4 * i], row[4 * i + 2], row[4 * i + 3]);
    sum += reflected * parts_[i].w;
    radiance.diffuse += glm::dot(reflected, tones) * parts_[i];
  }
  return sum;
}

void SkyMeasurer::measure(size_t view, const glm::vec3& v, const std::array<float, 2>& scale, float seen) {
  std::array<Mirrored, 2> mirrored;
  std::array<YarnMethodSky, 2> drawn;
  for (size_t i = 0; i < facets_.size(); ++i) {
    const ThreadSample& p = *facets_[i].sample;
    if (p.open[view] <= 0 || glm::dot(p.side, v) <= 0) continue;
    const size_t s = static_cast<size_t>(p.system);
    add_sample(mirrored[s], drawn[s], facets_[i], v, &deviates_[(i * kFacets + view) % kDeviates]);
  }
  SkyRadiance radiance;
  glm::vec4& near_sky = response_.near_sky[view];
  for (size_t s = 0; s < 2; ++s) {
    const float part = scale[s] / std::max(seen, 1e-9f);
    const glm::vec3 diffuse = scattered(s, view, radiance);
    const glm::vec4 sky(diffuse.x, diffuse.y, mirrored[s].all * part + diffuse.z,
                        mirrored[s].rising * part + diffuse.z * formulas::kMeanGrazing);
    std::copy_n(glm::value_ptr(sky), 4, &response_.systems[s].sky[4 * view]);
    const formulas::YarnLobes& y = yarns_[s];
    const float all = channel_mean(y.body) * sky.x + channel_mean(y.fuzz_colour) * sky.y +
                      channel_mean(y.f0) * (sky.z - sky.w) + y.f90 * sky.w;
    const float made = drawn[s].all * part;
    const float factor = made > 1e-4f ? std::clamp(all / made, kMinFactor, kMaxFactor) : 1.0f;
    near_sky[static_cast<int>(s)] = factor;
    const float hidden = std::max(drawn[s].unhidden - factor * drawn[s].all, 0.0f);
    const float half_hidden = factor * (drawn[s].all - factor * drawn[s].squares);
    response_.hidden[view][static_cast<int>(s)] =
        part * hidden / std::max(channel_mean(formulas::unhidden_reflectance(y)), kMinTone);
    response_.hidden[view][static_cast<int>(s) + 2] =
        hidden > 0 ? std::clamp(half_hidden / hidden, kMinHalfHidden, 1.0f) : 1.0f;
    radiance.glossy += part * glm::vec4(mirrored[s].from, mirrored[s].light);
    radiance.drawn.glossy += part * drawn[s].glossy, radiance.drawn.from += part * drawn[s].from;
  }
  if (radiance.diffuse.w > 0) response_.sky_from[view][0] = glm::vec3(radiance.diffuse) / radiance.diffuse.w;
  if (radiance.glossy.w <= 0) return;
  response_.sky_from[view][1] = glm::vec3(radiance.glossy) / radiance.glossy.w;
  if (radiance.drawn.glossy <= 0) return;
  const glm::vec3 more = response_.sky_from[view][1] - radiance.drawn.from / radiance.drawn.glossy;
  const glm::vec2 along = glm::vec2(v) / std::max(glm::length(glm::vec2(v)), 1e-6f);
  near_sky.z = glm::dot(glm::vec2(more), along), near_sky.w = more.z;
}

/// How much of what threads reflect of hidden directions a slanted view loses with them. Fitted to threads that are
/// traced with light between them; half of kGrooveLight of shaders/methods.glsl.
constexpr float kLostAtASlant = 0.42f;

/// What threads reflect of hidden directions, towards a view.
float SkyMeasurer::sent(size_t view) const {
  float sum = 0;
  for (size_t s = 0; s < 2; ++s)
    sum += response_.hidden[view][static_cast<int>(s)] * channel_mean(formulas::unhidden_reflectance(yarns_[s]));
  return sum;
}

/// Makes all that the cloth sends to a view so much more.
void scale_view(ClothResponse& response, size_t view, float by) {
  constexpr size_t kChannels = 4, kMirror = 1;
  for (SystemResponse& system : response.systems) {
    const auto scale = [&](std::vector<float>& of, size_t lights) {
      for (size_t k = kChannels * view * lights; k < kChannels * (view + 1) * lights; ++k) of[k] *= by;
    };
    scale(system.transmitted, kTransmissionLights), scale(system.sky, 1);
    for (size_t k = kChannels * view * kResponseLights; k < kChannels * (view + 1) * kResponseLights; ++k) {
      float& f = system.reflected[k];
      f = k % kChannels == kMirror ? formulas::stored_mirror(formulas::mirror_of(f) * by) : f * by;
    }
  }
}

}  // namespace

void measure_sky(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& samples,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen) {
  SkyMeasurer measurer(response, cloth, samples);
  const std::array<glm::vec3, kResponseViews> views = response_views();
  for_each_job(kResponseViews, [&](int i) {
    const size_t view = static_cast<size_t>(i);
    measurer.measure(view, views[view], scale, seen[view]);
  });
  // The lobes have the colours of the cloth seen from straight above, light between threads included. At a slant one
  // sees less of the grooves, where most of that light is (shaders/methods.glsl).
  constexpr size_t kTop = kResponseViews - kViewAzimuths;
  std::array<float, kResponseViews> sent;
  for (size_t v = 0; v < kResponseViews; ++v) sent[v] = measurer.sent(v);
  const float above = std::accumulate(sent.begin() + kTop, sent.end(), 0.0f) / kViewAzimuths;
  for (size_t v = 0; v < kTop; ++v)
    scale_view(response, v, (1 + kLostAtASlant * sent[v]) / (1 + kLostAtASlant * above));
}

}  // namespace weftlight::light
