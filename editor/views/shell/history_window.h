#pragma once
// The steps of undo by their names, in a window of their own: a click goes there, and nothing of what lies ahead is
// lost until something else is done.

#include "session/document.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Which step was brought into sight last.
struct HistoryWindow {
  size_t steps = 0, position = 0;
};

/// While Settings::show_history.
void draw_history(PanelContext& c, const Document& document, HistoryWindow& window);

}  // namespace weftlight::views
