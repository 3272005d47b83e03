#pragma once
// Lighting presets: environment light (presets/lights/ID.json holds its lamps and the key light's colour) and the
// initial direction of the key light.

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "base/mark.h"
#include "design/design.h"

namespace weftlight::design {

using draft::Rgb;

struct LightingPreset {
  const char* id;     // Scene::lights, and the file in presets/lights
  const char* label;  // show tr(label), tr(tip)
  const char* tip;
  float azimuth, elevation;  // of the key light, degrees as in Scene
  float key, sky;            // strengths of key light and environment
  Rgb background;
  Rgb lit, shaded;  // sides of the white ball that the picker shows
};

inline constexpr std::array<LightingPreset, 6> kLightingPresets{{
    {"studio",
     base::mark("Studio"),
     base::mark("Softbox above, fill lights at the side and behind: for colour"),
     -50,
     48,
     1,
     1,
     {0.93f, 0.925f, 0.91f},
     {0.97f, 0.96f, 0.94f},
     {0.60f, 0.585f, 0.57f}},
    {"window",
     base::mark("Window"),
     base::mark("Daylight from one side, a dim room behind: for folds"),
     -68,
     30,
     1,
     1,
     {0.56f, 0.55f, 0.53f},
     {0.94f, 0.96f, 0.97f},
     {0.30f, 0.275f, 0.25f}},
    {"overcast",
     base::mark("Overcast"),
     base::mark("Grey sky all around, hardly any shadow: for weave and colour"),
     -20,
     75,
     0.3f,
     1,
     {0.83f, 0.845f, 0.86f},
     {0.94f, 0.95f, 0.96f},
     {0.70f, 0.71f, 0.725f}},
    {"evening_sun",
     base::mark("Evening sun"),
     base::mark("Low warm sun against a blue sky: for sheen"),
     48,
     20,
     1.2f,
     1,
     {0.80f, 0.71f, 0.62f},
     {1.0f, 0.87f, 0.70f},
     {0.44f, 0.46f, 0.56f}},
    {"gallery",
     base::mark("Gallery"),
     base::mark("Warm spots from high above in a dark room"),
     -25,
     62,
     1.3f,
     1,
     {0.21f, 0.195f, 0.18f},
     {0.99f, 0.94f, 0.86f},
     {0.33f, 0.30f, 0.265f}},
    {"grazing",
     base::mark("Grazing"),
     base::mark("Light that skims the cloth: every thread casts a shadow"),
     -82,
     12,
     1.9f,
     1,
     {0.30f, 0.305f, 0.315f},
     {1.0f, 0.98f, 0.95f},
     {0.16f, 0.165f, 0.175f}},
}};

/// The preset of that id, or the first if there is none.
constexpr const LightingPreset& lighting_preset(std::string_view id) {
  for (const LightingPreset& preset : kLightingPresets)
    if (id == preset.id) return preset;
  return kLightingPresets.front();
}

/// Whether `lights` is the path of an environment map (by its extension) and not the id of a preset.
constexpr bool is_environment(std::string_view lights) {
  if (lights.size() < 5) return false;
  constexpr auto kSame = [](std::string_view a, std::string_view b) {
    for (size_t i = 0; i < a.size(); ++i)
      if ((a[i] >= 'A' && a[i] <= 'Z' ? a[i] - 'A' + 'a' : a[i]) != b[i]) return false;
    return true;
  };
  const std::string_view ending = lights.substr(lights.size() - 4);
  return kSame(ending, ".hdr") || kSame(ending, ".exr");
}

/// The scene lit by an environment map, not rotated.
inline Scene lit_by_environment(Scene scene, std::string path) {
  scene.lights = std::move(path);
  scene.light_azimuth = 0;
  scene.light_strength = scene.sky_strength = 1;
  return scene;
}

/// The scene lit by a preset.
inline Scene lit_by(Scene scene, const LightingPreset& preset) {
  scene.lights = preset.id;
  scene.light_azimuth = preset.azimuth, scene.light_elevation = preset.elevation;
  scene.light_strength = preset.key, scene.sky_strength = preset.sky;
  scene.background = preset.background;
  return scene;
}

}  // namespace weftlight::design
