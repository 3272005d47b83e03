#pragma once
// The colours of the draft: swatches, the active colour, and what the colour bars are painted with.

#include "session/editing/drawing_state.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::DrawingState, session::MaybeEdit;

MaybeEdit draw_palette(const PanelContext& c, const DrawingState& drawing);

}  // namespace weftlight::views
