#pragma once
// The selection and the block in hand, over the grids of the draft.

#include "panels/draft_layout.h"
#include "panels/names.h"
#include "panels/panel.h"

namespace weftlight::panels {

/// A tint, and a dashed line that reads on dark and on light cells.
void draw_selection(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);
/// The block as it would lie, with a dot at its first cell.
void draw_block_in_hand(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

}  // namespace weftlight::panels
