#include "design/loom.h"

#include <algorithm>

#include "base/text.h"

namespace weftlight::design {

using base::tr;
using draft::fits, draft::kMaxShafts;

LoomSize loom_size(const Design& design) {
  const auto most = [](int loom, int has) { return std::max(loom > 0 ? loom : kDefaultLimit, has); };
  return {most(design.loom.shafts, design.draft.shafts), most(design.loom.treadles, design.draft.treadles)};
}

LoomSize known_size(const Design& design) {
  const LoomSize known = loom_size(design);
  return {design.loom.shafts > 0 ? known.shafts : kMaxShafts, design.loom.treadles > 0 ? known.treadles : kMaxShafts};
}

base::Result<void> weaves_on_loom(const Design& design, const draft::Draft& next) {
  return fits(next, known_size(design));
}

bool leads(const Design& design, BitGrid grid) {
  const Leading leading = design.loom.leading;
  if ((leading == Leading::kDrawdown) != (grid == BitGrid::kDrawdown)) return false;
  return leading != Leading::kLiftplan || (grid != BitGrid::kTieup && grid != BitGrid::kTreadling);
}

base::Result<void> may_paint(const Design& design, BitGrid grid) {
  if (!design.loom.locked || leads(design, grid)) return {};
  const char* why = design.loom.leading == Leading::kDrawdown ? tr("This follows the drawdown and is locked.")
                    : grid == BitGrid::kDrawdown              ? tr("The drawdown follows and is locked.")
                                                 : tr("Tie-up and treadling follow the liftplan and are locked.");
  return base::failure(base::ErrorKind::kInput, why);
}

Loom with_place_of(const Loom& place, Loom loom) {
  loom.next_pick = place.next_pick;
  loom.next_end = place.next_end;
  loom.next_dent = place.next_dent;
  loom.at_tabby = place.at_tabby;
  loom.second_tabby = place.second_tabby;
  return loom;
}

}  // namespace weftlight::design
