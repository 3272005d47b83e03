#pragma once
// What the weaver prepares: heddles, use of shafts and treadles, sett, yarn lengths.

#include <array>
#include <string>
#include <vector>

#include "analysis/weave_layers.h"
#include "design/design.h"

namespace weftlight::analysis {

using design::Design;
using draft::BitMatrix, draft::Draft, draft::System;

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

/// Threads per cm side by side without pressure (wraps): 10 / diameter.
double wraps_per_cm(float diameter_mm);
/// Threads per cm of the loom for a firm cloth. Based on: T. R. Ashenhurst, A Treatise on Textile Calculations and
/// the Structure of Fabrics, 1884: a repeat of T threads with i interlacings has room for wraps T / (T + i).
double sett_per_cm(double wraps_per_cm, double interlacing);
/// Ends per cm of the loom for a firm cloth of yarn with that many wraps. Separate layers lie one over the other, and
/// each interlaces with its own picks only: their setts add up. Loose threads do not count. `layers`: of the drawdown.
double firm_sett_per_cm(const BitMatrix& cells, const std::vector<WeaveLayer>& layers, double wraps_per_cm);

/// How a cloth is planned. Lengths in mm; take-up, shrinkage and spare are fractions (0.1: 10 %).
struct ClothPlan {
  double length_mm = 0, width_mm = 0;  // of the finished cloth; 0: the size of the draft
  double loom_waste_mm = 600;          // loom waste (thrums)
  double warp_take_up = 0.08, weft_take_up = 0.06;
  double warp_shrinkage = 0.08, weft_shrinkage = 0.08;  // in finishing
  double spare = 0.05;                                  // yarn lost in winding and in shuttles
  std::vector<double> price_per_kg;                     // by yarn; missing or negative: unknown
  bool operator==(const ClothPlan&) const = default;
};

/// One yarn in one colour in one system.
struct YarnNeed {
  System system = System::kWarp;
  int yarn = 0, color = 0;
  int64_t threads = 0;
  double length_m = 0, weight_g = 0;
  double cost = -1;  // negative: unknown
};

struct YarnReport {
  std::vector<YarnNeed> needs;  // warp first, most threads first
  int64_t ends = 0, picks = 0;  // of the whole cloth
  double loom_width_mm = 0, warp_length_mm = 0;
  double warp_m = 0, weft_m = 0, weight_g = 0;
  double cost = -1;  // negative: a price is unknown
  double ends_per_cm = 0, picks_per_cm = 0;
  double g_per_m2 = 0;  // of the finished cloth, without waste
};
YarnReport yarn_report(const Design& design, const ClothPlan& plan);

}  // namespace weftlight::analysis
