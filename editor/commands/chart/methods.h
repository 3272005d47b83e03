#pragma once
// The one table of what the chart compares: how each method is drawn in the figures, and what of a packed cloth it
// reads.

#include <array>

#include "commands/chart/plot.h"
#include "draft/methods.h"
#include "render_data/packed_maps.h"

namespace weftlight::chart {

/// What a method reads beside the lights, by bits.
constexpr unsigned reads(PackedKind map) { return 1u << static_cast<unsigned>(map); }
inline constexpr unsigned kReadsMaps = 0b111;       // of colour, relief and horizons
inline constexpr unsigned kReadsCubes = 1u << 4;    // its own BRDF
inline constexpr unsigned kReadsLobes = 1u << 5;    // means over the cloth and its answer from afar
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
    ChartMethod{Method::kIrawan, {0.78, 0.42, 0.62}, plot::Marker::kCircle, kReadsThreads},
    ChartMethod{Method::kCloth, {0.16, 0.44, 0.70}, plot::Marker::kUp, kReadsLobes},
    ChartMethod{Method::kRepeat,
                {0.10, 0.60, 0.50},
                plot::Marker::kDown,
                reads(PackedKind::kColor) | reads(PackedKind::kRelief) | kReadsLobes},
    ChartMethod{Method::kCell, {0.85, 0.65, 0.10}, plot::Marker::kCross, kReadsMaps | kReadsLobes},
    // Of the horizons it reads the sky's share.
    ChartMethod{Method::kYarn,
                {0.80, 0.27, 0.20},
                plot::Marker::kCircle,
                reads(PackedKind::kHorizon) | kReadsLobes | kReadsThreads},
    ChartMethod{Method::kEngine, {0.55, 0.38, 0.68}, plot::Marker::kRing, kReadsMaps | kReadsLobes},
    ChartMethod{Method::kAuto, {0.10, 0.11, 0.13}, plot::Marker::kStar, kReadsMaps | kReadsLobes | kReadsThreads},
};

/// Of one that is not charted, the last's.
constexpr const ChartMethod& chart_method(Method method) {
  for (const ChartMethod& m : kChartMethods)
    if (m.method == method) return m;
  return kChartMethods.back();
}

}  // namespace weftlight::chart
