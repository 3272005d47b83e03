#pragma once
// The row above the draft: title, active tool, symmetry, drawdown style. In a narrow pane the title is dropped first,
// then the style and the tools become drop-down lists.

#include <span>
#include <string>

#include "session/action_item.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::ActionItem, session::Tool;

/// `title`: of the draft. `tool`: the active one. `items`: the actions, for tips and shortcuts.
void draw_draft_header(PanelContext& c, const std::string& title, Tool tool, std::span<const ActionItem> items);

}  // namespace weftlight::views
