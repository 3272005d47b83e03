#pragma once
// Centre lines of the threads as smooth periodic curves over and under each other, worked
// out once for a window of crossings and then read in constant time (maps, tubes of the reference).

#include <span>
#include <vector>

#include "cloth/cloth.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// A float's height depends on its ends no further away than this many threads: beyond, the bound of
/// the weave's tightness is reached. It bounds what a changed cell can touch.
inline constexpr int kFloatReach = 4;

struct CentrePoint {
  float height_mm = 0;
  float slope = 0;  // d height / d s
  float bend = 0;   // d slope / d s, 1/mm
};

/// Heights at the crossings [end0, end1) x [pick0, pick1). Indices may run outside 0..count (they wrap).
struct CentreLines {
  CellRect window;
  std::vector<float> warp_mm, weft_mm;  // row-major, one row a pick, window's ends a row
  int ends() const { return window.end1 - window.end0; }
  float at(System system, int end, int pick) const {
    const auto& z = system == System::kWarp ? warp_mm : weft_mm;
    return z[static_cast<size_t>(pick - window.pick0) * static_cast<size_t>(ends()) +
             static_cast<size_t>(end - window.end0)];
  }
};

/// Height of the crossings of `window` (8 bytes a crossing). Cloth without threads: empty. Of several layers: of one
/// of them (layers.h).
CentreLines centre_lines(const Cloth& cloth, const CellRect& window);
/// The whole period, with the margin that centre_at needs at its borders.
CentreLines centre_lines(const Cloth& cloth);

/// The same place in 0..period.
float position_in_period(float s_mm, float period_mm);

/// Crossing at or before s_mm along a thread of `system`, and where between it and the next s is (0..1).
struct CentreStep {
  int crossing = 0;  // may be -1: before the first crossing of the period
  float t = 0;
  float h0 = 0, h1 = 0, h2 = 0;  // mm between crossings -1..0, 0..1, 1..2 around it
};
CentreStep centre_step(const Cloth& cloth, System system, float s_mm);

/// Slope of a centre line at a crossing: from the heights at the crossings before and after, so far apart.
float centre_slope(float before_mm, float after_mm, float distance_mm);

/// Curve through four heights around a step: C1; it may rise above its crossings inside a float.
CentrePoint centre_between(float z0, float z1, float z2, float z3, const CentreStep& step);

/// Centre line of a thread; the step's crossing -1..+2 must be inside the window.
CentrePoint centre_at(const CentreLines& lines, System system, int thread, const CentreStep& step);

}  // namespace weftlight::cloth
