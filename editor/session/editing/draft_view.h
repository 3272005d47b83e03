#pragma once
// How the draft is seen: zoom, scroll, and the face of the cloth.

#include "draft/drawdown.h"
#include "session/editing/grid.h"

namespace weftlight::session {

using draft::Face, draft::System;

struct DraftView {
  float pitch = 0;         // pixels per thread; 0 fits the draft
  float fitted_pitch = 0;  // with which the draft was fitted last
  bool has_grown = false;  // by shafts or treadles, and is fitted again if it was before
  float scroll_end = 0, scroll_pick = 0, scroll_shaft = 0, scroll_treadle = 0;
  // Visible in the pane when it was last drawn.
  float seen_ends = 0, seen_picks = 0, seen_shafts = 0, seen_treadles = 0;
  Face face = Face::kFront;
};

/// True until the user zooms.
bool is_fitted(const DraftView& view);
/// Fits a draft that has grown, if it was fitted before.
void fit_grown(DraftView& view);

/// The pitch after a zoom; `steps` > 0 zooms in. Whole pixels from 2 upwards; range 0.02 to 48.
float zoomed_pitch(float pitch, float steps);

/// The smallest pitch that helps: cells that can be read, or the whole draft in the pane.
float smallest_pitch(const DraftView& view, int ends, int picks);

/// Scrolls by pages, forward (1) or back (-1); a tenth of the page stays visible.
void page_ends(DraftView& view, int pages);
void page_picks(DraftView& view, int pages);
/// Scrolls as little as needed to show the cell and its neighbours.
void bring_into_sight(DraftView& view, GridId grid, Cell at);
/// Scrolls the thread, counted from 0, to the middle of the pane.
void scroll_to(DraftView& view, System system, int thread);

}  // namespace weftlight::session
