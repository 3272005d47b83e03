#pragma once
// How a cloth answers light from afar, measured on its own surface, one system of threads at a time: what of
// its facets light and eye both see, and how their slopes lie. Rungs `cloth` and `repeat` read it
// (shaders/rungs.glsl says how); it depends on the yarns' lobes, so it is made anew when they change.

#include <array>
#include <vector>

#include "cloth/maps.h"

namespace weftlight {

inline constexpr int kResponseElevations = 8;  // node k: cosine (k / 7)^2
inline constexpr int kResponseAzimuths = 16;
inline constexpr int kResponseDirections = kResponseElevations * kResponseAzimuths;
inline constexpr int kSlopeBins = 64;          // even in the slope's angle, -90 to 90 degrees

// What a footprint of the maps tells of its facets: means of the unit normal's x, y and of their squares.
inline constexpr size_t kFacetMoments = 4;

struct SystemResponse {
  // RGBA of [view][light]: body (times the thread's colour), what mirrors (over its closed form, facet_density()
  // of shaders/rungs.glsl times the share), fuzz and light scattered more than once, share of what is seen.
  // Directions: elevation-major. Over all the cloth that is seen.
  std::vector<float> broad;
  // [view][light], of each moment: how all that is sent rises where the facets of a place have more of it than those
  // of the whole cloth (`facets`); over the mean. Least squares over what is seen.
  std::vector<float> lean;
  std::array<float, kFacetMoments> facets{};
  std::vector<float> height_mm;   // [view]: mean height of what is seen
  // Density of the facets' slope angles along x and along y, micro-slopes in it; integral 1.
  std::array<std::array<float, kSlopeBins>, 2> slopes{};
  float share = 0;   // of the cover at normal view; both sum to 1
  Linear colour;     // mean, with grooves
};

/// Index 0 warp, 1 weft. `samples`: points of the surface it is measured at.
struct ClothResponse {
  std::array<SystemResponse, 2> systems;
  float sky = 1;     // mean share of the sky that is seen
};
ClothResponse cloth_response(const Cloth& cloth, const Maps& maps, int samples = 1280);

}  // namespace weftlight
