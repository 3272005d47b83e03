#pragma once
// The plan of the cloth: its size, how it stands on the loom, the reed, the warping and the yarn to buy. Every change
// is an edit of the design; what follows from it comes from core/analysis.

#include "views/analysis/plan_state.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::MaybeEdit;

/// The tab of the inspector.
MaybeEdit draw_plan(PanelContext& c, PlanState& state);

}  // namespace weftlight::views
