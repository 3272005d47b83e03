#pragma once
// Inter for text, JetBrains Mono for figures, Font Awesome for icons, found by fontconfig. ImGui's built-in font
// replaces a missing one.

#include "ui/style.h"

namespace weftlight::ui {

/// Rebuilds the atlas. `pixels`: framebuffer pixels per design unit. `ratio`: framebuffer pixels per window unit.
Fonts load_fonts(float pixels, float ratio);

}  // namespace weftlight::ui
