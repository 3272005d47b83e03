#pragma once
// What the open draft and the one that it is held against differ in: a list whose rows show where.

#include "session/report.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Nothing where the draft is held against none. `report`: null until the first is done.
void draw_comparison(PanelContext& c, const Report* report);

/// "1-4, 7 (6 ends)", "4 → 8 shafts": a row's right side. The first is the other draft's.
std::string difference_text(const analysis::Difference& difference);

}  // namespace weftlight::views
