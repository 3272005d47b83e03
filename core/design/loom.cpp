#include "design/loom.h"

#include <algorithm>

#include "base/text.h"

namespace weftlight::design {

using base::tr;

LoomSize loom_size(const Design& design) {
  const auto most = [](int loom, int has) { return std::max(loom > 0 ? loom : kDefaultLimit, has); };
  return {most(design.loom.shafts, design.draft.shafts), most(design.loom.treadles, design.draft.treadles)};
}

namespace {

base::Failure locked(std::string why) { return base::failure(base::ErrorKind::kInput, std::move(why)); }

}  // namespace

base::Result<void> may_paint(const Design& design, BitGrid grid) {
  if (!design.loom.locked) return {};
  const bool drawdown_rules = design.loom.leading == Leading::kDrawdown;
  if (drawdown_rules == (grid == BitGrid::kDrawdown)) {
    const bool treadles = grid == BitGrid::kTieup || grid == BitGrid::kTreadling;
    if (design.loom.leading != Leading::kLiftplan || !treadles) return {};
    return locked(tr("tie-up and treadling follow the liftplan and are locked"));
  }
  return locked(drawdown_rules ? tr("this follows the drawdown and is locked")
                               : tr("the drawdown follows and is locked"));
}

}  // namespace weftlight::design
