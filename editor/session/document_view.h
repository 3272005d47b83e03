#pragma once
// What belongs to one open document beside its design: how near it is seen and from where, what is selected, what is
// painted with. It is not saved, but for the camera where the weaver keeps it with the draft.

#include <memory>
#include <optional>
#include <string>

#include "draft/design.h"
#include "draft/drawdown.h"
#include "session/at_loom.h"
#include "session/names.h"
#include "session/orbit.h"
#include "session/other_draft.h"
#include "session/rejected_edit.h"
#include "session/select_state.h"
#include "session/thread_choice.h"
#include "wif/wif.h"

namespace weftlight::session {

class Document;

enum class GridId { kNone, kThreading, kTieup, kTreadling, kLiftplan, kDrawdown, kWarpColors, kWeftColors };
/// Name in the --ui-map.
const char* grid_name(GridId grid);

enum class BarPaint { kColor, kYarn };

/// What the pointer is over.
struct Hover {
  GridId grid = GridId::kNone;
  Cell cell;
};

/// A drag that paints: the value is that of the first cell, turned over.
struct Stroke {
  GridId grid = GridId::kNone;
  bool on = true;
  Cell last;
};

/// A line or rectangle on its way: drawn as a ghost until it is let go.
struct ActiveShape {
  Tool tool = Tool::kLine;
  GridId grid = GridId::kNone;
  Cell from, to;
  bool on = true;
};

/// Where numbers are typed (typing.h).
struct TypeCursor {
  GridId grid = GridId::kThreading;
  Cell at{0, 0};
  int typed = 0;       // a number that may go on; 0: none
  double until_s = 0;  // when it is taken as it is
  bool fresh = false;  // the last key completed a number, so that a comma after it says nothing new
};

struct DocumentView {
  float pitch = 0;  // pixels a thread; 0: choose so that the draft fits
  float scroll_end = 0, scroll_pick = 0, scroll_shaft = 0, scroll_treadle = 0;
  // In the pane, as it was last drawn.
  float seen_ends = 0, seen_picks = 0, seen_shafts = 0, seen_treadles = 0;
  Face face = Face::kFront;
  Orbit camera;          // of the cloth
  bool flat = false;     // a swatch straight on in the place of the drape
  bool grazing = false;  // that swatch is lit low from the side
  Orbit draped;          // the camera that comes back after it
  BarPaint bar_paint = BarPaint::kColor;
  int color = 0, yarn = 0;                        // what the colour bars are painted with
  int float_limit = 5;                            // threads that a float may cross
  bool show_floats = false;                       // those beyond it are tinted in the drawdown
  float cloth_length_cm = 0, cloth_width_cm = 0;  // finished, that yarn is counted for; 0: as the draft is
  std::shared_ptr<const OtherDraft> other;        // that it is held against; null: none
  int place = -1;                                 // of those that differ, last shown
  std::optional<RejectedEdit> rejected_edit;      // what was painted last and could not be woven
  std::shared_ptr<const ClosestWeave> nearest;    // that is looked at, its wrong crossings marked; null: none
  Stroke stroke;
  std::optional<ActiveShape> shape;
  TypeCursor cursor;
  bool mirror_ends = false, mirror_picks = false;  // what is drawn is drawn mirrored, too
  AtLoom at_loom;
  SelectState select;
  ThreadChoice chosen;           // what the Threads panel is about
  bool per_inch = false;         // of ends and picks; else per centimetre
  WifUnit warp_unit, weft_unit;  // of the opened file
};

/// Of a document that was just opened: to be fitted, its own camera. `per_inch`: what the weaver counts in where the
/// file does not say.
DocumentView view_of(const Document& document, bool per_inch);
/// After every change of the design: what is no longer there is neither selected nor in hand.
void follow_document(DocumentView& view, const Document& document);

/// The next pitch of the zoom: `steps` > 0 is nearer. Whole pixels from 2 up; 0.02 to 48.
float zoomed_pitch(float pitch, float steps);

/// A page on (1) or back (-1), a tenth of it kept in sight.
void page_ends(DocumentView& view, int pages);
void page_picks(DocumentView& view, int pages);
/// The cell into sight, with its neighbours, by as little as that takes.
void bring_into_sight(DocumentView& view, GridId grid, Cell at);
/// The thread, from 0, into the middle of the pane.
void scroll_to(DocumentView& view, System system, int thread);
/// Place `index` of those that differ from another draft, into the middle of the pane.
void show_place(DocumentView& view, int index, const CellRect& place);

}  // namespace weftlight::session
