#pragma once
// Measures as a weaver writes them, in metric units or in inches, yards, ounces and pounds. Everything is computed in
// millimetres and grams; only these texts know the units.

#include <optional>
#include <string>
#include <string_view>

#include "design/cloth_plan.h"
#include "draft/draft.h"

namespace weftlight::analysis {

using design::Reed;
using draft::System;

enum class Units { kMetric, kImperial };

/// By value of the enum Units, as options name them.
inline constexpr const char* kUnitsNames[] = {"metric", "imperial"};

// International yard and pound (1959).
inline constexpr double kInch_mm = 25.4, kYard_m = 0.9144, kOunce_g = 28.349523125, kPound_g = 453.59237;

/// Across the loom, or a short length: "55.0 cm", "21.7 in".
std::string width_text(double mm, Units units);
/// Of a small piece of cloth: "19 mm", "0.75 in".
std::string short_length_text(double mm, Units units);
/// Of a warp: "3.19 m", "3.49 yd".
std::string warp_length_text(double mm, Units units);
/// Of yarn: "312 m", "4.1 km"; "341 yd"; "under 1 m".
std::string yarn_length_text(double m, Units units);
/// "24 g", "1.20 kg"; "0.85 oz", "2.65 lb"; "under 1 g".
std::string weight_text(double g, Units units);
/// "214 g/m²", "6.3 oz/yd²".
std::string area_weight_text(double g_per_m2, Units units);
/// "10.0 ends per cm", "25.4 picks per inch".
std::string sett_text(double per_cm, System system, Units units);
/// As it is marked and sold: "40/10" (dents in 10 cm), "12 dents per inch".
std::string reed_text(const Reed& reed);

/// A length with its unit (mm, cm, m, in or ", ft, yd), as typed; without one, in mm. Empty if it cannot be read or is
/// below 0.
std::optional<double> length_mm_from_text(std::string_view text);
/// "40/10", or dents in an inch as "12/in", "12 dpi". Empty if it cannot be read or is out of range.
std::optional<Reed> reed_from_text(std::string_view text);

}  // namespace weftlight::analysis
