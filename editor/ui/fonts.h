#pragma once
// Inter for words, JetBrains Mono for figures, Font Awesome for icons: found through
// fontconfig; ImGui's own font stands in for what is missing.

#include "ui/names.h"
#include "ui/style.h"

namespace weftlight::ui {

/// Fills the atlas anew. `pixels` is framebuffer pixels a design unit; `ratio` of them make a window unit.
Fonts load_fonts(float pixels, float ratio);

}  // namespace weftlight::ui
