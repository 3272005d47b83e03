#pragma once
// The light that a cloth is looked at in: a set-up with a key light and large lamps as spherical Gaussians
// (presets/lights/*.json), projected to spherical harmonics of bands 0..2 once; or a picture from all around.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "draft/design.h"
#include "render_data/environment_light.h"
#include "render_data/names.h"

namespace weftlight::render_data {

inline constexpr float kKeyIrradiance = 2.3f;  // at right angles; a white Lambertian leaves 0.73
inline constexpr float kKeyRadius = 0.09f;  // sine of the key light's half angle where a rig does not say: a soft box

struct LightRig {
  glm::vec3 key{1};               // colour of the key light, white 1
  float key_radius = kKeyRadius;  // sine of its half angle
  Harmonics sky{};
  std::shared_ptr<const Environment> environment;  // then all light is the picture's
  std::vector<std::string> remarks;                // what was set right in the picture
};

/// From the text of a rig's file. `error` is "LINE: what is wrong", else empty.
LightRig light_rig_from(std::string_view json, std::string& error);
/// A set-up by name, presets/lights/NAME.json, or a picture by its path (is_environment of lights.h). `error` is
/// "FILE: what is wrong, and what to do", where it can with the line, else empty.
LightRig load_light_rig(const std::string& name, std::string& error);

/// What lights a scene: one to kMaxLights lights, the first the key light, and the sky.
struct SceneLight {
  std::vector<DistantLight> lights;
  Harmonics sky{};
};
SceneLight scene_light(const LightRig& rig, const Scene& scene);

/// Stops by which an environment is brighter or darker than the studio, made up for: pictures have units of their own.
/// 0 of a set-up.
float rig_exposure(const LightRig& rig);

/// Radiance of the sky along a world direction, >= 0 (frame.glsl has the same).
glm::vec3 sky_radiance(const Harmonics& sky, glm::vec3 towards);

}  // namespace weftlight::render_data
