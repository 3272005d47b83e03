#pragma once
// What rung `cloth` draws of one face, worked out on the processor from the numbers that the card is sent: the radiance
// that a flat cloth sends to an eye far off under one light and no sky.

#include <glm/glm.hpp>

#include "light/cloth_response.h"
#include "render_data/names.h"
#include "shaders/interop.h"

namespace weftlight::render_data {

struct FarField {
  interop::ClothData numbers{};  // the first face alone
  ClothResponse response;
};

/// Of the face that the cloth is; about a tenth of a second. Cloth without threads answers nothing.
FarField far_field(const Cloth& cloth, int samples = kResponseSamples);

/// Radiance along `view` per unit irradiance on a plane perpendicular to the beam that comes from `light`; gaps send
/// nothing. Unit vectors: x along the weft, y along the warp, z out of the face; view.z > 0.
glm::vec3 radiance_from_afar(const FarField& answer, const glm::vec3& light, const glm::vec3& view);

/// Radiance along `view` under a sky of radiance `even` + dot(`rise`, d) towards d, alike in all channels.
glm::vec3 sky_from_afar(const FarField& answer, const glm::vec3& view, float even, const glm::vec3& rise);

}  // namespace weftlight::render_data
