#pragma once
// How a cloth answers light from afar, measured on its own threads, one system at a time: what of
// its facets light and eye both see, and how their slopes lie. Rungs `cloth` and `repeat` read it
// (shaders/methods.glsl says how); it depends on the yarns' lobes, so it is made anew when they change.

#include <array>
#include <vector>

#include "cloth/maps.h"
#include "light/names.h"
#include "light/thread_samples.h"

namespace weftlight::light {

inline constexpr int kResponseSamples = 2048;       // means then hold 4 percent on the charts' cloths
inline constexpr int kSlopeBins = RESPONSE_SLOPES;  // even in the slope's angle, -90 to 90 degrees

// Density of the facets' slope angles along x and along y, micro-slopes in it; integral 1.
using FacetSlopes = std::array<std::array<float, kSlopeBins>, 2>;

struct SystemResponse {
  // RGBA of [view][light]: body (times the thread's colour), what mirrors (over its closed form, facet_density()
  // of shaders/methods.glsl times the share, and kUnseenFacets), fuzz (times its colour), light that facets scatter
  // more than once (times mean_fresnel() there). Directions: light/thread_samples.h. Over all the cloth that is seen.
  std::vector<float> broad;
  // The same of [view][light from behind] (thread_samples.h): through the threads or onto their sides, body times body
  // and through, what mirrors as it is. Other threads stop most of it.
  std::vector<float> behind;
  std::vector<float> transmission_lean;  // as `lean`, of what comes by the body and through
  // [view][light], of each moment: how all that is sent rises where the facets of a place have more of it than those
  // of the whole cloth (`facets`); over the mean. Least squares over what is seen.
  std::vector<float> lean;
  // RGBA of [view], under a sky that is 1 everywhere: body (times the thread's colour), fuzz (times its own), mirrored
  // light without Fresnel's term, and what facets scatter more than once, that times its rise at grazing.
  std::vector<float> sky;
  FacetMoments facets{};         // of the maps, seen from above
  std::vector<float> seen;       // [view]: share of it in what is seen
  std::vector<float> height_mm;  // [view]: mean height of what is seen
  FacetSlopes slopes{};
  float share = 0;  // of the cover at normal view, as rays see it; both sum to 1
  Linear colour;    // mean of the maps, with grooves
};

/// Index 0 warp, 1 weft. Means of colours and facets come from the maps; `samples`: places on the threads at
/// which the rest is measured.
struct ClothResponse {
  std::array<SystemResponse, 2> systems;
  float sky = 1;  // mean share of the sky that is seen
  // [view]: mean directions of the sky that is sent, by body and fuzz and as it is mirrored.
  std::vector<std::array<glm::vec3, 2>> sky_from;
  // [view]: what warp and weft send of an even sky, over what rung `yarn` makes of it place by place
  // (shaders/methods.glsl, facet_seen() and on); what the mean direction of the mirrored sky is beyond the rung's,
  // along the view and up.
  std::vector<glm::vec4> near_sky;
  // [view]: how the warp's share of what is seen rises with its share of the crossings around. 1 from above; more at a
  // slant, where the fewer threads lie hidden between the others.
  std::vector<float> seen_rise;
};
ClothResponse cloth_response(const Cloth& cloth, const Maps& maps, int samples = kResponseSamples);

/// Density (1/sr) of the facets of a system with such a share that mirror light from `l` to `v`, as pictures take it
/// from the slopes.
float closed_form(const FacetSlopes& slopes, float share, const glm::vec3& l, const glm::vec3& v);

}  // namespace weftlight::light
