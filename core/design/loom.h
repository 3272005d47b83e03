#pragma once
// What the loom allows: how many shafts and treadles painting may take, and which grids may be painted: those that lead
// (Loom::leading), or also those that follow.

#include "base/result.h"
#include "design/design.h"
#include "draft/factor.h"
#include "draft/selection.h"

namespace weftlight::design {

using draft::BitGrid, draft::LoomSize;

/// Shafts and treadles that painting may take: those of the loom; where that is unknown, kDefaultLimit or as
/// many as the draft has.
inline constexpr int kDefaultLimit = 32;
LoomSize loom_size(const Design& design);

/// Shafts and treadles that another draft in its place may take: those of the loom, or of its own draft if that has
/// more. A loom that is unknown has all.
LoomSize known_size(const Design& design);

/// Whether this draft may take the place of the design's, or the error: it asks more than known_size.
base::Result<void> weaves_on_loom(const Design& design, const draft::Draft& next);

/// True if other grids follow this one; false if it follows.
bool leads(const Design& design, BitGrid grid);
/// Whether a grid may be painted, or the error: it is locked and follows from others.
base::Result<void> may_paint(const Design& design, BitGrid grid);

/// `loom` with the place of another: how far it is threaded, sleyed and woven. The place is kept with the draft, but no
/// edit is about it (history.h); numbers beyond the draft stand for its end.
Loom with_place_of(const Loom& place, Loom loom);

}  // namespace weftlight::design
