#pragma once
// The draft: threading, tie-up, drawdown, treadling or liftplan and the colour bars, painted by dragging.

#include "views/common/names.h"
#include "views/common/panel.h"
#include "views/draft/cell_texture.h"
#include "views/draft/held_layout.h"
#include "views/draft/minimap.h"

namespace weftlight::views {

/// What is kept of the draft between frames.
struct DraftPictures {
  CellTexture cells, beyond;
  Minimap minimap;
  HeldLayout held;
};

/// Fills what is left of the current ImGui window.
void draw_draft(PanelContext& c, DraftPictures& pictures);

}  // namespace weftlight::views
