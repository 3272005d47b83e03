#pragma once
// The tiled view: the drawdown repeated beyond its edges, and the outline of its repeat.

#include "views/draft/cell_texture.h"
#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// The repeated drawdown, dimmed, in the space around the drawdown.
void draw_tiled(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout, CellTexture& texture);
/// Outlines the first repeat, from the latest report, and draws lines where the others begin.
void draw_repeat(ImDrawList* dl, const DraftContext& c, const GridPane& drawdown);

}  // namespace weftlight::views
