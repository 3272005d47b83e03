#pragma once
// The plan of a cloth in sentences, for the window, the command line and paper.

#include <string>

#include "analysis/reeds.h"
#include "analysis/units.h"
#include "analysis/warping.h"
#include "analysis/yarn_need.h"

namespace weftlight::analysis {

/// "2 ends in each dent", "1-1-2 ends in the dents, repeated".
std::string sleying_words(const std::vector<int>& sleying);
/// "615 ends, 2 floating selvedges".
std::string ends_text(const ClothMeasures& m);
/// "20 repeats of the draft and 15 ends"; empty if the cloth is the draft.
std::string repeats_text(const WarpingPlan& plan);
/// "6 bouts of 100 ends, the last of 50", "2 bouts, of 145 and 131 ends".
std::string bouts_text(const WarpingPlan& plan);
/// "55 groups of 10 ends", "57 groups of 10-9-10 ends in turn".
std::string raddle_text(const WarpingPlan& plan);
/// Whether floating selvedges are needed, and why.
std::string selvedges_text(const Selvedges& s);
/// "+1.2%", "exact" within 0.05%.
std::string deviation_text(double fraction);
/// "3 cones", "1.20 kg": what is bought.
std::string bought_text(const YarnToBuy& one, Units units);

}  // namespace weftlight::analysis
