#pragma once
// What WIF has no place for, in sections [PRIVATE WEFTLIGHT ...]: the tables that reading and writing
// share.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "draft/design.h"
#include "wif/names.h"

namespace weftlight::wif {

inline constexpr std::string_view kPrivate = "PRIVATE WEFTLIGHT ";

/// A number kept under a key; reading clamps it to low..high (the ranges of yarn.h).
template <class T>
struct FloatField {
  const char* key;
  float T::*member;
  float low, high;
};

inline constexpr float kAny = 1e30f;

inline constexpr FloatField<Yarn> kYarnFloats[] = {
    {"Diameter", &Yarn::diameter_mm, 0, 50}, {"Turns", &Yarn::turns_per_m, 0, 5000},
    {"Fibre", &Yarn::fibre_um, 1, 2000},     {"Grooves", &Yarn::groove_depth, 0, 1},
    {"Hairiness", &Yarn::hairiness, 0, 1},   {"Flattening", &Yarn::flattening, 0.3f, 1},
};
inline constexpr FloatField<Lobes> kLobeFloats[] = {
    {"Specular", &Lobes::specular, 0, 1},
    {"IOR", &Lobes::ior, 1, 3},
    {"Along", &Lobes::along_width, 0, 4},
    {"Across", &Lobes::across_width, 0, 4},
    {"Body", &Lobes::body, 0, 1},
    {"Fuzz", &Lobes::fuzz, 0, 1},
    {"Fuzz Width", &Lobes::fuzz_width, 0.05f, 1},
    {"Transmission", &Lobes::transmission, 0, 1},
};
inline constexpr FloatField<Scene> kSceneFloats[] = {
    {"View Azimuth", &Scene::view_azimuth, -kAny, kAny},
    {"View Elevation", &Scene::view_elevation, -kAny, kAny},
    {"View Distance", &Scene::view_distance, -kAny, kAny},
    {"Pan X", &Scene::pan_x, -kAny, kAny},
    {"Pan Y", &Scene::pan_y, -kAny, kAny},
    {"Light Azimuth", &Scene::light_azimuth, -kAny, kAny},
    {"Light Elevation", &Scene::light_elevation, -kAny, kAny},
    {"Light Strength", &Scene::light_strength, -kAny, kAny},
    {"Sky Strength", &Scene::sky_strength, -kAny, kAny},
};
inline constexpr FloatField<Look> kLookFloats[] = {
    {"Tolerance", &Look::tolerance, -kAny, kAny},
    {"Exposure", &Look::exposure_ev, -kAny, kAny},
};
/// By value of the enums Twist and Method.
inline constexpr const char* kTwistNames[] = {"none", "S", "Z"};
inline constexpr const char* kMethodNames[] = {"auto", "flat", "vrst03", "cloth",    "repeat",
                                               "cell", "yarn", "engine", "reference"};

/// A channel as WIF holds it: a whole number of low..high, rounded half up.
inline int channel_number(float channel, int low, int high) {
  const double share = channel > 0 ? std::min(static_cast<double>(channel), 1.0) : 0.0;
  return low + static_cast<int>(std::floor(share * (static_cast<double>(high) - low) + 0.5));
}

}  // namespace weftlight::wif
