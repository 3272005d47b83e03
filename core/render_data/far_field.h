#pragma once
// Method `cloth` on the CPU, from the data that the card gets: the radiance of a flat cloth towards a distant eye,
// under one light without sky.

#include <glm/glm.hpp>

#include "light/measure_response.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

using cloth::Cloth;
using light::ClothResponse, light::kResponseSamples;

struct FarField {
  interop::ClothData numbers{};  // of the first face only
  ClothResponse response;
};

/// For the face of the given cloth; takes about a tenth of a second. Empty without threads.
FarField far_field(const Cloth& cloth, int samples = kResponseSamples);

/// Radiance along `view` for unit irradiance at normal incidence from `light`; gaps reflect nothing. Unit vectors: x
/// along the weft, y along the warp, z out of the face; view.z > 0.
glm::vec3 far_field_radiance(const FarField& field, const glm::vec3& light, const glm::vec3& view);

/// Radiance along `view` under a sky of radiance `even` + dot(`rise`, d) in direction d, the same in all channels.
glm::vec3 far_field_sky_radiance(const FarField& field, const glm::vec3& view, float even, const glm::vec3& rise);

}  // namespace weftlight::render_data
