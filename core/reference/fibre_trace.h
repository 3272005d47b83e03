#pragma once
// Path tracing among fibres: each meeting scatters light as shaders/fibre.glsl says, and paths go on until they leave
// the cloth or Russian roulette ends them. Cloth space, millimetres.
//
// Based on: Kajiya 1986 (rendering equation, estimated by following paths); Arvo, Kirk 1990 (Russian roulette).

#include <glm/glm.hpp>
#include <optional>

#include "reference/fibre_scene.h"
#include "reference/sampling.h"
#include "reference/trace.h"

namespace weftlight::reference {

// Light that has met this many fibres is dropped; of white cotton less than one part in a thousand.
inline constexpr int kMaxFibres = 512;

class FibreTracer {
 public:
  /// dyed_alike: absorption of every fibre instead of its own.
  explicit FibreTracer(const FibreScene& fibres, std::optional<glm::vec3> dyed_alike = {})
      : fibres_(fibres), dyed_alike_(dyed_alike) {}
  /// One sample of the radiance along a ray.
  PathSample trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                   RandomStream& random) const;

 private:
  bool meet(glm::vec3 origin, glm::vec3 direction, float t_min, FibreHit& hit) const;

  const FibreScene& fibres_;
  std::optional<glm::vec3> dyed_alike_;
};

}  // namespace weftlight::reference
