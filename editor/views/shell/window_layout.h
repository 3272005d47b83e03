#pragma once
// Where the panes stand in the window: the draft and the cloth side by side, the inspector at the right, the status
// line below. Of any size down to nothing; what has no room is left out.

#include <imgui.h>

#include "ui/style.h"
#include "views/common/names.h"

namespace weftlight::views {

struct PaneRect {
  ImVec2 at{0, 0}, size{0, 0};
  bool shown() const { return size.x >= 1 && size.y >= 1; }
};

struct WindowLayout {
  PaneRect draft, splitter, cloth, inspector, status;
  float room = 1;  // width that the draft and the cloth share
};

/// Width that the draft and the cloth share in a window so wide.
float shared_width(const Style& style, float width, bool inspector);
/// `split`: share of the room that the draft takes. `inspector`: it is wanted.
WindowLayout lay_out_window(const Style& style, ImVec2 at, ImVec2 size, float split, bool inspector);

}  // namespace weftlight::views
