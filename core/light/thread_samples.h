#pragma once
// Places spread over the threads of a cloth, as bodies, and which directions each of them sees.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/cloth.h"
#include "light/formulas.h"
#include "light/names.h"

namespace weftlight::light {

// Directions on a grid: elevation-major, azimuth 0 along the weft, 90 degrees along the warp. Views twice as close:
// where threads hide behind each other, what is seen turns sharply about the threads' own directions.
inline constexpr int kResponseElevations =
    RESPONSE_ELEVATIONS;  // node k: cosine (k / 7)^2, the lowest a little above 0
inline constexpr int kViewAzimuths = RESPONSE_VIEWS_AROUND, kLightAzimuths = RESPONSE_LIGHTS_AROUND;
inline constexpr int kResponseViews = kResponseElevations * kViewAzimuths;
inline constexpr int kResponseLights = kResponseElevations * kLightAzimuths;

// Lights from behind the cloth, closer, since what they come through is narrow: node k: cosine 1 - (k / 11)^2, steps of
// some 8 degrees; those along the cloth reach nothing.
inline constexpr int kBehindElevations = BEHIND_ELEVATIONS, kBehindAzimuths = BEHIND_AROUND;
inline constexpr int kBehindLights = kBehindElevations * kBehindAzimuths;

inline constexpr int kLowViews = 2 * kViewAzimuths;  // along the cloth, as good as

/// The view from which light i comes.
constexpr size_t view_of_light(size_t i) {
  return i / kLightAzimuths * kViewAzimuths + i % kLightAzimuths * (kViewAzimuths / kLightAzimuths);
}

/// Unit vectors; x along the weft, y along the warp, z out of the face.
std::array<glm::vec3, kResponseViews> response_views();
std::array<glm::vec3, kBehindLights> transmission_lights();

/// The darkest that a channel of a place is taken for, linear: 1 of 255. What is measured are ratios, which no colour
/// at all would not tell; pictures take them times the colour itself, and so send nothing of what is black.
inline constexpr float kDarkestChannel = 1 / (255 * 12.92f);

struct ThreadSample {
  int system = 0;  // 0 warp, 1 weft
  float area = 0;  // of the thread that the place stands for, over that of the cloth's plane
  float height_mm = 0;
  glm::vec3 side{0, 0, 1};    // normal of the section
  glm::vec3 normal{0, 0, 1};  // between plies, too
  glm::vec3 fibre{1, 0, 0};   // along the fibres on the surface
  float groove = 1;
  float around = 0;  // share of the crossings around it that its own system has on top
  formulas::YarnLobes lobes;
  formulas::YarnLobes drawn;  // as pictures from afar take them, of colours with grooves in them
  // Per view, 0 or 1: nothing stands before it; for those behind the place, nothing but its own thread.
  std::array<float, kResponseViews> open{};
  std::vector<uint16_t> behind;  // lights from behind before which nothing but its own thread stands
};

// Means of the unit normal's x, y and of their squares.
inline constexpr size_t kFacetMoments = 4;
using FacetMoments = std::array<float, kFacetMoments>;
FacetMoments facet_moments(const glm::vec3& normal);

/// A place seen from straight above; all such stand for the same area.
struct TopPlace {
  int system = 0;
  glm::vec3 normal{0, 0, 1}, fibre{1, 0, 0};
  glm::vec2 widths2{0};  // variances of the lobe's slopes along the fibre and across
};

struct ThreadSamples {
  std::vector<ThreadSample> places;
  // Of more, those that light from behind reaches, without views along the cloth, and of the others those that are seen
  // from straight above, with that view alone; area: as if there were no others.
  std::vector<ThreadSample> behind;
  std::vector<TopPlace> top;  // many more: they cost little
  // Of the warp's share of the crossings around a place (a tent nine wide), over the whole cloth.
  float around_mean = 0, around_variance = 0;
  bool whole = true;  // not windows of a cloth of very many crossings
};

inline constexpr size_t kWholeCrossings = 1 << 18;  // up to which a cloth is taken whole, else in windows
/// The threads of a window as a cloth of their own, of one layer.
Cloth cut(const Cloth& cloth, const CellRect& window);

/// `count` places, the same every time, and `behind` that are tried for light from behind. Of a cloth of very many
/// crossings: in windows spread over it. Those that no direction reaches are left out.
ThreadSamples thread_samples(const Cloth& cloth, int count, int behind = 0);

}  // namespace weftlight::light
