#pragma once
// The table of the methods in the chart: their style in figures, and the parts of a packed cloth that they read.

#include <array>

#include "chart/plot.h"
#include "design/methods.h"
#include "render_data/packed_maps.h"

namespace weftlight::chart {

using design::Method;
using render_data::PackedKind, render_data::kPackedKinds;

/// Bits for what a method reads beside the lights.
constexpr unsigned reads(PackedKind map) { return 1u << static_cast<unsigned>(map); }
inline constexpr unsigned kReadsMaps = 0b111;       // colour, relief and horizons
inline constexpr unsigned kReadsCubes = 1u << 4;    // a tabulated BRDF
inline constexpr unsigned kReadsLobes = 1u << 5;    // means over the cloth and the far-field BRDF
inline constexpr unsigned kReadsThreads = 1u << 6;  // thread by thread
static_assert(kReadsMaps == (reads(PackedKind::kColor) | reads(PackedKind::kRelief) | reads(PackedKind::kHorizon)));
static_assert(kReadsCubes == 1u << kPackedKinds);

struct ChartMethod {
  Method method;
  plot::Ink ink;
  plot::Marker marker;
  unsigned reads;
};
inline constexpr std::array kChartMethods{
    ChartMethod{Method::kFlat, {0.58, 0.60, 0.62}, plot::Marker::kSquare, reads(PackedKind::kColor)},
    ChartMethod{Method::kVrst03,
                {0.72, 0.43, 0.16},
                plot::Marker::kDiamond,
                reads(PackedKind::kColor) | reads(PackedKind::kShadow) | kReadsCubes},
    ChartMethod{Method::kIrawan, {0.78, 0.42, 0.62}, plot::Marker::kPlus, kReadsThreads},
    ChartMethod{Method::kCloth, {0.16, 0.44, 0.70}, plot::Marker::kUp, kReadsLobes},
    ChartMethod{Method::kRepeat,
                {0.10, 0.60, 0.50},
                plot::Marker::kDown,
                reads(PackedKind::kColor) | reads(PackedKind::kRelief) | kReadsLobes},
    ChartMethod{Method::kCell, {0.85, 0.65, 0.10}, plot::Marker::kCross, kReadsMaps | kReadsLobes},
    // From the horizons it reads the visibility of the sky.
    ChartMethod{Method::kYarn,
                {0.80, 0.27, 0.20},
                plot::Marker::kCircle,
                reads(PackedKind::kHorizon) | kReadsLobes | kReadsThreads},
    ChartMethod{Method::kEngine, {0.55, 0.38, 0.68}, plot::Marker::kRing, kReadsMaps | kReadsLobes},
    ChartMethod{Method::kAuto, {0.10, 0.11, 0.13}, plot::Marker::kStar, kReadsMaps | kReadsLobes | kReadsThreads},
};

/// Whether each method has a marker of its own: where the ink tells the footprint, nothing else tells them apart.
constexpr bool have_own_markers() {
  for (size_t i = 0; i < kChartMethods.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      if (kChartMethods[i].marker == kChartMethods[j].marker) return false;
  return true;
}
static_assert(have_own_markers());

/// The last entry for a method that is not in the chart.
constexpr const ChartMethod& chart_method(Method method) {
  for (const ChartMethod& m : kChartMethods)
    if (m.method == method) return m;
  return kChartMethods.back();
}

}  // namespace weftlight::chart
