#pragma once
// Where the grids of a draft lie in their pane: threading above the drawdown or, as the weaver likes, below it, tie-up
// in the corner, treadling or liftplan at the side, colour bars along the outer edges.

#include <vector>

#include "ui/axis.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

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
  GridPane warp_labels, weft_labels;                              // the numbers of ends and picks, beside their bars
  ImVec2 min, max;                                                // of the whole pane
  GridPane beyond;  // the drawdown's room, where it goes on over its edges
  float pitch = 0;  // pixels a thread
  bool threading_below = false;
  bool scroll_ends = false, scroll_picks = false, scroll_shafts = false, scroll_treadles = false;  // not all in sight

  /// All grids; the tie-up is left out of a draft driven by its liftplan.
  std::vector<const GridPane*> panes() const;
};

/// Width of a pane, `least` to `most`, that a draft fills best when its pitch is chosen to fit.
float fitting_width(const Draft& draft, const Style& style, float least, float most, float height);

/// With a pitch that fits where the view has none, and its scroll brought into range.
DraftLayout lay_out_draft(const Draft& draft, const DocumentView& view, const Settings& settings, const Style& style,
                          ImVec2 min, ImVec2 max);
/// The view becomes what the layout shows of it.
void settle(DocumentView& view, const DraftLayout& layout);
/// It is that already.
bool is_settled(const DocumentView& view, const DraftLayout& layout);

/// The grid as the --ui-map tells it.
UiGrid map_of(const GridPane& pane);

}  // namespace weftlight::views
