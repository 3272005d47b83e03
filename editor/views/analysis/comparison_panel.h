#pragma once
// The differences between the open draft and the one it is compared to: a list whose rows show where they are.

#include "session/editing/difference_view.h"
#include "session/report.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::DifferenceView, session::Report;

/// Draws nothing unless two drafts are compared. `report`: null until the first is done.
void draw_comparison(const PanelContext& c, const DifferenceView& differences, const Report* report);

/// The right side of a row: "1-4, 7 (6 ends)", "4 → 8 shafts". The first value is that of the other draft.
std::string difference_text(const analysis::Difference& difference);

}  // namespace weftlight::views
