#pragma once
// Far-field reflectance of a cloth, measured on its own threads (measure_response.h), for each system: which facets are
// visible to both light and eye, and the distribution of their slopes. Methods `cloth` and `repeat` read it
// (shaders/methods.glsl). It depends on the yarns' lobes, so it is measured again when they change.

#include <array>
#include <vector>

#include "cloth/maps.h"
#include "light/facet_slopes.h"
#include "light/thread_samples.h"

namespace weftlight::light {

using cloth::Linear;

struct SystemResponse {
  // RGBA of [view][light]: body (to be multiplied by the thread's colour); mirrored light over its closed form
  // (facet_density() of shaders/methods.glsl times the fraction, plus kFacetDensityFloor), as stored_mirror() there;
  // fuzz (to be multiplied by its colour); multiple scattering of facets (by mean_fresnel() there). Directions:
  // light/thread_samples.h. Relative to all visible cloth.
  std::vector<float> reflected;
  // The same for [view][light from behind] (thread_samples.h), through the threads or onto their sides: body includes
  // transmission, mirrored light is not divided by a closed form. Most of this light is stopped by other threads.
  std::vector<float> transmitted;
  std::vector<float> transmission_gradient;  // as `gradient`, of body and transmission
  // [view][light][moment]: relative change of the reflected light with each moment of the local facets, against the
  // mean facets of the cloth (`facets`). Least squares over the visible samples.
  std::vector<float> gradient;
  // RGBA of [view] under a uniform sky of radiance 1: body (to be multiplied by the thread's colour), fuzz (by its
  // own), mirrored light without the Fresnel term plus multiple scattering, that times its rise towards grazing.
  std::vector<float> sky;
  FacetMoments facets{};         // from the maps, visible from above
  std::vector<float> seen;       // [view]: its fraction of the visible cloth
  std::vector<float> height_mm;  // [view]: mean height of the visible surface
  FacetSlopes slopes;            // of those visible from above
  float fraction = 0;            // of the coverage at normal view, by rays; both systems sum to 1
  Linear colour;                 // mean of the maps, with grooves
};

/// Index 0 warp, 1 weft. Mean colours and facets come from the maps; everything else is measured at `samples` surface
/// samples of the threads.
struct ClothResponse {
  std::array<SystemResponse, 2> systems;
  float sky = 1;  // mean visible fraction of the sky
  // [view]: mean directions of the sky light that is reflected, by body and fuzz, and mirrored.
  std::vector<std::array<glm::vec3, 2>> sky_from;
  // [view]: x, y: reflected light of a uniform sky by warp and weft, over what method `yarn` estimates sample by
  // sample (facet_sky_visibility() etc. of shaders/methods.glsl); z, w: mean direction of the mirrored sky minus that
  // method's, along the view and up.
  std::vector<glm::vec4> near_sky;
  // [view]: x, y: of the light that method `yarn` would reflect under a uniform sky if no thread hid any of it, what
  // comes from hidden directions, by warp and weft; to be multiplied by unhidden_reflectance() of shaders/methods.glsl,
  // relative to all visible cloth. z, w: the same weighted by the visible fraction of the sky, over itself.
  std::vector<glm::vec4> hidden;
  // [view]: change of the warp's visible fraction with its fraction of the crossings around. 1 from above; more at a
  // slant, where the fewer threads are hidden between the others.
  std::vector<float> visible_rise;
};

/// The four nodes of the tables around a view, with their weights.
struct ViewNodes {
  std::array<size_t, 4> at{};
  std::array<float, 4> weight{};
};
ViewNodes view_nodes(const glm::vec3& view);
/// Reflected light (from behind: transmitted) between the nodes of light and view, as response_at() of
/// shaders/method_repeat.glsl.
glm::vec4 response_at(const SystemResponse& system, const glm::vec3& light, const glm::vec3& view);

}  // namespace weftlight::light
