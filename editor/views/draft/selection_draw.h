#pragma once
// Draws the selection and the active block over the grids of the draft.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// A tint, and a dashed outline that is visible on dark and light cells.
void draw_selection(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);
/// The block at the place where it would be dropped, with a dot at its first cell.
void draw_active_block(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
