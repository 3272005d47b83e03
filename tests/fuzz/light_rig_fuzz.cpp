// Any text as a light rig: parsing never crashes, and its sky is finite everywhere.

#include <cmath>
#include <cstdint>

#include "require.h"
#include "scene/light_rig.h"

using weftlight::scene::LightRig, weftlight::scene::light_rig_from, weftlight::scene::sky_radiance;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const weftlight::base::Result<LightRig> rig = light_rig_from({reinterpret_cast<const char*>(data), size});
  if (!rig) return 0;
  for (const glm::vec3 towards : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0, 0, 1)}) {
    const glm::vec3 sky = sky_radiance(rig->sky, towards);
    for (int k = 0; k < 3; ++k) require(std::isfinite(sky[k]) && sky[k] >= 0, "radiance is finite and not negative");
  }
  return 0;
}
