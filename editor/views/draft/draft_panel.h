#pragma once
// The draft panel: threading, tie-up, drawdown, treadling or liftplan, and the colour bars.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/cell_texture.h"
#include "views/draft/held_layout.h"
#include "views/draft/minimap.h"

namespace weftlight::views {

/// Textures and the held layout, kept between frames.
struct DraftPictures {
  CellTexture cells, tiled;
  Minimap minimap;
  HeldLayout held;
};

/// Fills the rest of the current ImGui window.
void draw_draft(PanelContext& c, DraftPictures& pictures);

}  // namespace weftlight::views
