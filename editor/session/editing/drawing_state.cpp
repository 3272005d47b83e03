#include "session/editing/drawing_state.h"

#include <algorithm>

namespace weftlight::session {

using draft::BitMatrix;

namespace {

bool has_mark(const BitMatrix& m, int column) {
  for (int row = 0; row < m.rows(); ++row)
    if (m.get(row, column)) return true;
  return false;
}

}  // namespace

void follow_given(LoomSize& given, const Draft& before, const Draft& now, bool by_painting) {
  // Painting adds only what it uses. An unused new shaft or treadle was requested by the user, also when redo restores
  // it.
  const auto follow = [by_painting](int& own, int was, int is, bool last_in_use) {
    const bool asked = is != was && !(by_painting && (last_in_use || is < was));
    own = asked ? is : std::min(own, is);
  };
  const int shaft = now.shafts - 1, treadle = now.treadles - 1;
  follow(given.shafts, before.shafts, now.shafts, shaft < 0 || has_mark(now.threading, shaft));
  follow(given.treadles, before.treadles, now.treadles,
         treadle < 0 || now.tieup.first(treadle) >= 0 || has_mark(now.treadling, treadle));
}

}  // namespace weftlight::session
