#pragma once
// Painting the drawdown.

#include "base/result.h"
#include "design/design.h"
#include "draft/selection.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Selection, draft::Write;

/// Where the threading (or liftplan) rules, an end takes along every end on its shafts, as on the loom, and where
/// a block asks such ends for different things, the last end has its way; ends on no shaft stay down. Where the
/// drawdown rules, the crossings change alone and ends move to other shafts. A treadled draft stays treadled:
/// picks look for other treadles (factor.h), within loom_size. The error says why the loom cannot weave it.
base::Result<Design> painted_cell(Design design, int end, int pick, bool up);
/// The same; if the loom cannot weave it, the design is unchanged.
Design with_drawdown_cell(Design design, int end, int pick, bool up);
/// The part `s` of a block of crossings whose first cell is (a, b). `s` is in the grid.
base::Result<Design> painted_crossings(Design design, const Selection& s, int a, int b, const BitMatrix& cells,
                                       Write write);

}  // namespace weftlight::design
