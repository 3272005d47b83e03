// Few lights reach a place from behind, so only those are gone through, for the views that see it. What comes through a
// thread is body alone; what falls on a side that hangs over mirrors as well.

#include "light/behind_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

constexpr size_t kMostSidePairs = 2'000'000;  // of views and lights; of open cloth some of the places tell enough
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
  const ThreadPlace* place;
  formulas::LobeShared shared;
  std::vector<Out> out;
  // Of a run of lights: what enters the body, and that times what is clear of its fuzz.
  size_t first = 0;
  std::vector<float> bare, cleared;
  std::vector<In> in;
};

/// [view][light].
struct Sums {
  std::vector<float> body;
  std::vector<glm::vec2> side;  // mirrored; fuzz and the like
};

using Views = std::array<glm::vec3, kResponseViews>;
using Lights = std::array<glm::vec3, kBehindLights>;

void look_out(Lit& p, const formulas::LobeFrame& frame, bool own, const Views& views) {
  const ThreadPlace& place = *p.place;
  const bool plain = place.normal == place.side;
  for (size_t v = kLowViews; v <= kTop; ++v) {
    const float facing = glm::dot(place.side, views[v]);
    if (facing <= 0 || place.open[v] <= 0 || (!plain && own != (glm::dot(place.normal, views[v]) > 0))) continue;
    const glm::vec3 local = formulas::lobe_local(frame, views[v]);
    const formulas::LobeSide side = formulas::lobe_side(place.lobes, p.shared, local);
    const float seen = place.area * facing;
    p.out.push_back({v, views[v], local, seen, seen * p.shared.body_scale.g * side.enters.g, side});
  }
}

Lit lit_place(const ThreadPlace& place, const glm::vec3& normal, const Views& views, const Lights& lights) {
  const formulas::YarnLobes& lobes = place.lobes;
  Lit p{&place, formulas::lobe_shared(lobes), {}, 0, {}, {}, {}};
  const formulas::LobeFrame frame = formulas::lobe_frame(normal, place.fibre);
  look_out(p, frame, normal == place.normal, views);
  if (p.out.empty()) return p;
  const float both = std::max(lobes.body.g + lobes.through.g, 1e-6f);
  const auto [low, high] = std::minmax_element(place.behind.begin(), place.behind.end());
  p.first = *low;
  p.bare.assign(*high - *low + 1u, 0.0f);
  p.cleared = p.bare;
  for (const uint16_t i : place.behind) {
    const glm::vec3 local = formulas::lobe_local(frame, lights[i]);
    const bool faces = local.z > 0;
    const formulas::LobeSide side = formulas::lobe_side(lobes, p.shared, {local.x, local.y, std::abs(local.z)});
    const float bare = std::abs(local.z) * side.enters.g * (faces ? lobes.body.g : lobes.through.g) / both;
    p.bare[i - p.first] = bare, p.cleared[i - p.first] = bare * side.clear;
    if (faces) p.in.push_back({i, lights[i], local, side});
  }
  return p;
}

/// Fresnel's term of what mirrors, over that which pictures give it.
float fresnel_over_drawn(const ThreadPlace& p, float grazing) {
  const float rising = formulas::pile_grazing(p.lobes.pile, grazing), f90 = p.lobes.f90;
  return (p.lobes.f0.g + (f90 - p.lobes.f0.g) * rising) / (p.drawn.f0.g + (f90 - p.drawn.f0.g) * rising + 1e-6f);
}

/// Without what the body sends.
glm::vec2 sent_by_side(const Lit& p, const In& in, const Out& out) {
  const formulas::YarnLobes& lobes = p.place->lobes;
  const float veiled = 1 - in.side.clear * out.side.clear;
  formulas::YarnLobes mirror = lobes;
  mirror.f0 = glm::vec3(1), mirror.f90 = 1;
  const float mirrored = formulas::lobe_specular(mirror, p.shared, in.side, out.side, in.local, out.local).g;
  const float grazing = std::max(1 - 0.5f * glm::length(in.towards + out.towards), 0.0f);
  float combed = p.shared.multiple.g * in.side.lost * out.side.lost;
  if (lobes.fuzz > 0) {
    const float again = lobes.body.g * p.shared.mean_enters.g * in.side.fuzz.y * out.side.fuzz.y /
                        (kPi * std::max(out.side.fuzz.w, 1e-4f));
    combed += lobes.fuzz_colour.g * lobes.fuzz * (veiled / (4 * kPi * (in.side.mu + out.side.mu)) + again);
  }
  const ThreadPlace& place = *p.place;
  const float drawn_hair = lobes.fuzz > 0 ? place.drawn.fuzz_colour.g : place.drawn.f0.g / std::max(lobes.f90, 1e-3f);
  return glm::vec2(mirrored * (1 - lobes.fuzz * veiled) * fresnel_over_drawn(place, grazing),
                   combed / std::max(drawn_hair, 1e-4f)) *
         (in.local.z * out.seen * place.groove);
}

/// sides: what light on sides counts for.
void send(Sums& sums, const Lit& p, const Out& out, float sides) {
  const size_t row = out.view * kBehindLights;
  const float fuzz = p.place->lobes.fuzz, bare = out.body * (1 - fuzz), cleared = out.body * fuzz * out.side.clear;
  float* body = &sums.body[row + p.first];
  for (size_t i = 0; i < p.bare.size(); ++i) body[i] += bare * p.bare[i] + cleared * p.cleared[i];
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
    out[s] = tone_of(formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), {c.r, c.g, c.b}));
  }
  return out;
}

std::vector<Lit> lit_places(const std::vector<ThreadPlace>& places, const std::array<float, 2>& tones) {
  const auto views = response_views();
  const auto lights = behind_lights();
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

}  // namespace

void take_behind(ClothResponse& response, const Cloth& cloth, const std::vector<ThreadPlace>& places,
                 const std::array<float, 2>& scale, const std::array<float, kResponseViews>& seen) {
  const std::vector<Lit> lit = lit_places(places, tones_of(response, cloth));
  std::array<Sums, 2> sums;
  size_t side_pairs = 0;
  for (const Lit& p : lit) side_pairs += p.in.size() * p.out.size();
  const size_t every = 1 + side_pairs / kMostSidePairs;
  constexpr size_t kPairs = size_t{kResponseViews} * kBehindLights;
  for (Sums& of : sums) of = {std::vector<float>(kPairs), std::vector<glm::vec2>(kPairs)};
  for_each_job(kResponseElevations, [&](int e) {
    for (size_t k = 0; k < lit.size(); ++k) {
      for (const Out& out : lit[k].out) {
        if (out.view / kViewAzimuths == static_cast<size_t>(e))
          send(sums[static_cast<size_t>(lit[k].place->system)], lit[k], out,
               k % every == 0 ? static_cast<float>(every) : 0.0f);
      }
    }
  });
  for (size_t s = 0; s < 2; ++s) {
    std::vector<float>& to = response.systems[s].behind;
    for (size_t v = 0; v < kResponseViews; ++v) {
      for (size_t i = 0; i < kBehindLights; ++i) {
        const size_t from = counted_view(v), at = from * kBehindLights + i;
        const float part = scale[s] / std::max(seen[from], 1e-9f);
        float* texel = &to[4 * (v * kBehindLights + i)];
        texel[0] = sums[s].body[at] * part, texel[1] = sums[s].side[at].x * part, texel[2] = sums[s].side[at].y * part;
      }
    }
  }
}

}  // namespace weftlight::light
