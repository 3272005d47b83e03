#pragma once
// A skeleton tie-up: picks are lifted by several treadles at once, so that fewer treadles do for all of them.

#include "draft/draft.h"

namespace weftlight::draft {

struct Skeleton {
  BitMatrix tieup, treadling;  // treadles x shafts, picks x treadles
  int at_least = 0;            // no skeleton has fewer treadles than this
  bool fewest = false;         // the search was finished: there is none with fewer
};

/// Treadles for `lifts` (picks x shafts), at most `feet` (1..4) a pick. Looks at `steps` ways of making a lift
/// at the most; never more treadles than distinct lifts.
Skeleton skeleton_tieup(const BitMatrix& lifts, int feet, int steps = 10000000);

}  // namespace weftlight::draft
