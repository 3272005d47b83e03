#pragma once
// The mouse of the select tool over one grid: draw a rectangle, move it, put a block down, ask for the menu.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// True when the mouse over this grid selects rather than paints: with the tool, with Ctrl held, or with a
/// block in hand.
bool selects(const PanelContext& c, const GridPane& pane);
/// To be called right after the grid's ImGui item.
void select_input(PanelContext& c, const GridPane& pane);

}  // namespace weftlight::views
