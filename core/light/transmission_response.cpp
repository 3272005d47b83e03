// Few lights reach a place from behind, so only those are gone through, for the views that see it. What comes through a
// thread is body alone; what falls on a side that hangs over mirrors as well.

#include "light/transmission_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "light/facet_regression.h"
#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

constexpr size_t kMaxSidePairs = 2'000'000;  // of views and lights; of open cloth some of the places tell enough
constexpr size_t kTop = kResponseViews - kViewAzimuths;  // all views from straight above are one

/// A view, what of the place it sees and what the lobes do on the way out.
struct Out {
  size_t view;
  glm::vec3 towards, local;
  float seen;  // projected area, over that of the cloth's plane
  float body;  // of what leaves by body and through
  formulas::LobeSide side;
};

/// A light on a side that hangs over.
struct In {
  size_t light;
  glm::vec3 towards, local;
  formulas::LobeSide side;
};

/// A place with one of its normals: that between its plies, or the section's for the views that it turns away from.
struct Lit {
  const ThreadSample* place;
  formulas::LobeShared shared;
  FacetMoments facets;
  std::vector<Out> out;
  // Of a run of lights: what enters the body, and that times what is clear of its fuzz.
  size_t first = 0;
  std::vector<float> bare, cleared;
  std::vector<In> in;
};

/// [view][light].
struct Sums {
  std::vector<float> body;
  std::vector<glm::vec3> side;                              // mirrored; fuzz; what facets scatter more than once
  std::array<std::vector<float>, kFacetMoments> leaning{};  // body, times each of the place's moments
};

using Views = std::array<glm::vec3, kResponseViews>;
using Lights = std::array<glm::vec3, kBehindLights>;

void look_out(Lit& p, const formulas::LobeFrame& frame, bool own, const Views& views) {
  const ThreadSample& place = *p.place;
  const bool plain = place.normal == place.side;
  const glm::vec3 shares = body_shares(place.lobes);
  for (size_t v = kLowViews; v <= kTop; ++v) {
    const float facing = glm::dot(place.side, views[v]);
    if (facing <= 0 || place.open[v] <= 0 || (!plain && own != (glm::dot(place.normal, views[v]) > 0))) continue;
    const glm::vec3 local = formulas::lobe_local(frame, views[v]);
    const formulas::LobeSide side = formulas::lobe_side(place.lobes, p.shared, local);
    const float seen = place.area * facing;
    p.out.push_back({v, views[v], local, seen, seen * glm::dot(p.shared.body_scale * side.enters, shares), side});
  }
}

Lit lit_place(const ThreadSample& place, const glm::vec3& normal, const Views& views, const Lights& lights) {
  const formulas::YarnLobes& lobes = place.lobes;
  Lit p{&place, formulas::lobe_shared(lobes), facet_moments(normal), {}, 0, {}, {}, {}};
  const formulas::LobeFrame frame = formulas::lobe_frame(normal, place.fibre);
  look_out(p, frame, normal == place.normal, views);
  if (place.behind.empty()) p.out.clear();
  if (p.out.empty()) return p;
  const glm::vec3 shares = body_shares(lobes);
  const float body = channel_mean(lobes.body), through = channel_mean(lobes.through),
              both = std::max(body + through, 1e-6f);
  const auto [low, high] = std::minmax_element(place.behind.begin(), place.behind.end());
  p.first = *low;
  p.bare.assign(*high - *low + 1u, 0.0f);
  p.cleared = p.bare;
  for (const uint16_t i : place.behind) {
    const glm::vec3 local = formulas::lobe_local(frame, lights[i]);
    const bool faces = local.z > 0;
    const formulas::LobeSide side = formulas::lobe_side(lobes, p.shared, {local.x, local.y, std::abs(local.z)});
    const float bare = std::abs(local.z) * glm::dot(side.enters, shares) * (faces ? body : through) / both;
    p.bare[i - p.first] = bare, p.cleared[i - p.first] = bare * side.clear;
    if (faces) p.in.push_back({i, lights[i], local, side});
  }
  return p;
}

/// Fresnel's term of what mirrors, over that which pictures give it.
float fresnel_over_drawn(const ThreadSample& p, float grazing) {
  const float rising = formulas::pile_grazing(p.lobes.pile, grazing), f90 = p.lobes.f90;
  const float f0 = channel_mean(p.lobes.f0), drawn = channel_mean(p.drawn.f0);
  return (f0 + (f90 - f0) * rising) / (drawn + (f90 - drawn) * rising + 1e-6f);
}

