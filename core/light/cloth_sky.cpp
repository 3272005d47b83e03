// Based on: Heitz, d'Eon 2014, "Importance sampling microfacet-based BSDFs using the distribution of visible normals"
//   (facets by their projected area towards the view); Heitz 2014 (their masking, as shaders/lobes.glsl).
// Differs: slopes are Gaussian deviates of a lattice, a few other ones at each place; what they miss at one they find
// at
//   the others.

#include "light/cloth_sky.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "base/loops.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kRings = 20, kTurns = 40;               // lights of equal parts of the hemisphere
constexpr float kPart = 2 * kPi / (kRings * kTurns);  // sr
constexpr size_t kDeviates = 1021;                    // prime: places share no run of them
constexpr size_t kFacets = 4;                         // of a place, for each view
constexpr float kMinFactor = 0.4f, kMaxFactor = 2.5f;

/// The part of an even sky that each light of the tables stands for, between whose nodes answers run straight: its
/// directions, summed, and sr.
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

/// What of a light from `l` the place sees, between the views.
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

/// A place with what all views share.
struct Facets {
  const ThreadSample* place;
  formulas::LobeShared shared;
  float f0 = 0, drawn_f0 = 0;  // means of the channels
  glm::vec3 root{0};           // of the covariance of slopes: lower triangle xx, xy, yy
};

std::vector<Facets> facets_of(const std::vector<ThreadSample>& places) {
  std::vector<Facets> out;
  out.reserve(places.size());
  for (const ThreadSample& p : places) {
    Facets f{&p, formulas::lobe_shared(p.lobes), channel_mean(p.lobes.f0), channel_mean(p.drawn.f0)};
    f.root.x = std::sqrt(f.shared.cov.x), f.root.y = f.shared.cov.y / f.root.x;
    f.root.z = std::sqrt(std::max(f.shared.cov.z - f.root.y * f.root.y, 0.0f));
    out.push_back(f);
  }
  return out;
}

/// One system along one view, of an even sky. Directions are times what comes from them.
struct Mirrored {
  float all = 0, rising = 0;  // without Fresnel's term; times its rise at grazing
  float light = 0;
  glm::vec3 from{0};
};
struct Drawn {  // by rung `yarn`
  float all = 0, glossy = 0;
  glm::vec3 from{0};
};

/// What the place mirrors of the sky that it sees. weight: of its area towards the view.
void add_mirrored(Mirrored& sum, const Facets& facets, const formulas::LobeFrame& frame, const formulas::LobeSide& side,
                  const glm::vec3& wo, const glm::vec2* slopes, float weight) {
  const ThreadSample& p = *facets.place;
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
    const float rising = formulas::pile_grazing(y.pile, std::max(1 - facing, 0.0f));
    const float fresnel = facets.f0 + (y.f90 - facets.f0) * rising;
    const float clear = y.fuzz > 0 ? std::exp(-std::min(y.fuzz_depth / mu, 80.0f)) : 1.0f;
    const float sent = weight * open * towards * masked * (1 - y.fuzz * (1 - side.clear * clear)) / kFacets;
    const float drawn = facets.drawn_f0 + (y.f90 - facets.drawn_f0) * rising;
    const float taken = sent * fresnel / (drawn + 1e-6f);
    sum.all += taken, sum.rising += taken * rising;
    sum.light += sent * fresnel, sum.from += sent * fresnel * l;
  }
}

void add_place(Mirrored& mirrored, Drawn& drawn, const Facets& facets, const glm::vec3& v, const glm::vec2* slopes) {
  const ThreadSample& p = *facets.place;
  const float weight = p.area * glm::dot(p.side, v) * p.groove;
  const glm::vec3 n = glm::dot(p.normal, v) > 0 ? p.normal : p.side;
  const formulas::LobeFrame frame = formulas::lobe_frame(n, p.fibre);
  const glm::vec3 wo = formulas::lobe_local(frame, v);
  const formulas::LobeSide side = formulas::lobe_side(p.lobes, facets.shared, wo);
  const formulas::Answer sky = formulas::facet_sky(p.lobes, facets.shared, side);
  const glm::vec3 reflected = glm::reflect(-v, n);
  const float glossy = weight * channel_mean(sky.glossy) * formulas::mirrored_seen(reflected);
  drawn.all += weight * channel_mean(sky.soft) * formulas::facet_seen(n) + glossy;
  drawn.glossy += glossy, drawn.from += glossy * formulas::mirrored_seen_from(reflected);
  add_mirrored(mirrored, facets, frame, side, wo, slopes, weight);
}

