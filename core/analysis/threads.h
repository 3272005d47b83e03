#pragma once
// What the draft asks of the loom: heddles, use of shafts and treadles; interlacings and the sett that they allow.

#include <vector>

#include "analysis/weave_layers.h"
#include "draft/draft.h"

namespace weftlight::analysis {

using draft::BitMatrix, draft::Draft;

/// Heddles on each shaft, ends on none, and how often each shaft and treadle is used.
struct LoomUse {
  std::vector<int> heddles;       // per shaft
  std::vector<int> lifts;         // picks that name it, per shaft
  std::vector<int> treadle_uses;  // picks that use it, per treadle; empty for a liftplan
  int unthreaded_ends = 0, ends_in_several = 0;
  int empty_picks = 0;             // picks that lift no shaft
  int most_treadles_per_pick = 0;  // largest number of treadles in one pick
};
LoomUse loom_use(const Draft& draft);

/// Interlacings per crossing: fraction (0..1) of neighbouring crossings along a thread between which it changes face.
/// 1 for plain weave, 1/2 for 2/2 twill.
struct Interlacing {
  double warp = 0, weft = 0;
};
Interlacing interlacing(const BitMatrix& cells);

/// Threads per cm side by side without pressure (wraps): 10 / diameter, that of the thread before it is woven.
double wraps_per_cm(float diameter_mm);
/// Threads per cm of the loom for a firm cloth. Based on: T. R. Ashenhurst, A Treatise on Textile Calculations and
/// the Structure of Fabrics, 1884: a repeat of T threads with i interlacings has room for wraps T / (T + i).
double sett_per_cm(double wraps_per_cm, double interlacing);
/// Ends per cm of the loom for a firm cloth of yarn with that many wraps. Separate layers lie one over the other, and
/// each interlaces with its own picks only: their setts add up. Loose threads do not count. `layers`: of the drawdown.
double firm_sett_per_cm(const BitMatrix& cells, const std::vector<WeaveLayer>& layers, double wraps_per_cm);

}  // namespace weftlight::analysis
