// Few lights from behind reach a sample, so only those are evaluated, for the views that see it. Light through a
// thread leaves by the body alone; light on an overhanging side is mirrored as well.

#include "light/transmission_response.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/loops.h"
#include "light/facet_regression.h"
#include "light/formulas.h"
#include "light/yarn_lobes.h"

namespace weftlight::light {

using base::for_each_job;
using cloth::Linear;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

constexpr size_t kMaxSidePairs = 2'000'000;              // of views and lights; an open cloth has more than needed
constexpr size_t kTop = kResponseViews - kViewAzimuths;  // all views from straight above are the same

/// A view of a sample, and what the lobes do on the way out.
struct VisibleView {
  size_t view;
  glm::vec3 towards, local;
  float seen;  // projected area, over that of the cloth's plane
  float body;  // of body and transmission
  formulas::LobeSide side;
};

/// A light on an overhanging side.
struct SideLight {
  size_t light;
  glm::vec3 towards, local;
  formulas::LobeSide side;
};

/// A sample with one of its normals: with the relief of plies, or that of the section for the views that the former
/// faces away from.
struct TransmissionSample {
  const ThreadSample* sample;
  formulas::LobeShared shared;
  FacetMoments facets;
  std::vector<VisibleView> out;
  // For a range of lights: light into the body, and that times the transmittance of the fuzz.
  size_t first = 0;
  std::vector<float> bare, cleared;
  std::vector<SideLight> in;
};

/// [view][light].
struct Sums {
  std::vector<float> body;
  std::vector<glm::vec3> side;                                   // mirrored; fuzz; multiple scattering
  std::array<std::vector<float>, kFacetMoments> body_moments{};  // body, times each of the sample's moments
};

using Views = std::array<glm::vec3, kResponseViews>;
using Lights = std::array<glm::vec3, kTransmissionLights>;

void find_views(TransmissionSample& p, const formulas::LobeFrame& frame, bool own, const Views& views) {
  const ThreadSample& sample = *p.sample;
  const bool plain = sample.normal == sample.side;
  const glm::vec3 weights = body_weights(sample.lobes);
  for (size_t v = kLowViews; v <= kTop; ++v) {
    const float facing = glm::dot(sample.side, views[v]);
    if (facing <= 0 || sample.open[v] <= 0 || (!plain && own != (glm::dot(sample.normal, views[v]) > 0))) continue;
    const glm::vec3 local = formulas::lobe_local(frame, views[v]);
    const formulas::LobeSide side = formulas::lobe_side(sample.lobes, p.shared, local);
    const float seen = sample.area * facing;
    p.out.push_back({v, views[v], local, seen, seen * glm::dot(p.shared.body_scale * side.enters, weights), side});
  }
}

TransmissionSample transmission_sample(const ThreadSample& sample, const glm::vec3& normal, const Views& views,
                                       const Lights& lights) {
  const formulas::YarnLobes& lobes = sample.lobes;
  TransmissionSample p{&sample, formulas::lobe_shared(lobes), facet_moments(normal), {}, 0, {}, {}, {}};
  const formulas::LobeFrame frame = formulas::lobe_frame(normal, sample.fibre);
  find_views(p, frame, normal == sample.normal, views);
  if (sample.lights.empty()) p.out.clear();
  if (p.out.empty()) return p;
  const glm::vec3 weights = body_weights(lobes);
  const float body = channel_mean(lobes.body), through = channel_mean(lobes.through),
              both = std::max(body + through, 1e-6f);
  const auto [low, high] = std::minmax_element(sample.lights.begin(), sample.lights.end());
  p.first = *low;
  p.bare.assign(*high - *low + 1u, 0.0f);
  p.cleared = p.bare;
  for (const uint16_t i : sample.lights) {
    const glm::vec3 local = formulas::lobe_local(frame, lights[i]);
    const bool faces = local.z > 0;
    const formulas::LobeSide side = formulas::lobe_side(lobes, p.shared, {local.x, local.y, std::abs(local.z)});
    const float bare = std::abs(local.z) * glm::dot(side.enters, weights) * (faces ? body : through) / both;
    p.bare[i - p.first] = bare, p.cleared[i - p.first] = bare * side.clear;
    if (faces) p.in.push_back({i, lights[i], local, side});
  }
  return p;
}

/// Fresnel term of mirrored light, over the one that the renderer applies.
float fresnel_over_rendered(const ThreadSample& p, float grazing) {
  const float rising = formulas::layered_grazing(p.lobes.fibre_layers, grazing), f90 = p.lobes.f90;
  const float f0 = channel_mean(p.lobes.f0), drawn = channel_mean(p.rendered.f0);
  return (f0 + (f90 - f0) * rising) / (drawn + (f90 - drawn) * rising + 1e-6f);
}

/// Mirrored light and fuzz of a side, without the body.
glm::vec3 side_radiance(const TransmissionSample& p, const SideLight& in, const VisibleView& out) {
  const formulas::YarnLobes& lobes = p.sample->lobes;
  const float veiled = 1 - in.side.clear * out.side.clear;
  formulas::YarnLobes mirror = lobes;
  mirror.f0 = glm::vec3(1), mirror.f90 = 1;
  const float mirrored = formulas::lobe_specular(mirror, p.shared, in.side, out.side, in.local, out.local).g;
  const float grazing = std::max(1 - 0.5f * glm::length(in.towards + out.towards), 0.0f);
  glm::vec3 fuzz(0);
  if (lobes.fuzz > 0) {
    const glm::vec3 again = lobes.body * p.shared.mean_enters *
                            (in.side.fuzz.y * out.side.fuzz.y / (kPi * std::max(out.side.fuzz.w, 1e-4f)));
    fuzz = lobes.fuzz_colour * lobes.fuzz * (veiled / (4 * kPi * (in.side.mu + out.side.mu)) + again);
  }
  const ThreadSample& sample = *p.sample;
  const float recurring = channel_mean(p.shared.multiple) * in.side.loss * out.side.loss;
  return glm::vec3(mirrored * (1 - lobes.fuzz * veiled) * fresnel_over_rendered(sample, grazing),
                   channel_mean(fuzz) / std::max(channel_mean(sample.rendered.fuzz_colour), 1e-6f),
                   recurring / std::max(channel_mean(formulas::mean_fresnel(sample.rendered)), 1e-6f)) *
         (in.local.z * out.seen * sample.groove);
}

/// sides: weight of light on sides.
void add_view(Sums& sums, const TransmissionSample& p, const VisibleView& out, float sides) {
  const size_t row = out.view * kTransmissionLights;
  const float fuzz = p.sample->lobes.fuzz, bare = out.body * (1 - fuzz), cleared = out.body * fuzz * out.side.clear;
  const auto add = [&](std::vector<float>& to, float moment) {
    float* at = &to[row + p.first];
    const float b = bare * moment, c = cleared * moment;
    for (size_t i = 0; i < p.bare.size(); ++i) at[i] += b * p.bare[i] + c * p.cleared[i];
  };
  add(sums.body, 1);
  for (size_t k = 0; k < kFacetMoments; ++k) add(sums.body_moments[k], p.facets[k]);
  if (sides <= 0) return;
  for (const SideLight& in : p.in) sums.side[row + in.light] += sides * side_radiance(p, in, out);
}

/// Body and transmission, sum of the channels.
float tone_of(const formulas::YarnLobes& y) { return glm::dot(y.body + y.through, glm::vec3(1)); }

/// Tones of both systems, as the renderer has them.
std::array<float, 2> tones_of(const ClothResponse& response, const Cloth& cloth) {
  std::array<float, 2> out;
  for (size_t s = 0; s < 2; ++s) {
    const Linear& c = response.systems[s].colour;
    const glm::vec3 colour = glm::max(glm::vec3(c.r, c.g, c.b), kDarkestChannel);
    out[s] = tone_of(formulas::yarn_of(mean_yarn(cloth, s == 0 ? cloth.ends : cloth.picks), colour));
  }
  return out;
}

std::vector<TransmissionSample> transmission_samples(const std::vector<ThreadSample>& samples,
                                                     const std::array<float, 2>& tones) {
  const auto views = response_views();
  const auto lights = transmission_lights();
  std::vector<TransmissionSample> out(2 * samples.size());
  for_each_job(static_cast<int>(samples.size()), [&](int i) {
    const size_t k = static_cast<size_t>(i);
    out[2 * k] = transmission_sample(samples[k], samples[k].normal, views, lights);
    if (samples[k].normal != samples[k].side)
      out[2 * k + 1] = transmission_sample(samples[k], samples[k].side, views, lights);
    // Light passes at few samples, which may be darker than the mean of the system.
    const float tone =
        samples[k].groove * tone_of(samples[k].lobes) / std::max(tones[static_cast<size_t>(samples[k].system)], 1e-4f);
    for (TransmissionSample* p : {&out[2 * k], &out[2 * k + 1]})
      for (VisibleView& o : p->out) o.body *= tone;
  });
  std::erase_if(out, [](const TransmissionSample& p) { return p.out.empty(); });
  return out;
}

/// Views from straight above are the same; the lowest views take the values of the next higher ones.
size_t counted_view(size_t v) { return v < kLowViews ? v % kViewAzimuths + kLowViews : std::min(v, kTop); }

/// Visible facets of each system, by view. The low views are not measured.
std::array<std::vector<FacetRegression>, 2> visible_facets(const std::vector<ThreadSample>& samples) {
  std::array<std::vector<FacetRegression>, 2> out;
  for (auto& of : out) of.resize(kResponseViews);
  const auto views = response_views();
  for_each_job(kResponseElevations, [&](int e) {
    const size_t first = static_cast<size_t>(e) * kViewAzimuths;
    for (size_t v = first; v < first + kViewAzimuths; ++v) {
      for (const ThreadSample& p : samples) {
        const float seen = p.area * std::max(glm::dot(p.side, views[v]), 0.0f) * p.open[v];
        const glm::vec3& n = glm::dot(p.normal, views[v]) > 0 ? p.normal : p.side;
        if (seen > 0) out[static_cast<size_t>(p.system)][v].add(seen, facet_moments(n));
      }
      for (auto& of : out) of[v].finish();
    }
  });
  return out;
}

/// Scale of the sample areas: a system's fraction over its visible area from above. Samples that no light reaches
/// count, too: of a weft below long floats so few are visible that their number would be random.
std::array<float, 2> scales(const ClothResponse& response, const std::vector<ThreadSample>& samples) {
  std::array<float, 2> cover{}, out;
  for (const ThreadSample& p : samples)
    cover[static_cast<size_t>(p.system)] += p.area * std::max(p.side.z, 0.0f) * p.open[kTop];
  for (size_t s = 0; s < 2; ++s) out[s] = response.systems[s].fraction / std::max(cover[s], 1e-9f);
  return out;
}

/// Relative gradient of the body's light.
FacetMoments gradient_of(const Sums& sums, const FacetRegression& seen, size_t at) {
  FacetMoments products;
  for (size_t k = 0; k < kFacetMoments; ++k) products[k] = sums.body_moments[k][at];
  FacetMoments gradient = seen.rise(sums.body[at], products);
  for (float& l : gradient) l = std::clamp(l / std::max(sums.body[at], 1e-9f), -kMaxGradient, kMaxGradient);
  return gradient;
}

void write_system(SystemResponse& out, const Sums& sums, const std::vector<FacetRegression>& facets, float scale,
                  const std::array<float, kResponseViews>& seen) {
  for (size_t v = 0; v < kResponseViews; ++v) {
    for (size_t i = 0; i < kTransmissionLights; ++i) {
      const size_t from = counted_view(v), at = from * kTransmissionLights + i, to = 4 * (v * kTransmissionLights + i);
      const float part = scale / std::max(seen[from], 1e-9f);
      out.transmitted[to] = sums.body[at] * part;
      for (size_t k = 0; k < 3; ++k) out.transmitted[to + 1 + k] = sums.side[at][static_cast<int>(k)] * part;
      std::ranges::copy(gradient_of(sums, facets[from], at),
                        out.transmission_gradient.begin() + static_cast<ptrdiff_t>(to));
    }
  }
}

}  // namespace

