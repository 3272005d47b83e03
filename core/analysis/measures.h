#pragma once
// The measures of a cloth on its way from the loom to the finished cloth, from the design and its plan.
//
//   warp:  length of cloth / (1 - shrinkage) = woven on the loom;  woven (1 + take-up) = warp that it takes
//   weft:  width of cloth / (1 - shrinkage) = woven on the loom;  woven (1 + take-up) = width in the reed = a pick
//
// A cloth without a planned width has the ends of the draft, and is as wide as they are at that sett; so are length and
// picks. Otherwise the draft repeats, or is cut off.

#include <cstdint>
#include <optional>

#include "design/design.h"

namespace weftlight::analysis {

using design::Design;
using draft::System;

struct ClothMeasures {
  int64_t ends = 0, picks = 0;    // of the cloth; picks of all pieces
  int64_t floating = 0;           // floating selvedges, more ends beside those
  int64_t dents = 0;              // that the ends fill, with the floating selvedges; 0 without a reed
  double reed_width_mm = 0;       // of the ends in the reed, without floating selvedges; a pick is as long
  double woven_width_mm = 0;      // of the cloth on the loom, drawn in
  double width_mm = 0;            // of the finished cloth
  double warp_length_mm = 0;      // as wound, with fringes and loom waste
  double woven_length_mm = 0;     // of a piece, on the loom
  double length_mm = 0;           // of a piece, finished
  double warp_woven_mm = 0;       // of the warp's length, what is in the cloth
  double wanted_ends_per_cm = 0;  // on the loom, before a reed decides
  double loom_ends_per_cm = 0, loom_picks_per_cm = 0;
  double cloth_ends_per_cm = 0, cloth_picks_per_cm = 0;  // finished
  double draft_ends_per_cm = 0, draft_picks_per_cm = 0;  // as the draft is drawn

  int64_t threads(System system) const { return system == System::kWarp ? ends : picks; }
};
/// Numbers of the plan out of range count as their limit. All 0 for a draft of no width or no length. At most
/// kMaxClothThreads ends and picks.
ClothMeasures cloth_measures(const Design& design);
inline constexpr int64_t kMaxClothThreads = int64_t{1} << 40;

/// The threads of a system as the cloth is laid out with them, each of its own thickness, otherwise its yarn's: their
/// means. Of all yarns, or of one.
struct MeanThread {
  int threads = 0;
  double diameter_mm = 0, tex = 0;
  double spun_mm = 0;  // diameter before it was woven and washed, by its count
};
MeanThread mean_thread(const Design& design, System system, std::optional<int> yarn = {});

}  // namespace weftlight::analysis
