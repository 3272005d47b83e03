#pragma once
// Reeds: the setts that they make with the ends sleyed into their dents, and the reeds nearest to a sett.
//
// Sizes: common practice of makers and dealers; Scandinavian reeds are marked with dents in 10 cm, in steps of 5 and
// from 60 on of 10 (M. van der Hoogt, Converting Metric Reeds to Inches, Interweave, names 20/10 to 60/10); American
// ones with dents in an inch (House of Wool, Reed Substitution Guide, and the School of SweetGeorgia, Reed Substitution
// Chart, have the columns 5 to 20).

#include <cstdint>
#include <span>
#include <vector>

#include "design/cloth_plan.h"

namespace weftlight::analysis {

using design::Reed;

/// Dents in 10 cm, or in an inch; ascending.
std::span<const float> standard_reeds(bool per_inch);

/// Sleyings of handbooks: the same in each dent, or one more in every second, in one or two of three, in one or three
/// of four; by ends in a dent, up to 5.
const std::vector<std::vector<int>>& sleying_patterns();

/// Ends in a cm of the loom: dents in a cm times ends in a dent, on average.
double sett_in_reed(const Reed& reed, const std::vector<int>& sleying);
/// Dents that so many ends take, the empty ones between them too.
int64_t dents_for(int64_t ends, const std::vector<int>& sleying);

/// Whole numbers, as even as they can be, whose mean is nearest to `mean`; up to `most` of them, the fewest of equals.
std::vector<int> even_numbers(double mean, int most);

struct SleyedReed {
  Reed reed;
  std::vector<int> sleying;
  double ends_per_cm = 0;
  double deviation = 0;  // from the sett that was asked for, as a fraction of it
  bool operator==(const SleyedReed&) const = default;
};
/// The one of sleying_patterns() that suits a sett best in this reed. Without a sleying if none comes within
/// kMaxSettDeviation.
SleyedReed best_sleyed(const Reed& reed, double ends_per_cm);
/// The standard reeds that come nearest to a sett, each with the sleying that suits it best: `most` of them, best
/// first. None is further off than kMaxSettDeviation. A long pattern, an empty dent or a crowd in one dent (it leaves
/// reed marks) counts like a deviation of 1% or 2%.
std::vector<SleyedReed> nearest_reeds(double ends_per_cm, bool per_inch, size_t most);
inline constexpr double kMaxSettDeviation = 0.08;

}  // namespace weftlight::analysis
