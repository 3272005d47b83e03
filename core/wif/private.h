#pragma once
// Sections [PRIVATE WEFTLIGHT ...], for data that WIF has no keys for: tables shared by reading and writing.

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "design/design.h"
#include "design/methods.h"
#include "design/yarn_fields.h"

namespace weftlight::wif {

using design::ClothPlan, design::Look, design::Scene;

inline constexpr std::string_view kPrivate = "PRIVATE WEFTLIGHT ";

/// A number with its key; reading clamps it to low..high. For yarns see draft/yarn_fields.h.
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
/// Lengths in mm; the reader clamps them (cloth_plan.h).
inline constexpr FloatField<ClothPlan> kPlanFloats[] = {
    {"Width", &ClothPlan::width_mm, 0, design::kMaxClothMm},
    {"Length", &ClothPlan::length_mm, 0, design::kMaxClothMm},
    {"Fringe", &ClothPlan::fringe_mm, 0, design::kMaxClothMm},
    {"Loom Waste", &ClothPlan::loom_waste_mm, 0, design::kMaxClothMm},
    {"Warp Take-up", &ClothPlan::warp_take_up, 0, design::kMaxTakeUp},
    {"Weft Take-up", &ClothPlan::weft_take_up, 0, design::kMaxTakeUp},
    {"Warp Shrinkage", &ClothPlan::warp_shrinkage, 0, design::kMaxShrinkage},
    {"Weft Shrinkage", &ClothPlan::weft_shrinkage, 0, design::kMaxShrinkage},
    {"Spare", &ClothPlan::spare, 0, design::kMaxSpare},
    {"Ends Per Cm", &ClothPlan::ends_per_cm, 0, design::kMaxSettPerCm},
    {"Picks Per Cm", &ClothPlan::picks_per_cm, 0, design::kMaxSettPerCm},
    {"Bout", &ClothPlan::bout_mm, 1, design::kMaxClothMm},
    {"Raddle", &ClothPlan::raddle_mm, 1, design::kMaxClothMm},
};
/// After a yarn's number: its fibre by the name of the ready yarn, and the section of its fibres. As texts, since they
/// are always written; a file without them is from before they had names.
inline constexpr std::string_view kMadeOf = "Made Of", kSection = "Cross-section";
/// Limit of yarns whose purchase is known; their keys have a number before them.
inline constexpr int kMaxPurchases = 4096;

/// Versions have a section "VERSION 1", "VERSION 2" ..., and one for each of their sections: "VERSION 1 THREADING". A
/// section that is the same in an earlier version stands there alone: the version names it by a key with this suffix
/// and the number of that version.
inline constexpr std::string_view kVersion = "PRIVATE WEFTLIGHT VERSION ", kSameAsIn = " As In Version";
/// Limit of named views; each has a section "VIEW 1", "VIEW 2" ...
inline constexpr int kMaxViews = 200;
/// Limit of thread sections of each system.
inline constexpr int kMaxSections = 500;
/// Limit of generated weaves, and the prefix of the keys of their parameters.
inline constexpr int kMaxWeaveUses = 1000;
inline constexpr std::string_view kWeaveNumber = "Number ";

/// By value of the enum Leading.
inline constexpr const char* kLeadingNames[] = {"threading", "liftplan", "drawdown"};

/// A channel as WIF holds it: a whole number of low..high, rounded half up.
inline int channel_number(float channel, int low, int high) {
  const double clamped_channel = channel > 0 ? std::min(static_cast<double>(channel), 1.0) : 0.0;
  return low + static_cast<int>(std::floor(clamped_channel * (static_cast<double>(high) - low) + 0.5));
}

}  // namespace weftlight::wif
