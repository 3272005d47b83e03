#pragma once
// Directions in which a material is compared with the far field of its cloth, and what the cloth reflects there.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "light/cloth_response.h"

namespace weftlight::light {

using cloth::Cloth;

struct EnginePair {
  size_t view = 0, light = 0;  // in EngineDirections
  glm::vec3 wanted{0};         // radiance of the cloth for unit irradiance at normal incidence
  float fraction = 0;          // of the mean over the lights of the view
};

/// Lights of one view whose mean is compared as well: pairs [first, first + count).
struct EngineView {
  size_t view = 0;
  float view_deg = 0;  // from the normal
  size_t first = 0, count = 0;
  float weight = 1;  // of the square of the mean's relative error; of all pairs together `shape`
  float shape = 0;
};

/// Unit vectors; x along the weft, y along the warp, z out.
struct EngineDirections {
  std::vector<glm::vec3> views, lights;
  std::vector<EnginePair> pairs;
  std::vector<EngineView> means;
};

/// Radiance of the cloth in the far field, without gaps, as method `cloth` draws it.
class FarRadiance {
 public:
  FarRadiance(const Cloth& cloth, const ClothResponse& response);
  glm::vec3 at(const glm::vec3& light, const glm::vec3& view) const;
  /// The mean of a pair of directions and the same pair turned by 180 degrees: materials have that symmetry.
  glm::vec3 even(const glm::vec3& light, const glm::vec3& view) const;

 private:
  const ClothResponse& response_;
  std::array<formulas::YarnLobes, 2> yarns_;
};

/// For a fit: views to 75 degrees in the planes along warp and weft and between them, with lights in the plane of the
/// view and around. Weights of the squared relative errors of means: in the planes of the threads, and over all
/// azimuths at an elevation (0: none).
EngineDirections fit_directions(const FarRadiance& cloth, float plane_weight, float ring_weight);
/// The plane along the warp (or weft): views at 0, 30, 60 and 75 degrees, with lights in it to 80 degrees.
EngineDirections plane_directions(const FarRadiance& cloth, bool warp);
/// The grid of the response: views and lights at 0, 43, 59, 71 and 79 degrees over all azimuths.
EngineDirections grid_directions(const FarRadiance& cloth);

/// Views at the same along warp and weft, lit from 43 degrees along the warp, then along the weft: from the top of an
/// image, and from its left. Without means.
EngineDirections check_directions(const FarRadiance& cloth);

}  // namespace weftlight::light
