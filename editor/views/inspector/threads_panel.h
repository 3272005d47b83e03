#pragma once
// The threads that are chosen, or the whole warp or weft: their yarn, colour, thickness and spacing.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

MaybeEdit draw_threads(PanelContext& c);

}  // namespace weftlight::views
