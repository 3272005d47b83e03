#pragma once
// A drag that leaves its grid takes the grid along: what lies beyond the edge comes into sight, the faster the further
// the pointer is out.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// While something is painted, drawn, selected, moved or chosen. True where it scrolled: it asks for another frame.
bool scroll_with_drag(PanelContext& c, const DraftLayout& layout);

/// Where an axis is scrolled to after `seconds` of a pointer at `pixel`; as it is while that is inside.
float dragged_scroll(const Axis& axis, float pixel, float seconds);

}  // namespace weftlight::views
