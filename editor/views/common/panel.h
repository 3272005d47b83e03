#pragma once
// The input and output of a panel. A panel draws one view of the design and returns an edit, or adds requests to
// `wanted`. It takes the part of the document's view that it draws, never touches files, and changes neither the design
// nor its view itself.

#include <cstdint>

#include "analysis/units.h"
#include "design/design.h"
#include "draft/drawdown.h"
#include "session/document/edit.h"
#include "session/editing/grid.h"
#include "session/editing/intent.h"
#include "ui/context.h"

namespace weftlight::views {

using design::Design;
using draft::BitMatrix, draft::Rgb;
using session::Hover, session::Intents, session::Settings;
using ui::Context;

/// What the panels of one frame tell each other and the window. Reset for every frame.
struct FrameNotes {
  double now_s = 0;  // when the frame began, by the window's clock; ImGui's stands still between frames
  Hover hover;
  const char* hint = "";        // how to use what is under the pointer, for the status bar; translated
  bool crosshair = false;       // the cursor is a crosshair
  bool selection_menu = false;  // open the context menu in this frame
  bool popup_closed = false;    // Escape closed a list or menu in this frame
  bool again = false;           // draw another frame, because something moves by itself
};

struct PanelContext : Context {
  const Design& design;
  const BitMatrix& cells;  // drawdown of the front face
  uint64_t revision;       // increases with every change of the design
  const Settings& settings;
  FrameNotes& frame;
  Intents& wanted;
};

/// The same with the part of the document's view that the panel draws.
template <class View>
struct ViewContext : PanelContext {
  const View& view;
};

/// The units of the settings.
analysis::Units units_of(const Settings& settings);

/// A colour of the design as ImGui packs it.
ImU32 to_u32(Rgb c, float alpha = 1.0f);

}  // namespace weftlight::views
