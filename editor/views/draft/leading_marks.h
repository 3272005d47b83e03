#pragma once
// Which grids lead and which follow: those that lead have a frame in the accent colour, those that follow a small
// padlock beside them. It is closed if they are locked; a click opens or closes it.

#include "session/editing/grid.h"
#include "views/draft/draft_context.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// True if the grid follows others and is locked, so that painting it is refused.
bool is_locked(const DraftContext& c, GridId grid);

/// Frames of the grids that lead.
void draw_leading(ImDrawList* dl, const DraftContext& c, const DraftLayout& l);
/// The padlocks of the grids that follow, with their tips.
void draw_locks(ImDrawList* dl, DraftContext& c, const DraftLayout& l);

}  // namespace weftlight::views
