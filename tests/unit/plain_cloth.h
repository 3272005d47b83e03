#pragma once
// A plain weave of a given size and sett, for tests of plans.

#include "design/design.h"

namespace weftlight {

inline design::Design plain_cloth(int ends, int picks, float end_mm = 1, float pick_mm = 1) {
  design::Design d;
  d.draft = draft::blank_draft(ends, picks, 2, 2);
  for (int e = 0; e < ends; ++e) d.draft.threading.set(e, e % 2, true);
  for (int p = 0; p < picks; ++p) d.draft.treadling.set(p, p % 2, true);
  d.draft.tieup.set(0, 0, true);
  d.draft.tieup.set(1, 1, true);
  d.draft.warp.spacing_mm.assign(static_cast<size_t>(ends), end_mm);
  d.draft.weft.spacing_mm.assign(static_cast<size_t>(picks), pick_mm);
  return d;
}

/// Without take-up, shrinkage, waste and spare.
inline design::ClothPlan bare_plan() {
  design::ClothPlan plan;
  plan.loom_waste_mm = plan.spare = 0;
  plan.warp_take_up = plan.weft_take_up = plan.warp_shrinkage = plan.weft_shrinkage = 0;
  return plan;
}

}  // namespace weftlight
