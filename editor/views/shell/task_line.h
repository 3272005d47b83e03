#pragma once
// What runs beside the window, in the status line: what is being done, how far it is, and a button that cancels it.

#include <string>

#include "base/tasks.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// `awaits`: what happens when it is done, shown in place of its name; empty if nothing waits for it. The next item
/// follows on the same line. True if it was cancelled.
bool draw_task_line(PanelContext& c, const base::ShownTask& task, const std::string& awaits);

}  // namespace weftlight::views
