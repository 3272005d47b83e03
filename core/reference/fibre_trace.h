#pragma once
// Path tracing among fibres: each meeting scatters light as shaders/fibre.glsl says, and paths go on until they leave
// the cloth or Russian roulette ends them. Cloth space, millimetres.
//
// Based on: Kajiya 1986 (rendering equation, estimated by following paths); Arvo, Kirk 1990 (Russian roulette);
// Kaplanyan, Dachsbacher 2013 (scattering that is spread a little, and less with each sample, instead of grain).

#include <glm/glm.hpp>
#include <optional>

#include "reference/fibre_scene.h"
#include "reference/sampling.h"
#include "reference/trace.h"

namespace weftlight::reference {

// Light that has met this many fibres is dropped; of white cotton less than one part in a thousand.
inline constexpr int kMaxFibres = 512;

/// How far the lamp's light is spread in a picture of so many samples a pixel, radians: the mean error of a picture is
/// no larger for it, its variance is about half, and with more samples it becomes the truth.
float lamp_spread(int samples);

class FibreTracer {
 public:
  /// dyed_alike: absorption of every fibre of depth 1, instead of its own. spread: by how much more, radians, fibres
  /// that are not seen themselves spread the lamp's light along them, after several; three times as much around them.
  /// 0: the truth, of whose paths a few are far brighter than all others, since a fibre sends most of a lamp's light
  /// one way.
  explicit FibreTracer(const FibreScene& fibres, std::optional<glm::vec3> dyed_alike = {}, float spread = 0)
      : fibres_(fibres), dyed_alike_(dyed_alike), spread_(spread) {}
  /// One sample of the radiance along a ray.
  PathSample trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around,
                   RandomStream& random) const;

 private:
  bool meet(glm::vec3 origin, glm::vec3 direction, float t_min, FibreHit& hit) const;

  const FibreScene& fibres_;
  std::optional<glm::vec3> dyed_alike_;
  float spread_;
};

}  // namespace weftlight::reference
