#pragma once
// What the draft is as a weave and on a loom: layers, fewest shafts and treadles, sett, yarn.

#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "draft/factor.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Derived from one revision of the design; found anew when that changes and the section is open.
struct AnalysisState {
  uint64_t revision = 0;  // 0: nothing was found yet
  std::vector<analysis::Layer> layers;
  analysis::LoomUse loom;
  LoomSize fewest;
  analysis::Interlacing interlacings;
  analysis::YarnReport yarn;
};

/// Drafts of up to kLiveCrossings are analysed at every edit, larger ones when asked.
inline constexpr int64_t kLiveCrossings = int64_t{1} << 22;

void draw_analysis(PanelContext& c, AnalysisState& state);

}  // namespace weftlight::views