/// Without what the body sends.
glm::vec3 sent_by_side(const Lit& p, const In& in, const Out& out) {
  const formulas::YarnLobes& lobes = p.place->lobes;
  const float veiled = 1 - in.side.clear * out.side.clear;
  formulas::YarnLobes mirror = lobes;
  mirror.f0 = glm::vec3(1), mirror.f90 = 1;
  const float mirrored = formulas::lobe_specular(mirror, p.shared, in.side, out.side, in.local, out.local).g;
  const float grazing = std::max(1 - 0.5f * glm::length(in.towards + out.towards), 0.0f);
  glm::vec3 combed(0);
  if (lobes.fuzz > 0) {
    const glm::vec3 again = lobes.body * p.shared.mean_enters *
                            (in.side.fuzz.y * out.side.fuzz.y / (kPi * std::max(out.side.fuzz.w, 1e-4f)));
    combed = lobes.fuzz_colour * lobes.fuzz * (veiled / (4 * kPi * (in.side.mu + out.side.mu)) + again);
  }
  const ThreadSample& place = *p.place;
  const float recurring = channel_mean(p.shared.multiple) * in.side.lost * out.side.lost;
  return glm::vec3(mirrored * (1 - lobes.fuzz * veiled) * fresnel_over_drawn(place, grazing),
                   channel_mean(combed) / std::max(channel_mean(place.drawn.fuzz_colour), 1e-6f),
                   recurring / std::max(channel_mean(formulas::mean_fresnel(place.drawn)), 1e-6f)) *
         (in.local.z * out.seen * place.groove);
}

/// sides: what light on sides counts for.
void send(Sums& sums, const Lit& p, const Out& out, float sides) {
  const size_t row = out.view * kBehindLights;
  const float fuzz = p.place->lobes.fuzz, bare = out.body * (1 - fuzz), cleared = out.body * fuzz * out.side.clear;
  const auto add = [&](std::vector<float>& to, float moment) {
    float* at = &to[row + p.first];
    const float b = bare * moment, c = cleared * moment;
    for (size_t i = 0; i < p.bare.size(); ++i) at[i] += b * p.bare[i] + c * p.cleared[i];
  };
  add(sums.body, 1);
  for (size_t k = 0; k < kFacetMoments; ++k) add(sums.leaning[k], p.facets[k]);
  if (sides <= 0) return;
  for (const In& in : p.in) sums.side[row + in.light] += sides * sent_by_side(p, in, out);
}

/// Of what body and through send, all colours.
float tone_of(const formulas::YarnLobes& y) { return glm::dot(y.body + y.through, glm::vec3(1)); }

/// As pictures take them.
std::array<float, 2> tones_of(const ClothResponse& response, const Cloth& cloth) {
  std::array<float, 2> out;
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = response.systems[s].colour;
    const glm::vec3 colour = glm::max(glm::vec3(c.r, c.g, c.b), kDarkestChannel);
    out[s] = tone_of(formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), colour));
  }
  return out;
}

std::vector<Lit> lit_places(const std::vector<ThreadSample>& places, const std::array<float, 2>& tones) {
  const auto views = response_views();
  const auto lights = transmission_lights();
  std::vector<Lit> out(2 * places.size());
  for_each_job(static_cast<int>(places.size()), [&](int i) {
    const size_t k = static_cast<size_t>(i);
    out[2 * k] = lit_place(places[k], places[k].normal, views, lights);
    if (places[k].normal != places[k].side) out[2 * k + 1] = lit_place(places[k], places[k].side, views, lights);
    // Light comes through few places, which may be darker than all that is seen of the system.
    const float tone =
        places[k].groove * tone_of(places[k].lobes) / std::max(tones[static_cast<size_t>(places[k].system)], 1e-4f);
    for (Lit* p : {&out[2 * k], &out[2 * k + 1]})
      for (Out& o : p->out) o.body *= tone;
  });
  std::erase_if(out, [](const Lit& p) { return p.out.empty(); });
  return out;
}

/// Views from straight above are one; along the cloth they see as much as a little higher.
size_t counted_view(size_t v) { return v < kLowViews ? v % kViewAzimuths + kLowViews : std::min(v, kTop); }

