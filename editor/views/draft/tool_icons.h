#pragma once
// Icons of the drawing tools, drawn as vectors: sharp at any size, and they need no font.

#include <imgui.h>

#include "views/common/panel.h"

namespace weftlight::views {

using session::Tool;

/// Centred on `middle`, about `size` pixels wide.
void draw_tool_icon(ImDrawList* dl, Tool tool, ImVec2 middle, float size, ImU32 color);
/// Two triangles mirrored about an axis; `across`: about a vertical one.
void draw_mirror_icon(ImDrawList* dl, bool across, ImVec2 middle, float size, ImU32 color);

}  // namespace weftlight::views
