#pragma once
// The drawdown beyond its edges, as cloth goes on, and its repeat outlined.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/cell_texture.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// Dimmed, wherever the pane has room that the drawdown leaves.
void draw_tiled(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout, CellTexture& texture);
/// The first repeat that the last report found, and lines where the others begin.
void draw_repeat(ImDrawList* dl, const PanelContext& c, const GridPane& drawdown);

}  // namespace weftlight::views
