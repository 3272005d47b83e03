#pragma once
// Painting the drawdown, and what of a draft may be painted at all: what rules (Loom::leading) and what follows.

#include <string>

#include "draft/factor.h"
#include "draft/selection.h"

namespace weftlight::draft {

/// A design after a stroke in the drawdown; where the loom cannot weave it, as it was, and why.
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

/// Shafts and treadles that painting may take: those of the loom; where it is not said, kUnasked or as many as
/// the draft has.
inline constexpr int kUnasked = 32;
LoomSize loom_size(const Design& design);

/// Why a grid cannot be painted: it is locked and follows from others. Empty: it can.
std::string why_locked(const Design& design, BitGrid grid);
inline bool may_paint(const Design& design, BitGrid grid) { return why_locked(design, grid).empty(); }

/// What rules from now on. The liftplan: the draft is driven by its liftplan.
Design with_leading(Design design, Leading leading);
Design with_lock(Design design, bool locked);

}  // namespace weftlight::draft
