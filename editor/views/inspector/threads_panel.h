#pragma once
// The threads that are chosen, or the whole warp or weft: their yarn, colour, thickness and spacing.

#include <string>

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// `typed`: the words that name the threads, as they are being typed.
MaybeEdit draw_threads(PanelContext& c, std::string& typed);

}  // namespace weftlight::views
