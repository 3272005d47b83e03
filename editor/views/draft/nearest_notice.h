#pragma once
// What was painted and the loom cannot weave: says why over the draft, and what can be done about it.

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Below the middle of a pane, while something is refused; drawn after the pane.
void draw_closest_weave_notice(PanelContext& c, ImVec2 min, ImVec2 max);

}  // namespace weftlight::views
