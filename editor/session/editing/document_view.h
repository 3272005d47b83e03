#pragma once
// The view state of one open document: zoom, scroll, camera, selection, active colour and tool. None of it is saved,
// except the camera when the user saves it with the draft.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "design/design.h"
#include "draft/drawdown.h"
#include "draft/factor.h"
#include "session/document/other_draft.h"
#include "session/document/rejected_edit.h"
#include "session/editing/orbit.h"
#include "session/editing/select_state.h"
#include "session/editing/thread_choice.h"
#include "session/files/names.h"
#include "session/loom/at_loom.h"
#include "wif/wif.h"

namespace weftlight::session {

class Document;

enum class GridId { kNone, kThreading, kTieup, kTreadling, kLiftplan, kDrawdown, kWarpColors, kWeftColors };
/// Name in the --ui-map.
const char* grid_name(GridId grid);

enum class BarPaint { kColor, kYarn };

/// The cell under the pointer.
struct Hover {
  GridId grid = GridId::kNone;
  Cell cell;
};

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

struct DocumentView {
  float pitch = 0;  // pixels per thread; 0 fits the draft
  float scroll_end = 0, scroll_pick = 0, scroll_shaft = 0, scroll_treadle = 0;
  // Visible in the pane when it was last drawn.
  float seen_ends = 0, seen_picks = 0, seen_shafts = 0, seen_treadles = 0;
  Face face = Face::kFront;
  Orbit camera;          // of the cloth
  bool flat = false;     // a flat swatch seen straight on instead of the drape
  bool grazing = false;  // grazing light on that swatch
  Orbit draped;          // the camera restored after the swatch
  BarPaint bar_paint = BarPaint::kColor;
  int color = 0, yarn = 0;                        // active on the colour bars
  int float_limit = 5;                            // longest float allowed, in threads
  bool show_floats = false;                       // longer floats are tinted in the drawdown
  float cloth_length_cm = 0, cloth_width_cm = 0;  // finished cloth for the yarn estimate; 0: size of the draft
  std::shared_ptr<const OtherDraft> other;        // draft compared with; null if none
  int place = -1;                                 // difference last shown, an index; -1: none yet
  std::optional<RejectedEdit> rejected_edit;      // the last edit that the loom cannot weave
  std::shared_ptr<const ClosestWeave> nearest;    // being previewed, its wrong crossings marked; null if none
  LoomSize given;                                 // shafts and treadles without those that painting added
  Stroke stroke;
  std::optional<ActiveShape> shape;
  TypeCursor cursor;
  bool mirror_ends = false, mirror_picks = false;  // symmetric drawing
  AtLoom at_loom;
  SelectState select;
  ThreadChoice chosen;           // threads shown in the Threads panel
  bool per_inch = false;         // ends and picks per inch; else per centimetre
  WifUnit warp_unit, weft_unit;  // of the opened file
};

/// The view of a document that was just opened: fitted, with the camera of the draft. `per_inch` is used if the file
/// does not tell its unit.
DocumentView view_of(const Document& document, bool per_inch);
/// Called after every change of the design: limits selection, cursor, colour and yarn to what still exists.
void follow_document(DocumentView& view, const Document& document);
/// Called after an edit of the draft. `by_painting`: shafts and treadles that painting, undo or redo brought into use
/// do not count as given.
void follow_given(LoomSize& given, const Draft& before, const Draft& now, bool by_painting);

/// The pitch after a zoom; `steps` > 0 zooms in. Whole pixels from 2 upwards; range 0.02 to 48.
float zoomed_pitch(float pitch, float steps);

/// Scrolls by pages, forward (1) or back (-1); a tenth of the page stays visible.
void page_ends(DocumentView& view, int pages);
void page_picks(DocumentView& view, int pages);
/// Scrolls as little as needed to show the cell and its neighbours.
void bring_into_sight(DocumentView& view, GridId grid, Cell at);
/// Scrolls the thread, counted from 0, to the middle of the pane.
void scroll_to(DocumentView& view, System system, int thread);
/// Scrolls difference `index` to the middle of the pane.
void show_place(DocumentView& view, int index, const CellRect& place);

}  // namespace weftlight::session
