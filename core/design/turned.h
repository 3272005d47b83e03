#pragma once
// The draft turned by a quarter, so that warp becomes weft.

#include "base/result.h"
#include "design/design.h"

namespace weftlight::design {

/// The same cloth, turned clockwise by a quarter as it is shown: treadling becomes threading, and threading, from the
/// last end to the first, becomes treadling. The tie-up changes with them, so that warp is on top where weft was seen
/// across. Yarns, colours, thickness, spacing and what the plan says of warp and weft change places. Turned twice it is
/// the cloth upside down, turned four times the same draft.
///
/// Treadles become shafts, one for each end: a liftplan, or picks with several treadles, take one for each distinct
/// lift. So take ends on several shafts a treadle each. Numbers stay if all of them fit the loom. A liftplan remains
/// one. An end on no shaft, or a pick that lifts nothing, has no treadle or shaft then.
///
/// Reed, weaves and sections kept with the draft, and the places at the loom are left out: they fit the draft before.
/// Versions stay as they were. Fails if the loom (known_size) cannot weave it, and says what helps.
base::Result<Design> turned(const Design& design);

}  // namespace weftlight::design
