#pragma once
// Mouse input of the line, rectangle and fill tools, the preview of a shape, and the axes of the symmetric pen.

#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

using session::Tool;

/// True if the mouse over this grid draws a shape or fills, rather than paints.
bool draws_shapes(const DraftContext& c, const GridPane& pane);
/// Call right after the grid's ImGui item.
void draw_with_tool(DraftContext& c, const GridPane& pane);
/// How to use the tool, for the status bar; translated.
const char* tool_hint(Tool tool);

/// The preview of the shape, with its mirror images.
void draw_shape(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);
/// The mirror axes, and the mirror images of the cell under the pointer.
void draw_mirrors(ImDrawList* dl, const DraftContext& c, const DraftLayout& layout);

/// The cursor for typed numbers, with the digits so far.
void draw_type_cursor(ImDrawList* dl, DraftContext& c, const DraftLayout& layout);

}  // namespace weftlight::views
