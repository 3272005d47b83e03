#pragma once
// The upper part of the loom view, drawn without controls.

#include <imgui.h>

#include "session/loom/shown_step.h"
#include "ui/pixel_rect.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ShownStep;
using ui::PixelRect;

void draw_text(ImFont* font, float size, ImVec2 at, ImU32 color, const std::string& text);
float width_of(ImFont* font, float size, const std::string& text);

/// The step in words, its shafts and its colours.
void draw_step(const PanelContext& c, const ShownStep& step, PixelRect room);
/// What lies around it: of the drawdown, of the threading, or of the reed.
void draw_surroundings(const PanelContext& c, const ShownStep& step, PixelRect room);

}  // namespace weftlight::views
