#pragma once
// Facts about the weave: floats, repeat, heddles. A click on a float shows it in the draft.

#include "session/editing/analysis_view.h"
#include "session/report.h"
#include "views/common/panel.h"

namespace weftlight::views {

using session::AnalysisView, session::Report;

/// `report`: null until the first is done.
void draw_report(const PanelContext& c, const AnalysisView& view, const Report* report);

/// "End 12 over picks 3-9: 7", or "under" for a float on the back.
std::string float_text(const analysis::Float& f, int threads);

}  // namespace weftlight::views
