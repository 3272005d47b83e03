#pragma once
// A small picture of the cloth on the loom: the last picks as they were woven, the newest at the top, and the bare warp
// above it.

#include <string>

#include "session/loom/at_loom.h"

namespace weftlight::session {

/// A PNG of at most 512 x 432 pixels: up to 128 ends, end 1 at the right, and up to 96 picks; tabby picks are left out,
/// since the draft does not say their colour. `cells`: of the design's drawdown. Empty if there is no memory for it, or
/// no thread.
std::string cloth_so_far_png(const AtLoom& at, const Design& design, const draft::BitMatrix& cells);

}  // namespace weftlight::session