void measure_transmission(ClothResponse& response, const Cloth& cloth, const ThreadSamples& threads,
                          const std::array<float, kResponseViews>& seen) {
  const std::vector<TransmissionSample> lit = transmission_samples(threads.transmission, tones_of(response, cloth));
  std::array<Sums, 2> sums;
  size_t side_pairs = 0;
  for (const TransmissionSample& p : lit) side_pairs += p.in.size() * p.out.size();
  const size_t every = 1 + side_pairs / kMaxSidePairs;
  constexpr size_t kPairs = size_t{kResponseViews} * kTransmissionLights;
  for (Sums& of : sums) {
    of.body.resize(kPairs), of.side.resize(kPairs);
    of.body_moments.fill(of.body);
  }
  for_each_job(kResponseElevations, [&](int e) {
    for (size_t k = 0; k < lit.size(); ++k) {
      for (const VisibleView& out : lit[k].out) {
        if (out.view / kViewAzimuths == static_cast<size_t>(e))
          add_view(sums[static_cast<size_t>(lit[k].sample->system)], lit[k], out,
                   k % every == 0 ? static_cast<float>(every) : 0.0f);
      }
    }
  });
  const auto facets = visible_facets(threads.samples);
  const auto scale = scales(response, threads.transmission);
  for (size_t s = 0; s < 2; ++s) write_system(response.systems[s], sums[s], facets[s], scale[s], seen);
}

}  // namespace weftlight::light
