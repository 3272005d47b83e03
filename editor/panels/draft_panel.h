#pragma once
// The draft: threading, tie-up, drawdown, treadling or liftplan and the colour bars, painted by dragging.

#include "panels/cell_texture.h"
#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

/// Fills what is left of the current ImGui window.
MaybeEdit draw_draft(PanelContext& c, CellTexture& texture);

}  // namespace weftlight::panels
