#pragma once
// Path tracing among fibres: each meeting scatters light as shaders/fibre.glsl says, and paths go on until they leave
// the cloth or Russian roulette ends them. Cloth space, millimetres.
//
// Based on: Kajiya 1986 (rendering equation, estimated by following paths); Arvo, Kirk 1990 (Russian roulette).

#include <glm/glm.hpp>

#include "reference/fibre_scene.h"
#include "reference/sampling.h"
#include "reference/trace.h"

namespace weftlight::reference {

// Light that has met this many fibres is dropped; of white cotton less than one part in a thousand.
inline constexpr int kMaxFibres = 512;

class FibreTracer {
 public:
  explicit FibreTracer(const FibreScene& fibres) : fibres_(fibres) {}
  /// One sample of the radiance along a ray.
  PathSample trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                   RandomStream& random) const;

 private:
  const FibreScene& fibres_;
};

}  // namespace weftlight::reference
