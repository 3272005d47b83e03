#pragma once
// The soft light around the cloth: large lamps as spherical Gaussians (presets/lights/*.json), projected to
// spherical harmonics of bands 0..2 once.

#include <array>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "upload/names.h"

namespace weftlight::upload {

inline constexpr float kKeyIrradiance = 2.3f;  // at right angles; a white Lambertian leaves 0.73
inline constexpr float kKeyRadius = 0.09f;     // sine of the half angle of the key light: a soft box, not the sun

struct LightRig {
  glm::vec3 key{1};                // colour of the key light, white 1
  std::array<glm::vec3, 9> sky{};  // radiance coefficients, order Y00, Y1-1, Y10, Y11, Y2-2 .. Y22 (y, z, x)
};

/// From the text of a rig's file; numbers are held within +-1e6. `error` says what is wrong.
LightRig light_rig_from(std::string_view json, std::string& error);
/// Reads presets/lights/NAME.json. `error` says what is wrong.
LightRig load_light_rig(const std::string& name, std::string& error);

/// Radiance of the sky along a world direction, >= 0 (frame.glsl has the same).
glm::vec3 sky_radiance(const LightRig& rig, glm::vec3 towards);

}  // namespace weftlight::upload