/// All that one view is sent: times its direction, and it.
struct SentSky {
  glm::vec4 soft{0}, glossy{0};
  Drawn drawn;
};

class SkyTaker {
 public:
  SkyTaker(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& places)
      : response_(response), parts_(sky_parts()), deviates_(deviates()), facets_(facets_of(places)) {
    deviates_.insert(deviates_.end(), deviates_.begin(), deviates_.begin() + kFacets);
    for (size_t s = 0; s < 2; ++s) {
      const Linear& c = response.systems[s].colour;
      yarns_[s] = formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), {c.r, c.g, c.b});
    }
  }
  void take(size_t view, const glm::vec3& v, const std::array<float, 2>& scale, float seen);

 private:
  glm::vec3 scattered(size_t system, size_t view, SentSky& sent) const;

  ClothResponse& response_;
  std::vector<glm::vec4> parts_;
  std::vector<glm::vec2> deviates_;
  std::vector<Facets> facets_;
  std::array<formulas::YarnLobes, 2> yarns_;
};

/// Body; fuzz; what facets scatter more than once.
glm::vec3 SkyTaker::scattered(size_t system, size_t view, SentSky& sent) const {
  const float* row = &response_.systems[system].broad[4 * view * kResponseLights];
  const glm::vec3 tones(channel_mean(yarns_[system].body), channel_mean(yarns_[system].fuzz_colour),
                        channel_mean(formulas::mean_fresnel(yarns_[system])));
  glm::vec3 sum(0);
  for (size_t i = 0; i < kResponseLights; ++i) {
    const glm::vec3 broad(row[4 * i], row[4 * i + 2], row[4 * i + 3]);
    sum += broad * parts_[i].w;
    sent.soft += glm::dot(broad, tones) * parts_[i];
  }
  return sum;
}

void SkyTaker::take(size_t view, const glm::vec3& v, const std::array<float, 2>& scale, float seen) {
  std::array<Mirrored, 2> mirrored;
  std::array<Drawn, 2> drawn;
  for (size_t i = 0; i < facets_.size(); ++i) {
    const ThreadSample& p = *facets_[i].place;
    if (p.open[view] <= 0 || glm::dot(p.side, v) <= 0) continue;
    const size_t s = static_cast<size_t>(p.system);
    add_place(mirrored[s], drawn[s], facets_[i], v, &deviates_[(i * kFacets + view) % kDeviates]);
  }
  SentSky sent;
  glm::vec4& near_sky = response_.near_sky[view];
  for (size_t s = 0; s < 2; ++s) {
    const float part = scale[s] / std::max(seen, 1e-9f);
    const glm::vec3 soft = scattered(s, view, sent);
    const glm::vec4 sky(soft.x, soft.y, mirrored[s].all * part + soft.z,
                        mirrored[s].rising * part + soft.z * formulas::kMeanGrazing);
    std::copy_n(glm::value_ptr(sky), 4, &response_.systems[s].sky[4 * view]);
    const formulas::YarnLobes& y = yarns_[s];
    const float all = channel_mean(y.body) * sky.x + channel_mean(y.fuzz_colour) * sky.y +
                      channel_mean(y.f0) * (sky.z - sky.w) + y.f90 * sky.w;
    const float made = drawn[s].all * part;
    near_sky[static_cast<int>(s)] = made > 1e-4f ? std::clamp(all / made, kMinFactor, kMaxFactor) : 1.0f;
    sent.glossy += part * glm::vec4(mirrored[s].from, mirrored[s].light);
    sent.drawn.glossy += part * drawn[s].glossy, sent.drawn.from += part * drawn[s].from;
  }
  if (sent.soft.w > 0) response_.sky_from[view][0] = glm::vec3(sent.soft) / sent.soft.w;
  if (sent.glossy.w <= 0) return;
  response_.sky_from[view][1] = glm::vec3(sent.glossy) / sent.glossy.w;
  if (sent.drawn.glossy <= 0) return;
  const glm::vec3 more = response_.sky_from[view][1] - sent.drawn.from / sent.drawn.glossy;
  const glm::vec2 along = glm::vec2(v) / std::max(glm::length(glm::vec2(v)), 1e-6f);
  near_sky.z = glm::dot(glm::vec2(more), along), near_sky.w = more.z;
}

}  // namespace

void measure_sky(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadSample>& places,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen) {
  SkyTaker taker(response, cloth, places);
  const std::array<glm::vec3, kResponseViews> views = response_views();
  for_each_job(kResponseViews, [&](int i) {
    const size_t view = static_cast<size_t>(i);
    taker.take(view, views[view], scale, seen[view]);
  });
}

}  // namespace weftlight::light
