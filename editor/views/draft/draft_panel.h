#pragma once
// The draft panel: threading, tie-up, drawdown, treadling or liftplan, and the colour bars.

#include "views/draft/cell_texture.h"
#include "views/draft/draft_context.h"
#include "views/draft/held_layout.h"
#include "views/draft/minimap.h"

namespace weftlight::views {

using session::DocumentView, session::Report;

/// Textures and the held layout, kept between frames.
struct DraftPictures {
  CellTexture cells, tiled;
  Minimap minimap;
  HeldLayout held;
};

/// Fills the rest of the current ImGui window. `report`: the latest one, perhaps of an earlier design; null if there is
/// none.
void draw_draft(const PanelContext& c, const DocumentView& view, const Report* report, DraftPictures& pictures);

}  // namespace weftlight::views
