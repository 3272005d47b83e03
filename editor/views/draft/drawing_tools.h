#pragma once
// Line, rectangle and fill under the mouse, their ghost before they are let go, and the axes of the symmetric pen.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// True when the mouse over this grid draws a shape or fills, and does not paint.
bool draws_shapes(const PanelContext& c, const GridPane& pane);
/// To be called right after the grid's ImGui item.
void draw_with_tool(PanelContext& c, const GridPane& pane);
/// How to use the tool there, for the status line.
const char* tool_hint(Tool tool);

/// The shape as it would lie, with its images.
void draw_shape(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);
/// Where the pen is mirrored, and the images of the cell under the pointer.
void draw_mirrors(ImDrawList* dl, const PanelContext& c, const DraftLayout& layout);

/// Where numbers are typed, with what was typed so far.
void draw_type_cursor(ImDrawList* dl, PanelContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
