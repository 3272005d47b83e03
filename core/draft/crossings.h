#pragma once
// Painting the drawdown, and which grids may be painted: those that lead (Loom::leading) and those that follow.

#include <string>

#include "draft/factor.h"
#include "draft/selection.h"

namespace weftlight::draft {

/// A design after a stroke in the drawdown; if the loom cannot weave it, unchanged, with the reason.
struct Painted {
  Design design;
  std::string why;
};

/// Where the threading (or liftplan) rules, an end takes along every end on its shafts, as on the loom, and where
/// a block asks such ends for different things, the last end has its way; ends on no shaft stay down. Where the
/// drawdown rules, the crossings change alone and ends move to other shafts. A treadled draft stays treadled:
/// picks look for other treadles (factor.h), within loom_size.
Painted painted_cell(Design design, int end, int pick, bool up);
/// The part `s` of a block of crossings whose first cell is (a, b). `s` is in the grid.
Painted painted_crossings(Design design, const Selection& s, int a, int b, const BitMatrix& cells, Write write);

/// Shafts and treadles that painting may take: those of the loom; where that is unknown, kDefaultLimit or as
/// many as the draft has.
inline constexpr int kDefaultLimit = 32;
LoomSize loom_size(const Design& design);

/// Why a grid cannot be painted: it is locked and follows from others. Empty if it can.
std::string why_locked(const Design& design, BitGrid grid);
inline bool may_paint(const Design& design, BitGrid grid) { return why_locked(design, grid).empty(); }

/// Sets what leads. With the liftplan, the liftplan is the shed control.
Design with_leading(Design design, Leading leading);
Design with_lock(Design design, bool locked);

}  // namespace weftlight::draft
