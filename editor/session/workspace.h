#pragma once
// What the window remembers of the view of a draft and the design does not hold: how near it is seen, what is
// selected, what the pointer is over, what is painted with.

#include <string>

#include "draft/design.h"
#include "draft/drawdown.h"
#include "session/names.h"
#include "session/select_state.h"
#include "session/thread_choice.h"
#include "wif/wif.h"

namespace weftlight::session {

enum class GridId { kNone, kThreading, kTieup, kTreadling, kLiftplan, kDrawdown, kWarpColors, kWeftColors };
/// Name in the --ui-map, also the label of its strokes.
const char* grid_name(GridId grid);

enum class DrawdownStyle { kThreads, kColor, kStructure };
enum class BarPaint { kColor, kYarn };

/// What stands beside the preview: the ray-traced picture behind a slider, or how far the two are apart.
enum class Compare { kOff, kSplit, kDifference };

/// A drag that paints: the value is that of the first cell, turned over.
struct Stroke {
  GridId grid = GridId::kNone;
  bool on = true;
  Cell last;
};

struct Workspace {
  float pitch = 0;  // pixels a thread; 0: choose so that the draft fits
  float scroll_end = 0, scroll_pick = 0, scroll_shaft = 0, scroll_treadle = 0;
  float seen_ends = 0, seen_picks = 0;  // in the pane, as it was last drawn
  bool end1_right = true;
  DrawdownStyle drawdown_style = DrawdownStyle::kThreads;
  Face face = Face::kFront;
  BarPaint bar_paint = BarPaint::kColor;
  int color = 0, yarn = 0;    // what the colour bars are painted with
  int float_limit = 5;        // threads that a float may cross
  bool show_floats = false;   // those beyond it are tinted in the drawdown
  float lobe_light_deg = 35;  // of the light in the plot of the lobes, from the normal
  bool show_rungs = false;    // false colours: which method shades which pixel
  Compare compare = Compare::kOff;
  float compare_split = 0.5f;  // of the pane's width
  const char* hint = "";       // how to use what the pointer is over, for the status line
  GridId hover_grid = GridId::kNone;
  Cell hover;
  Stroke stroke;
  SelectState select;
  ThreadChoice chosen;           // what the Threads panel is about
  std::string choice_words;      // as they are being typed
  bool per_inch = false;         // of ends and picks; else per centimetre
  WifUnit warp_unit, weft_unit;  // of the opened file
  std::string focus;             // control that the keyboard goes to next, by its name in the --ui-map
};

/// The next pitch of the zoom: `steps` > 0 is nearer. Whole pixels from 2 up; 0.02 to 48.
float zoomed_pitch(float pitch, float steps);

/// A page on (1) or back (-1), a tenth of it kept in sight.
void page_ends(Workspace& work, int pages);
void page_picks(Workspace& work, int pages);
/// The thread, from 0, into the middle of the pane.
void scroll_to(Workspace& work, System system, int thread);

}  // namespace weftlight::session
