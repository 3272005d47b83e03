#include "session/refusal.h"

#include <algorithm>
#include <utility>

#include "draft/crossings.h"
#include "draft/drawdown.h"

namespace weftlight::session {
namespace {

constexpr size_t kMostPlaces = 200;

bool same_size(const Draft& a, const Draft& b) { return a.ends() == b.ends() && a.picks() == b.picks(); }

}  // namespace

std::optional<Refusal> refusal_after(std::optional<Refusal> last, const Design& before, const Edit& edit,
                                     uint64_t stroke, bool changed) {
  const bool goes_on = last && stroke != 0 && last->stroke == stroke;
  if (changed && !goes_on) return {};
  Design endless = goes_on ? *last->wish : before;
  endless.loom.shafts = endless.loom.treadles = kMaxShafts;
  Design wish = edit.anew ? edit.anew(endless) : edit.apply(endless);
  if (wish.draft == endless.draft || !same_size(wish.draft, before.draft)) return last;
  return Refusal{stroke, std::make_shared<const Design>(std::move(wish))};
}

std::shared_ptr<const Nearest> nearest_to(const Design& now, const Design& wish) {
  const BitMatrix wanted = drawdown(wish.draft), shown = drawdown(now.draft);
  if (wanted == shown || !same_size(now.draft, wish.draft)) return nullptr;
  Factored factored = nearest_drawdown(now.draft, wanted, loom_size(now));
  Nearest out;
  out.why = std::move(factored.why);
  // What costs no fewer crossings is no reason to give up the weaver's numbers.
  int64_t stays_wrong = 0;
  for (int p = 0; p < shown.rows(); ++p) stays_wrong += differences(shown.row(p), wanted.row(p));
  out.is_there = stays_wrong <= factored.wrong;
  Design design = now;
  if (!out.is_there) design.draft = std::move(factored.draft);
  out.wrong = std::min(stays_wrong, factored.wrong);
  out.differing = analysis::differing_crossings(drawdown(design.draft), wanted);
  out.places = analysis::differing_places(out.differing, kMostPlaces);
  out.design = std::make_shared<const Design>(std::move(design));
  return std::make_shared<const Nearest>(std::move(out));
}

Edit larger_loom_edit(const Refusal& refusal) {
  return {"A larger loom", [wish = refusal.wish](Design design) {
            design.draft = wish->draft;
            Loom& loom = design.loom;
            if (loom.shafts > 0) loom.shafts = std::max(loom.shafts, design.draft.shafts);
            if (loom.treadles > 0) loom.treadles = std::max(loom.treadles, design.draft.treadles);
            return design;
          }};
}

}  // namespace weftlight::session
