#pragma once
// The layout of a draft in its pane: threading above or below the drawdown, tie-up in the corner, treadling or liftplan
// at the side, colour bars along the outer edges.

#include <vector>

#include "ui/axis.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::Draft;
using session::Cell, session::DraftView, session::GridId, session::Settings;
using ui::Axis, ui::Style, ui::UiGrid;

/// A grid on the screen; x carries Cell::a, y carries Cell::b.
struct GridPane {
  GridId id = GridId::kNone;
  Axis x, y;

  ImVec2 min() const { return {x.start, y.start}; }
  ImVec2 max() const { return {x.start + x.length, y.start + y.length}; }
  Cell at(ImVec2 p) const { return x.at(p.x) < 0 || y.at(p.y) < 0 ? Cell{} : Cell{x.at(p.x), y.at(p.y)}; }
  Cell nearest(ImVec2 p) const { return {x.nearest(p.x), y.nearest(p.y)}; }
};

struct DraftLayout {
  GridPane warp_bar, threading, tieup, drawdown, lift, weft_bar;  // lift: treadling or liftplan
  GridPane warp_labels, weft_labels;                              // thread numbers beside the colour bars
  ImVec2 min, max;                                                // of the whole pane
  GridPane tiled_drawdown;  // the space in which the tiled view repeats the drawdown
  float pitch = 0;          // pixels a thread
  bool threading_below = false;
  float ruler_high = 0;  // of the ruler between the drawdown and the scroll bar of its ends; 0: none
  bool scroll_ends = false, scroll_picks = false, scroll_shafts = false, scroll_treadles = false;  // not all visible

  /// All grids. A draft with a liftplan has no tie-up.
  std::vector<const GridPane*> panes() const;
};

/// The width, between `min_width` and `max_width`, of the pane that fits the draft best.
float fitting_width(const Draft& draft, const Settings& settings, const Style& style, float min_width, float max_width,
                    float height);

/// Chooses a fitting pitch if the view has none, and clamps its scroll.
DraftLayout lay_out_draft(const Draft& draft, const DraftView& view, const Settings& settings, const Style& style,
                          ImVec2 min, ImVec2 max);
/// Stores pitch, scroll and visible ranges of the layout in the view.
void settle(DraftView& view, const DraftLayout& layout);
/// True if the view has those values already.
bool is_settled(const DraftView& view, const DraftLayout& layout);

/// The grid for the --ui-map.
UiGrid map_of(const GridPane& pane);

}  // namespace weftlight::views
