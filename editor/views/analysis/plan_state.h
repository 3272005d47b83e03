#pragma once
// What the panel of the plan shows of a design.

#include <cstdint>
#include <vector>

#include "analysis/plan_texts.h"

namespace weftlight::views {

using analysis::Units;

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

}  // namespace weftlight::views
