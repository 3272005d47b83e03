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

/// How far washing has moved a thread sideways at a crossing; both indices wrap.
float aside_at(const Cloth& cloth, System system, int thread, int crossing);
/// The step of a thread at s_mm, which lies in `even` among the threads that it crosses as the draft spaces them: these
/// may be moved sideways.
CentreStep moved_step(const Cloth& cloth, System system, int thread, float s_mm, const CentreStep& even);
inline CentreStep centre_step(const Cloth& cloth, System system, int thread, float s_mm) {
  return moved_step(cloth, system, thread, s_mm, centre_step(cloth, system, s_mm));
}

}  // namespace weftlight::cloth
