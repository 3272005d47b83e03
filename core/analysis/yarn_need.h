#pragma once
// The yarn that a planned cloth takes, and what is bought for it.

#include <vector>

#include "analysis/measures.h"

namespace weftlight::analysis {

/// One yarn in one colour in one system.
struct YarnNeed {
  System system = System::kWarp;
  int yarn = 0, color = 0;
  int64_t threads = 0;
  double length_m = 0, weight_g = 0;  // with the spare
  double tex = 0;                     // mean count of the threads
};

/// One yarn in one colour, for warp and weft together.
struct YarnToBuy {
  int yarn = 0, color = 0;
  double length_m = 0, weight_g = 0;
  int64_t cones = 0;  // whole cones or skeins; 0: bought by weight
  double cost = -1;   // negative: unknown
};

struct YarnReport {
  std::vector<YarnNeed> needs;  // warp first, most threads first
  std::vector<YarnToBuy> buy;   // heaviest first
  double warp_m = 0, weft_m = 0, weight_g = 0;
  double cost = -1;     // negative: a price is unknown
  double g_per_m2 = 0;  // of the finished cloth, without waste
};
/// Of the design's plan. Floating selvedges are of the yarns of the first and the last end.
YarnReport yarn_report(const Design& design);
YarnReport yarn_report(const Design& design, const ClothMeasures& measures);

}  // namespace weftlight::analysis
