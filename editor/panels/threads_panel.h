#pragma once
// The threads that are chosen, or the whole warp or weft: their yarn, colour, thickness and spacing.

#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

MaybeEdit draw_threads(PanelContext& c);

/// An edit of threads as undo tells it: "Thickness of 3 ends".
std::string thread_label(const std::string& what, System system, size_t count);

}  // namespace weftlight::panels
