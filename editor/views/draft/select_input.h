#pragma once
// Mouse input of the select tool over one grid: select a rectangle, move it, drop a block, open the menu.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// True if the mouse over this grid selects rather than paints: with the tool, with Ctrl held, or while a block is
/// active.
bool selects(const DraftContext& c, const GridPane& pane);
/// Call right after the grid's ImGui item.
void select_input(DraftContext& c, const GridPane& pane);

}  // namespace weftlight::views
