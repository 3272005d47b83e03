#pragma once
// Yarn requirements of a cloth of a planned size: length, weight and cost of warp and weft, by yarn and colour.

#include "analysis/threads.h"
#include "session/editing/analysis_view.h"
#include "views/common/panel.h"

namespace weftlight::views {

using design::Design;
using session::AnalysisView, session::Settings;

/// The plan, from the view and the settings.
analysis::ClothPlan plan_of(const Design& design, const AnalysisView& view, const Settings& settings);

/// Its section of the inspector.
void draw_yarn_need(const PanelContext& c, const AnalysisView& view);

}  // namespace weftlight::views
