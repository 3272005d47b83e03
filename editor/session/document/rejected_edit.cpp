#include "session/document/rejected_edit.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "design/crossings.h"
#include "design/loom.h"
#include "draft/drawdown.h"
#include "draft/factor.h"

namespace weftlight::session {

using base::tr;
using design::Loom, design::loom_size;
using draft::Draft, draft::ClosestDraft, draft::closest_drawdown, draft::differences, draft::drawdown,
    draft::kMaxShafts;

namespace {

constexpr size_t kMaxPlaces = 200;

bool same_size(const Draft& a, const Draft& b) { return a.ends() == b.ends() && a.picks() == b.picks(); }

}  // namespace

std::optional<RejectedEdit> refusal_after(std::optional<RejectedEdit> last, const Design& before, const Edit& edit,
                                          uint64_t stroke, bool changed) {
  const bool goes_on = last && stroke != 0 && last->stroke == stroke;
  if (changed && !goes_on) return {};
  Design endless = goes_on ? *last->requested : before;
  endless.loom.shafts = endless.loom.treadles = kMaxShafts;
  Design requested = edit.anew ? edit.anew(endless) : edit.apply(endless);
  if (requested.draft == endless.draft || !same_size(requested.draft, before.draft)) return last;
  return RejectedEdit{stroke, std::make_shared<const Design>(std::move(requested))};
}

std::shared_ptr<const ClosestWeave> closest_weave_to(const Design& now, const Design& requested,
                                                     const base::TaskProgress& progress) {
  const BitMatrix wanted = drawdown(requested.draft), shown = drawdown(now.draft);
  if (wanted == shown || !same_size(now.draft, requested.draft)) return nullptr;
  ClosestDraft factored = closest_drawdown(now.draft, wanted, loom_size(now), progress);
  ClosestWeave out;
  out.why = problem_of(factored.exact);
  // Without fewer wrong crossings the weaver's own threading and treadling stay.
  int64_t stays_wrong = 0;
  for (int p = 0; p < shown.rows(); ++p) stays_wrong += differences(shown.row(p), wanted.row(p));
  out.is_there = stays_wrong <= factored.wrong;
  Design design = now;
  if (!out.is_there) design.draft = std::move(factored.draft);
  out.wrong = std::min(stays_wrong, factored.wrong);
  out.differing = analysis::differing_crossings(drawdown(design.draft), wanted);
  out.places = analysis::differing_regions(out.differing, kMaxPlaces);
  out.design = std::make_shared<const Design>(std::move(design));
  return std::make_shared<const ClosestWeave>(std::move(out));
}

Edit larger_loom_edit(const RejectedEdit& rejected_edit) {
  return {tr("Add shafts or treadles"), [requested = rejected_edit.requested](Design design) {
            design.draft = requested->draft;
            Loom& loom = design.loom;
            if (loom.shafts > 0) loom.shafts = std::max(loom.shafts, design.draft.shafts);
            if (loom.treadles > 0) loom.treadles = std::max(loom.treadles, design.draft.treadles);
            return design;
          }};
}

}  // namespace weftlight::session
