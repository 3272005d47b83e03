#pragma once
// The draft as a weave and on a loom: layers, fewest shafts and treadles, sett.

#include "analysis/measures.h"
#include "analysis/threads.h"
#include "analysis/weave_layers.h"
#include "draft/factor.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::LoomSize;

/// Results for one revision of the design. Computed again when it changes while the section is open.
struct AnalysisState {
  uint64_t revision = 0;  // 0: not computed yet
  std::vector<analysis::WeaveLayer> layers;
  analysis::LoomUse loom;
  LoomSize fewest;
  double firm_sett = 0;  // as a fraction of the wraps
  double wraps = 0;      // of the ends, in a cm
  analysis::ClothMeasures measures;
};

/// Drafts of up to kLiveCrossings are analysed after every edit, larger ones on request.
inline constexpr int64_t kLiveCrossings = int64_t{1} << 22;

void draw_analysis(PanelContext& c, AnalysisState& state);

}  // namespace weftlight::views