/// What is seen of each system: from above down to the low views, which are not measured.
std::array<std::vector<FacetRegression>, 2> seen_facets(const std::vector<ThreadSample>& places) {
  std::array<std::vector<FacetRegression>, 2> out;
  for (auto& of : out) of.resize(kResponseViews);
  const auto views = response_views();
  for_each_job(kResponseElevations, [&](int e) {
    const size_t first = static_cast<size_t>(e) * kViewAzimuths;
    for (size_t v = first; v < first + kViewAzimuths; ++v) {
      for (const ThreadSample& p : places) {
        const float seen = p.area * std::max(glm::dot(p.side, views[v]), 0.0f) * p.open[v];
        const glm::vec3& n = glm::dot(p.normal, views[v]) > 0 ? p.normal : p.side;
        if (seen > 0) out[static_cast<size_t>(p.system)][v].add(seen, facet_moments(n));
      }
      for (auto& of : out) of[v].finish();
    }
  });
  return out;
}

/// What areas of places are multiplied by: a system's share over what is seen of its places from above. Those that no
/// light reaches count, too: so few of its places are seen of a weft below long floats that their number goes by
/// chance.
std::array<float, 2> scales(const ClothResponse& response, const std::vector<ThreadSample>& places) {
  std::array<float, 2> cover{}, out;
  for (const ThreadSample& p : places)
    cover[static_cast<size_t>(p.system)] += p.area * std::max(p.side.z, 0.0f) * p.open[kTop];
  for (size_t s = 0; s < 2; ++s) out[s] = response.systems[s].share / std::max(cover[s], 1e-9f);
  return out;
}

/// How what the body sends leans, over what it sends.
FacetMoments lean_of(const Sums& sums, const FacetRegression& seen, size_t at) {
  FacetMoments products;
  for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.leaning[k][at];
  FacetMoments lean = seen.rise(sums.body[at], products);
  for (float& l : lean) l = std::clamp(l / std::max(sums.body[at], 1e-9f), -kSteepestLean, kSteepestLean);
  return lean;
}

void write_system(SystemResponse& out, const Sums& sums, const std::vector<FacetRegression>& facets, float scale,
                  const std::array<float, kResponseViews>& seen) {
  for (size_t v = 0; v < kResponseViews; ++v) {
    for (size_t i = 0; i < kBehindLights; ++i) {
      const size_t from = counted_view(v), at = from * kBehindLights + i, to = 4 * (v * kBehindLights + i);
      const float part = scale / std::max(seen[from], 1e-9f);
      out.behind[to] = sums.body[at] * part;
      for (size_t k = 0; k < 3; ++k) out.behind[to + 1 + k] = sums.side[at][static_cast<int>(k)] * part;
      std::ranges::copy(lean_of(sums, facets[from], at), out.transmission_lean.begin() + static_cast<ptrdiff_t>(to));
    }
  }
}

}  // namespace

void measure_transmission(ClothResponse& response, const Cloth& cloth, const ThreadSamples& threads,
                          const std::array<float, kResponseViews>& seen) {
  const std::vector<Lit> lit = lit_places(threads.behind, tones_of(response, cloth));
  std::array<Sums, 2> sums;
  size_t side_pairs = 0;
  for (const Lit& p : lit) side_pairs += p.in.size() * p.out.size();
  const size_t every = 1 + side_pairs / kMaxSidePairs;
  constexpr size_t kPairs = size_t{kResponseViews} * kBehindLights;
  for (Sums& of : sums) {
    of.body.resize(kPairs), of.side.resize(kPairs);
    of.leaning.fill(of.body);
  }
  for_each_job(kResponseElevations, [&](int e) {
    for (size_t k = 0; k < lit.size(); ++k) {
      for (const Out& out : lit[k].out) {
        if (out.view / kViewAzimuths == static_cast<size_t>(e))
          send(sums[static_cast<size_t>(lit[k].place->system)], lit[k], out,
               k % every == 0 ? static_cast<float>(every) : 0.0f);
      }
    }
  });
  const auto facets = seen_facets(threads.places);
  const auto scale = scales(response, threads.behind);
  for (size_t s = 0; s < 2; ++s) write_system(response.systems[s], sums[s], facets[s], scale[s], seen);
}

}  // namespace weftlight::light
