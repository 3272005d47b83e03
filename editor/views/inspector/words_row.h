#pragma once
// Words beside the labels' column of the inspector, below the row that they are about.

#include <imgui.h>

#include <string>

#include "views/common/panel.h"

namespace weftlight::views {

/// As much as fits in each line. tip: shown over them.
void draw_words(const PanelContext& c, const std::string& text, ImU32 color, const char* tip);

}  // namespace weftlight::views
