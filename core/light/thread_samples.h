#pragma once
// Surface samples spread over the threads of a cloth, and which directions each of them sees.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "light/formulas.h"

namespace weftlight::light {

using cloth::Cloth;
using draft::CellRect;

// Directions on a grid: elevation-major, azimuth 0 along the weft, 90 degrees along the warp. Views have twice as many
// azimuths as lights: where threads hide each other, visibility changes sharply near the threads' own directions.
inline constexpr int kResponseElevations =
    RESPONSE_ELEVATIONS;  // node k: cosine (k / 7)^2, the lowest a little above 0
inline constexpr int kViewAzimuths = RESPONSE_VIEWS_AROUND, kLightAzimuths = RESPONSE_LIGHTS_AROUND;
inline constexpr int kResponseViews = kResponseElevations * kViewAzimuths;
inline constexpr int kResponseLights = kResponseElevations * kLightAzimuths;

// Lights from behind the cloth are spaced more densely, since the openings that they come through are narrow. Node k:
// cosine 1 - (k / 11)^2, steps of about 8 degrees; the lowest reach nothing.
inline constexpr int kTransmissionElevations = TRANSMISSION_ELEVATIONS,
                     kTransmissionAzimuths = TRANSMISSION_LIGHTS_AROUND;
inline constexpr int kTransmissionLights = kTransmissionElevations * kTransmissionAzimuths;

inline constexpr int kLowViews = 2 * kViewAzimuths;  // nearly parallel to the cloth

/// The view in the direction of light i.
constexpr size_t view_of_light(size_t i) {
  return i / kLightAzimuths * kViewAzimuths + i % kLightAzimuths * (kViewAzimuths / kLightAzimuths);
}

/// Unit vectors; x along the weft, y along the warp, z out of the face.
std::array<glm::vec3, kResponseViews> response_views();
std::array<glm::vec3, kTransmissionLights> transmission_lights();

/// The darkest that a channel of a place is taken for, linear: 1 of 255. What is measured are ratios, which no colour
/// at all would not tell; pictures take them times the colour itself, and so send nothing of what is black.
inline constexpr float kDarkestChannel = 1 / (255 * 12.92f);

struct ThreadSample {
  int system = 0;  // 0 warp, 1 weft
  float area = 0;  // of the thread's surface that the sample represents, over that of the cloth's plane
  float height_mm = 0;
  glm::vec3 side{0, 0, 1};    // normal of the section
  glm::vec3 normal{0, 0, 1};  // with the relief of the plies
  glm::vec3 fibre{1, 0, 0};   // along the fibres on the surface
  float groove = 1;
  float around = 0;  // fraction of the crossings around that its own system has on top
  formulas::YarnLobes lobes;
  formulas::YarnLobes rendered;  // as the renderer has them in the far field, with grooves in the colours
  // Visibility by view, 0 or 1: not occluded by other threads; views on the far side may pass through its own thread.
  std::array<float, kResponseViews> open{};
  std::vector<uint16_t> lights;  // lights from behind that are occluded by no other thread
};

// Means of the unit normal's x and y and of their squares.
inline constexpr size_t kFacetMoments = 4;
using FacetMoments = std::array<float, kFacetMoments>;
FacetMoments facet_moments(const glm::vec3& normal);

/// A sample visible from straight above; all of them represent the same area.
struct TopSample {
  int system = 0;
  glm::vec3 normal{0, 0, 1}, fibre{1, 0, 0};
  glm::vec2 widths2{0};  // variances of the lobe's slopes along the fibre and across
};

struct ThreadSamples {
  std::vector<ThreadSample> samples;
  // Additional samples: those that light from behind reaches, without the lowest views; of the others those visible
  // from straight above, with that view only. area: as if there were no others.
  std::vector<ThreadSample> transmission;
  std::vector<TopSample> top;  // many more, since they are cheap
  // Mean and variance of the warp's fraction of the crossings around a sample (a tent nine wide), over the whole
  // cloth.
  float around_mean = 0, around_variance = 0;
  bool whole = true;  // false: sampled in windows, for a cloth of very many crossings
};

inline constexpr size_t kWholeCrossings = 1 << 18;  // larger cloths are sampled in windows
/// The threads of a window as a cloth of its own, single-layer.
Cloth cut(const Cloth& cloth, const CellRect& window);

/// `count` samples, deterministic, and `transmission_count` candidates for light from behind. A cloth of very many
/// crossings is sampled in windows spread over it. Samples that no direction reaches are left out.
ThreadSamples thread_samples(const Cloth& cloth, int count, int transmission_count = 0);

}  // namespace weftlight::light
