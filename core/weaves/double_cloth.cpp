// Double cloth. Odd ends are the upper layer, even ends the lower. A pick of the upper layer leaves all lower ends
// down; a pick of the lower layer lifts all upper ends.

#include <algorithm>

#include "weaves/families.h"

namespace weftlight::weaves {

using design::Design;
using draft::BitMatrix, draft::Draft, draft::System;

namespace {

// picks x ends of one layer: 1 where the end is up.
BitMatrix layer_weave(const OverUnder& order) {
  const Draft d = twill(order, Lean::kRight, {1, 1}).draft;
  BitMatrix up(d.treadles, d.shafts);
  for (int t = 0; t < d.treadles; ++t)
    for (int s = 0; s < d.shafts; ++s) up.set(t, s, d.tieup.get(t, s));
  return up;
}

// The shafts of a treadle of the upper or lower layer. The lower layer is seen from below, so its weave is inverted.
std::vector<int> treadle(const BitMatrix& weave, int pick, bool upper) {
  std::vector<int> shafts;
  const int n = weave.cols();
  for (int s = 0; s < n; ++s) {
    const bool up = weave.get(pick, s);
    if (!upper || up) shafts.push_back(2 * s);
    if (!upper && !up) shafts.push_back(2 * s + 1);
  }
  return shafts;
}

}  // namespace

Design double_cloth(DoubleCloth kind, const OverUnder& order, ClothSize size) {
  const OverUnder ratio = order.empty() ? OverUnder{1, 1} : order;
  const BitMatrix weave = layer_weave(ratio);
  const int n = weave.cols();
  Recipe recipe{2 * n, {}, {}, {}};
  for (int s = 0; s < 2 * n; ++s) recipe.threading.push_back(s);
  for (int p = 0; p < n; ++p) {
    recipe.tieup.push_back(treadle(weave, p, true));
    recipe.tieup.push_back(treadle(weave, p, false));
  }
  // Order of the shuttle: upper, lower; for double width upper, lower, lower, upper, so that the layers are joined by a
  // fold at one selvedge only.
  for (int p = 0; p < 4 * n; ++p) {
    const bool below_first = kind == DoubleCloth::kDoubleWidth && p / 2 % 2 == 1;
    recipe.treadling.push_back(2 * (p / 2 % n) + ((p % 2 == 1) != below_first ? 1 : 0));
  }
  // Each layer has the sett that it would have alone.
  const Design alone = twill(ratio, Lean::kRight, {n, n});
  Design design = make_design(recipe, size);
  for (const System system : {System::kWarp, System::kWeft})
    for (float& mm : design.draft.threads(system).spacing_mm) mm = 0.5f * alone.draft.threads(system).spacing_mm[0];
  return design;
}

}  // namespace weftlight::weaves
