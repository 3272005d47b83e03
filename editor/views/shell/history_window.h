#pragma once
// The history window: the undo steps by name. A click goes to a step; later steps stay until the next edit.

#include "session/document/document.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::Document;

struct HistoryWindow {
  size_t steps = 0, position = 0;  // when it was scrolled last
  bool focused = false;            // has the keyboard
};

/// Draws the window while Settings::show_history is set.
void draw_history(PanelContext& c, const Document& document, HistoryWindow& window);

}  // namespace weftlight::views
