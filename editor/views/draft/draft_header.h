#pragma once
// The row above the draft: title, active tool, symmetry, drawdown style. In a narrow pane the title is dropped first,
// then the style and the tools become drop-down lists.

#include <span>
#include <string>

#include "session/action_item.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ActionItem, session::Tool;

/// `tool`: the active one. `name`: of the file, shown if the draft has no title. `items`: the actions, for tips and
/// shortcuts.
void draw_draft_header(PanelContext& c, const std::string& name, Tool tool, std::span<const ActionItem> items);

}  // namespace weftlight::views
