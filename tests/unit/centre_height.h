#pragma once
// Where a thread's centre line runs, at any place along it.

#include "cloth/centre_line.h"
#include "cloth/cloth.h"

namespace weftlight::cloth {

using draft::CellRect, draft::System;

/// Height (mm above the middle plane, signed) of a thread's centre line at distance s_mm along it (y for an end, x for
/// a pick), periodic.
inline float centre_height_mm(const Cloth& cloth, System system, int thread, float s_mm) {
  const CentreStep step = centre_step(cloth, system, s_mm);
  const int c = step.crossing;
  const CellRect window =
      system == System::kWarp ? CellRect{thread, thread + 1, c - 1, c + 3} : CellRect{c - 1, c + 3, thread, thread + 1};
  return centre_at(centre_lines(cloth, window), system, thread, step).height_mm;
}

}  // namespace weftlight::cloth
