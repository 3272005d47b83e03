#pragma once
// The pictures of the drawing tools, as lines of the window's own: sharp at any size, with no font needed.

#include <imgui.h>

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// About `middle`, some `size` pixels wide.
void draw_tool_icon(ImDrawList* dl, Tool tool, ImVec2 middle, float size, ImU32 color);
/// Two triangles that face each other across an axis; `across`: an upright one.
void draw_mirror_icon(ImDrawList* dl, bool across, ImVec2 middle, float size, ImU32 color);

}  // namespace weftlight::views
