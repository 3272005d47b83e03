#pragma once
// The layout of the window: draft and cloth side by side, or the draft alone; the inspector at the right, the status
// bar below. On a tablet held upright the draft has the upper part, cloth and inspector the lower. Works for any window
// size: a narrow one has the inspector in the place of the cloth, and the narrowest leave it out.

#include <imgui.h>

#include "ui/style.h"

namespace weftlight::views {

using ui::Style;

struct PaneRect {
  ImVec2 at{0, 0}, size{0, 0};
  bool shown() const { return size.x >= 1 && size.y >= 1; }
};

struct WindowLayout {
  PaneRect draft, splitter, cloth, inspector, status;
  float room = 1;        // total width of draft and cloth, or their height
  bool stacked = false;  // one above the other
};

/// Panes that the user wants beside the draft.
struct WantedPanes {
  bool cloth = true, inspector = true;
};

/// Whether a window of that size has the draft above the cloth.
bool is_stacked(const Style& style, ImVec2 size);
/// Total width of draft and cloth, side by side, in a window of that width.
float shared_width(const Style& style, float width, bool inspector);
/// `split`: fraction of that width for the draft, beside the cloth; or of the height, above it.
WindowLayout lay_out_window(const Style& style, ImVec2 at, ImVec2 size, float split, WantedPanes wanted);

}  // namespace weftlight::views
