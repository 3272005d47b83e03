#pragma once
// What every panel gets and gives: it draws one view of the design and says what the weaver asked for, as an edit that
// it returns or among `wanted`. Panels never touch files, and change neither the design nor its view themselves.

#include <cstdint>

#include "draft/design.h"
#include "draft/drawdown.h"
#include "session/document_view.h"
#include "session/draper.h"
#include "session/edit.h"
#include "session/intent.h"
#include "session/report.h"
#include "ui/context.h"
#include "views/common/names.h"

namespace weftlight::views {

/// What the panels of one frame tell each other and the window; begun anew with every frame.
struct FrameNotes {
  Hover hover;
  const char* hint = "";        // how to use what the pointer is over, for the status line
  bool crosshair = false;       // the pointer draws a rectangle here
  bool selection_menu = false;  // a right click: the menu opens in this frame
  bool again = false;           // something moves on by itself: another frame
};

struct PanelContext : Context {
  const Design& design;
  const BitMatrix& cells;  // drawdown of the design, front face
  uint64_t revision;       // grows whenever the design changes
  const DocumentView& view;
  const Settings& settings;
  FrameNotes& frame;
  Intents& wanted;
  const Report* report = nullptr;  // the last one made, of this design or one before; null: none
  DrapeState drape{};              // of the cloth's own drape
};

/// A colour of the design as ImGui packs it.
ImU32 to_u32(Rgb c, float alpha = 1.0f);

}  // namespace weftlight::views
