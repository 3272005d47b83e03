#pragma once
// What draws on the grids, and with what: the active colour and yarn, symmetry, the stroke or shape in progress, and
// the cursor of number entry. The active tool is in SelectState.

#include <memory>
#include <optional>
#include <vector>

#include "design/design.h"
#include "draft/factor.h"
#include "session/editing/grid.h"
#include "session/editing/select_state.h"

namespace weftlight::session {

using design::Design;
using draft::Draft, draft::LoomSize;

enum class BarPaint { kColor, kYarn };

/// A drag that paints. `on` is the inverted value of the first cell.
struct Stroke {
  GridId grid = GridId::kNone;
  bool on = true;
  Cell last;
  // In the drawdown each step repaints all crossings of the stroke on the design before it, so that shafts and treadles
  // needed only by intermediate states are not left behind.
  std::shared_ptr<const Design> base, reached;  // the design before the stroke, and after it
  std::vector<Cell> cells;                      // including mirror images
};

/// A line or rectangle being dragged: drawn as an outline until the button is released.
struct ActiveShape {
  Tool tool = Tool::kLine;
  GridId grid = GridId::kNone;
  Cell from, to;
  bool on = true;
};

/// The cell cursor of number entry (typing.h).
struct TypeCursor {
  GridId grid = GridId::kThreading;
  Cell at{0, 0};
  int typed = 0;       // an unfinished number; 0 if none
  double until_s = 0;  // time at which it is accepted as it is
  bool fresh = false;  // the last key completed a number, so that a comma after it is ignored
};

struct DrawingState {
  BarPaint bar_paint = BarPaint::kColor;
  int color = 0, yarn = 0;                         // active on the colour bars
  bool mirror_ends = false, mirror_picks = false;  // symmetric drawing
  Stroke stroke;
  std::optional<ActiveShape> shape;
  TypeCursor cursor;
  LoomSize given;  // shafts and treadles without those that painting added
};

/// Called after an edit of the draft. `by_painting`: shafts and treadles that painting, undo or redo brought into use
/// do not count as given.
void follow_given(LoomSize& given, const Draft& before, const Draft& now, bool by_painting);

}  // namespace weftlight::session
