#pragma once
// A pane of the window as a window of ImGui that the user cannot move.

#include <imgui.h>

#include "views/shell/window_layout.h"

namespace weftlight::app {

using views::PaneRect;

inline constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                           ImGuiWindowFlags_NoNavFocus;

/// Follow it by ImGui::End(), also if it returns false because nothing of it is visible.
bool begin_fixed(const char* name, const PaneRect& pane, ImVec2 padding, ImGuiWindowFlags flags);

}  // namespace weftlight::app
