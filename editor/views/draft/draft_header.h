#pragma once
// The row above the draft: its title, the tool in hand, how the drawdown looks. In a narrow pane the title goes first,
// then tool and look become drop-down lists.

#include <string>

#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// `name`: of the file, where the draft has no title.
void draw_draft_header(PanelContext& c, const std::string& name);

}  // namespace weftlight::views
