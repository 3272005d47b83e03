#pragma once
// The plan of the cloth: its size, how it stands on the loom, the reed, the warping and the yarn to buy. Every change
// is an edit of the design; what follows from it comes from core/analysis.

#include "analysis/plan_texts.h"
#include "views/common/panel.h"

namespace weftlight::views {

using analysis::Units;
using session::MaybeEdit;

/// What follows from the plan, for one revision of the design.
struct PlanState {
  uint64_t revision = 0;  // 0: not computed yet
  Units units = Units::kMetric;
  analysis::ClothMeasures measures;
  analysis::WarpingPlan warping;
  analysis::ThreadOrder warp_order;
  analysis::Selvedges selvedges;
  std::vector<analysis::SleyedReed> reeds;
  analysis::YarnReport yarn;
};

/// The units of the settings.
Units units_of(const Settings& settings);

/// The tab of the inspector.
MaybeEdit draw_plan(PanelContext& c, PlanState& state);

}  // namespace weftlight::views
