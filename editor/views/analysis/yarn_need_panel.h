#pragma once
// The yarn that a cloth needs: warp and weft by yarn and colour, with length, weight and cost, for a cloth of a size
// that is planned.

#include "analysis/threads.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// What is planned, from the view and the settings.
analysis::ClothPlan plan_of(const Design& design, const DocumentView& view, const Settings& settings);

/// Its section of the inspector.
void draw_yarn_need(PanelContext& c);

}  // namespace weftlight::views
