#pragma once
// A skeleton tie-up: several treadles are pressed at once in a pick, so that fewer treadles are needed in all.

#include "base/progress.h"
#include "draft/draft.h"

namespace weftlight::draft {

struct Skeleton {
  BitMatrix tieup, treadling;  // treadles x shafts, picks x treadles
  int at_least = 0;            // lower bound of the number of treadles
  bool fewest = false;         // proved: no skeleton tie-up has fewer treadles
};

/// Treadles for `lifts` (picks x shafts), at most `treadles_per_pick` (1..4) in a pick and never more than distinct
/// lifts. The search ends after `steps` combinations, or when it is asked to stop, with the fewest treadles found so
/// far.
Skeleton skeleton_tieup(const BitMatrix& lifts, int treadles_per_pick, const base::TaskProgress& progress = {},
                        int steps = 10000000);

}  // namespace weftlight::draft
