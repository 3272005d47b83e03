#pragma once
// The draft: threading, tie-up, drawdown, treadling or liftplan and the colour bars, painted by dragging.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/cell_texture.h"

namespace weftlight::views {

/// Fills what is left of the current ImGui window.
void draw_draft(PanelContext& c, CellTexture& texture);

}  // namespace weftlight::views
