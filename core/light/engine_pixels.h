#pragma once
// What the pixels of an engine send to each view from each light, by part: the equations of the fit (engine_fit.h).

#include <glm/glm.hpp>
#include <vector>

#include "light/engine_directions.h"
#include "light/engine_fit.h"

namespace weftlight::light {

/// Radiance of the texels for a pair, by part, for factors of one.
struct PairRadiance {
  glm::vec3 body{0}, gloss{0}, grazing{0}, fuzz{0};
};

/// Of each pair of the directions. The bits depend on neither the cores nor their vectors.
std::vector<PairRadiance> texel_radiance(const EngineTexels& texels, const EngineDirections& directions,
                                         const EngineModel& model, const EngineFit& fit);

}  // namespace weftlight::light
