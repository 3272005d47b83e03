#pragma once
// Centre lines of the threads: smooth periodic curves over and under each other. They are computed once for a window
// of crossings and then read in constant time (by the maps and the ray-traced tubes).

#include <span>
#include <vector>

#include "cloth/centre_step.h"
#include "cloth/cloth.h"
#include "cloth/thread_texture.h"

namespace weftlight::cloth {

using draft::CellRect, draft::System;

/// A float's height depends on its ends up to this many threads away. This limits what a changed cell can affect.
inline constexpr int kFloatReach = thread_formulas::kFloatCells;

struct CentrePoint {
  float height_mm = 0;
  float slope = 0;  // d height / d s
  float bend = 0;   // d slope / d s, 1/mm
};

/// Heights at the crossings [end0, end1) x [pick0, pick1). Indices outside 0..count wrap.
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

/// Heights of the crossings of `window` (8 bytes a crossing); empty for a cloth without threads. The cloth has one
/// layer (layers.h, one_layer()).
CentreLines centre_lines(const Cloth& cloth, const CellRect& window);
/// The whole period with the margin that centre_at() needs.
CentreLines centre_lines(const Cloth& cloth);

using thread_formulas::centre_slope;

/// C1 curve through four heights around a step; inside a float it may rise above the crossings.
CentrePoint centre_between(float z0, float z1, float z2, float z3, const CentreStep& step);

/// Centre line of a thread. The window must hold the step's crossings -1..+2.
CentrePoint centre_at(const CentreLines& lines, System system, int thread, const CentreStep& step);

}  // namespace weftlight::cloth
