#pragma once
// The smallest draft of n threads: a straight draw, each treadle one shaft, each pick the next treadle.

#include "design/design.h"
#include "design/edits.h"

namespace weftlight {

inline design::Design straight_draft(int n) {
  design::Design d;
  d.draft = draft::blank_draft(n, n, n, n);
  for (int i = 0; i < n; ++i) {
    d.draft.threading.set(i, i, true);
    d.draft.treadling.set(i, i, true);
    d.draft.tieup.set(i, i, true);
  }
  return d;
}

}  // namespace weftlight
