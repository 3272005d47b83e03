#pragma once
// Between which crossings of a thread a position along it lies.

#include "cloth/cloth.h"

namespace weftlight::cloth {

using draft::System;

/// Wraps a position into 0..period.
float position_in_period(float s_mm, float period_mm);

/// The crossing at or before s_mm along a thread, and the position t (0..1) between it and the next.
struct CentreStep {
  int crossing = 0;  // may be -1: before the first crossing of the period
  float t = 0;
  float h0 = 0, h1 = 0, h2 = 0;  // mm between crossings -1..0, 0..1, 1..2 around it
};
CentreStep centre_step(const Cloth& cloth, System system, float s_mm);

}  // namespace weftlight::cloth
