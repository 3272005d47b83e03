#pragma once
// The row above the draft: its title, the tool in hand and what it is mirrored about, how the drawdown looks. In a
// narrow pane the title goes first, then look and tool become drop-down lists.

#include <span>
#include <string>

#include "session/action_item.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// `name`: of the file, where the draft has no title. `items`: whose keys the tips tell.
void draw_draft_header(PanelContext& c, const std::string& name, std::span<const ActionItem> items);

}  // namespace weftlight::views
