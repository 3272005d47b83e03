#pragma once
// Text beside the label column of the inspector, below the row that it is about.

#include <imgui.h>

#include <string>

#include "views/common/panel.h"

namespace weftlight::views {

/// Wraps the text. `tip`: its tooltip.
void draw_words(const PanelContext& c, const std::string& text, ImU32 color, const char* tip);

}  // namespace weftlight::views
