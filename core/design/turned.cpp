// The shaft that an end hangs on becomes the treadle of a pick, and treadles become shafts. With one shaft for each end
// and one treadle for each pick, the crossing of a shaft and a treadle is one mark of the tie-up, so that its opposite
// exchanges warp and weft on the face.

#include "design/turned.h"

#include <utility>

#include "base/text.h"
#include "design/edits.h"
#include "design/loom.h"
#include "design/thread_order.h"
#include "draft/drawdown.h"
#include "draft/factor.h"

namespace weftlight::design {

using base::arg, base::fill, base::tr, base::tr_n;
using draft::complement, draft::transposed, draft::treadles_needed, draft::within_loom;

namespace {

/// Threading and treadling exchanged; each crossing keeps the thread system that is on top.
void exchange_grids(Draft& d) {
  std::swap(d.threading, d.treadling);
  std::swap(d.shafts, d.treadles);
  std::swap(d.warp, d.weft);
  d.tieup = transposed(d.tieup);
  d.liftplan = BitMatrix(d.picks(), d.shafts);
}

ClothPlan turned(ClothPlan plan) {
  std::swap(plan.width_mm, plan.length_mm);
  std::swap(plan.warp_take_up, plan.weft_take_up);
  std::swap(plan.warp_shrinkage, plan.weft_shrinkage);
  std::swap(plan.ends_per_cm, plan.picks_per_cm);
  plan.reed = {};
  plan.sleying = ClothPlan{}.sleying;
  return plan;
}

base::Failure too_small(const std::string& problem, bool liftplan_fits) {
  const char* what = liftplan_fits ? tr("{problem}; use the liftplan first, or enter a larger loom")
                                   : tr("{problem}; enter a larger loom first");
  return base::failure(base::ErrorKind::kInput, fill(what, arg("problem", problem)));
}

/// A treadle for each lift would be more than a draft can have shafts.
base::Failure too_many_lifts(int needed) {
  return base::failure(base::ErrorKind::kInput,
                       fill(tr_n("this needs {needed} shaft, but the loom has {most}",
                                 "this needs {needed} shafts, but the loom has {most}", needed),
                            arg("needed", needed), arg("most", int{kMaxShafts})));
}

}  // namespace

base::Result<Design> turned(const Design& design) {
  const bool liftplan = design.draft.shed_control == ShedControl::kLiftplan;
  if (const int needed = treadles_needed(design.draft); needed > kMaxShafts) return too_many_lifts(needed);
  Design out = to_treadling(with_reversed_threads(design, {System::kWarp, 0, design.draft.ends()}));
  exchange_grids(out.draft);
  // Ends on several shafts are now picks with several treadles.
  out = to_treadling(std::move(out));
  out.draft.tieup = complement(out.draft.tieup);
  if (liftplan) out = to_liftplan(std::move(out));

  const LoomSize loom = known_size(design);
  base::Result<Draft> on_loom = within_loom(out.draft, loom);
  if (!on_loom)
    return too_small(on_loom.error().text, !liftplan && within_loom(to_liftplan(out).draft, loom).has_value());
  out.draft = std::move(*on_loom);
  out.plan = turned(std::move(out.plan));
  out.loom = with_place_of(Loom{}, design.loom);
  out.weaves.clear();
  out.warp_assembly = out.weft_assembly = Assembly{};
  return out;
}

}  // namespace weftlight::design
