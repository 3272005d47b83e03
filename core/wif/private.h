#pragma once
// What WIF has no place for, in sections [PRIVATE WEFTLIGHT ...]: the tables that reading and writing
// share.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "draft/design.h"
#include "draft/methods.h"
#include "draft/yarn_fields.h"
#include "wif/names.h"

namespace weftlight::wif {

inline constexpr std::string_view kPrivate = "PRIVATE WEFTLIGHT ";

/// A number kept under a key; reading clamps it to low..high. Those of yarns are in draft/yarn_fields.h.
template <class T>
struct FloatField {
  const char* key;
  float T::*member;
  float low, high;
};

inline constexpr float kAny = 1e30f;

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
/// Views that a file may keep, a section each: "VIEW 1", "VIEW 2" ...
inline constexpr int kMaxViews = 200;
/// Sections of threads that a file may keep for each system, and what their rows may take together.
inline constexpr int kMaxSections = 500;
/// Generated weaves that a file may name, and what stands before the id of each of their numbers.
inline constexpr int kMaxWeaveUses = 1000;
inline constexpr std::string_view kWeaveNumber = "Number ";

/// By value of the enum Leading.
inline constexpr const char* kLeadingNames[] = {"threading", "liftplan", "drawdown"};

/// A channel as WIF holds it: a whole number of low..high, rounded half up.
inline int channel_number(float channel, int low, int high) {
  const double share = channel > 0 ? std::min(static_cast<double>(channel), 1.0) : 0.0;
  return low + static_cast<int>(std::floor(share * (static_cast<double>(high) - low) + 0.5));
}

}  // namespace weftlight::wif
