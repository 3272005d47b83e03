#include <algorithm>
#include <cmath>

#include "scene/camera.h"
#include "scene/light_rig.h"

namespace weftlight::scene {

using design::Scene;

SceneLight scene_light(const LightRig& rig, const Scene& scene) {
  SceneLight out;
  const bool pictured = rig.environment != nullptr;
  const float turn = scene.light_azimuth;
  if (pictured) {
    for (const DistantLight& light : rig.environment->lights())
      out.lights.push_back({turned(light.towards, turn), light.irradiance * scene.light_strength, light.radius});
    if (out.lights.empty()) out.lights.push_back({{0, 1, 0}, glm::vec3(0), kKeyRadius});
  } else {
    out.lights.push_back({direction_of(scene.light_azimuth, scene.light_elevation),
                          rig.key * (kKeyIrradiance * scene.light_strength), rig.key_radius});
  }
  out.sky = pictured ? turned(rig.environment->rest(), turn) : rig.sky;
  for (glm::vec3& c : out.sky) c *= scene.sky_strength;
  return out;
}

float rig_exposure(const LightRig& rig) {
  if (!rig.environment) return 0;
  constexpr float kStudio = 0.5f, kMax = 24;  // mean radiance of the studio, its key light and all
  const float mean = glm::dot(rig.environment->mean(), glm::vec3(0.2126f, 0.7152f, 0.0722f));
  return std::clamp(std::log2(kStudio / std::max(mean, 1e-12f)), -kMax, kMax);
}

}  // namespace weftlight::scene
