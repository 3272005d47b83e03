#pragma once
// A drag beyond the edge of its grid scrolls the grid, faster with the distance of the pointer.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using ui::Axis;

/// During any drag in a grid. True if it scrolled; it then requests another frame.
bool scroll_with_drag(DraftContext& c, const DraftLayout& layout);

/// The scroll of an axis after `seconds` with the pointer at `pixel`; unchanged while the pointer is inside.
float dragged_scroll(const Axis& axis, float pixel, float seconds);

}  // namespace weftlight::views
