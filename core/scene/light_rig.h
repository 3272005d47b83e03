#pragma once
// Lighting of a cloth: a preset with a key light and large lamps as spherical Gaussians (presets/lights/*.json),
// projected to spherical harmonics of bands 0..2 once; or an environment map.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "design/design.h"
#include "scene/environment_light.h"

namespace weftlight::scene {

using design::Scene;

inline constexpr float kKeyIrradiance = 2.3f;  // at normal incidence; a white Lambertian then has radiance 0.73
inline constexpr float kKeyRadius = 0.09f;     // default sine of the key light's half angle: a soft box

struct LightRig {
  glm::vec3 key{1};               // colour of the key light, white 1
  float key_radius = kKeyRadius;  // sine of its half angle
  Harmonics sky{};
  std::shared_ptr<const Environment> environment;  // if set, all light comes from it
  std::vector<std::string> remarks;                // what was corrected in the environment map
};

/// From the text of a preset. Errors have the line.
base::Result<LightRig> light_rig_from(std::string_view json);
/// A lighting preset by name, presets/lights/NAME.json, or an environment map by its path (is_environment of
/// lights.h). Errors have the file, and the line if it is known.
base::Result<LightRig> load_light_rig(const std::string& name);

/// Lights of a scene: one to kMaxLights lights, the first the key light, and the sky.
struct SceneLight {
  std::vector<DistantLight> lights;
  Harmonics sky{};
};
SceneLight scene_light(const LightRig& rig, const Scene& scene);

/// Stops that compensate for an environment being brighter or darker than the studio, since environment maps have
/// arbitrary units. 0 for a preset.
float rig_exposure(const LightRig& rig);

/// Radiance of the sky along a world direction, >= 0 (frame.glsl has the same).
glm::vec3 sky_radiance(const Harmonics& sky, glm::vec3 towards);

}  // namespace weftlight::scene
