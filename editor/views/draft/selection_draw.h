#pragma once
// The selection and the block in hand, over the grids of the draft.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// A tint, and a dashed line that reads on dark and on light cells.
void draw_selection(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);
/// The block as it would lie, with a dot at its first cell.
void draw_block_in_hand(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
