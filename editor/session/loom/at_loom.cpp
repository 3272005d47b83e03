#include "session/loom/at_loom.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "analysis/measures.h"
#include "analysis/reeds.h"
#include "base/text.h"
#include "design/loom.h"
#include "draft/drawdown.h"
#include "loom/tabby.h"

namespace weftlight::session {

using analysis::cloth_measures, analysis::dents_for;
using base::tr;
using design::Loom, design::with_place_of;
using draft::BitMatrix, draft::ShedControl, draft::for_each_bit, draft::lifts;

namespace {

/// The edit that makes the design hold this place; nothing if it does. It has no label, since it is no step of undo.
MaybeEdit kept(const Design& design, const Loom& place) {
  if (with_place_of(place, design.loom) == design.loom) return {};
  return Edit{{}, [place](Design d) {
                d.loom = with_place_of(place, d.loom);
                return d;
              }};
}

LoomStep taken(AtLoom& at, const Design& design, loom::LoomReply reply) {
  at.place = reply.state;
  if (!reply.remark.empty()) at.remark = std::move(reply.remark);
  Loom places = design.loom;
  places.next_pick = at.place.next_pick;
  places.at_tabby = at.place.at_tabby;
  places.second_tabby = at.place.second_tabby;
  return {kept(design, places), std::move(reply.send)};
}

/// Calls `what` with the draft and its lifted shafts.
template <class What>
LoomStep with_weaving(AtLoom& at, const Design& design, What what) {
  const BitMatrix lifted = lifts(design.draft);
  const bool tabby = design.loom.tabby_between && loom::tabby_sheds(design.draft);
  return taken(at, design,
               what(loom::WeavingSetup{design.draft, lifted, at.section, at.protocol, tabby}, place_of(at, design)));
}

LoomStep moved_to_end(const Design& design, int end) {
  Loom places = design.loom;
  places.next_end = std::clamp(end, 0, ends_on_loom(design));
  return {kept(design, places)};
}

LoomStep moved_to_dent(const Design& design, int dent) {
  Loom places = design.loom;
  places.next_dent = std::clamp(dent, 0, dents_on_loom(design));
  return {kept(design, places)};
}

}  // namespace

loom::WeavingState place_of(const AtLoom& at, const Design& design) {
  loom::WeavingState place = at.place;
  const bool tabby = design.loom.at_tabby && loom::tabby_sheds(design.draft);
  const bool elsewhere = place.next_pick != design.loom.next_pick || place.at_tabby != tabby ||
                         place.second_tabby != design.loom.second_tabby;
  loom::WeavingState brought = loom::moved_to_pick(place, at.section, design.draft.picks(), design.loom.next_pick);
  brought.at_tabby = tabby;
  brought.second_tabby = design.loom.second_tabby;
  return elsewhere || brought.next_pick != place.next_pick ? brought : place;
}

LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected) {
  at.remark.clear();
  const int step = forwards ? 1 : -1;
  if (at.work == LoomWork::kThread) return moved_to_end(design, design.loom.next_end + step);
  if (at.work == LoomWork::kSley) return moved_to_dent(design, design.loom.next_dent + step);
  return with_weaving(at, design, [=](const loom::WeavingSetup& w, loom::WeavingState place) {
    if (connected) return loom::step_by_hand(w, place, forwards);
    place.weaving = forwards;
    place = loom::advanced(place, w.range, w.lifts.rows(), w.tabby_between);
    place.weaving = true;
    place.waiting = false;  // no loom has received this pick yet; the next that connects does
    return loom::LoomReply{place, {}, {}};
  });
}

LoomStep give_tabby(AtLoom& at, const Design& design, bool connected) {
  at.remark.clear();
  if (at.work != LoomWork::kWeave) return {};
  return with_weaving(at, design, [=](const loom::WeavingSetup& w, const loom::WeavingState& place) {
    return loom::insert_tabby(w, place, connected);
  });
}

LoomStep put_tabby_between(AtLoom& at, const Design& design, bool on) {
  at.remark.clear();
  if (on && !loom::tabby_sheds(design.draft)) return give_tabby(at, design, false);  // which says why not
  return {Edit{on ? tr("Add tabby between pattern picks") : tr("Remove tabby between pattern picks"), [on](Design d) {
                 d.loom.tabby_between = on;
                 return d;
               }}};
}

LoomStep hear(AtLoom& at, const Design& design, const loom::LoomReport& report) {
  return with_weaving(at, design, [&](const loom::WeavingSetup& w, const loom::WeavingState& place) {
    return loom::reply_to(w, place, report);
  });
}

LoomStep greet(AtLoom& at, const Design& design) {
  at.remark.clear();
  return with_weaving(at, design, [](const loom::WeavingSetup& w, const loom::WeavingState& place) {
    return loom::on_connected(w, place);
  });
}

LoomStep go_to_pick(AtLoom& at, const Design& design, int pick) {
  if (loom::takes_picks_ahead(at.protocol))
    return with_weaving(at, design, [&](const loom::WeavingSetup& w, const loom::WeavingState& place) {
      loom::LoomReply there = loom::sent_again(w, loom::moved_to_pick(place, w.range, w.lifts.rows(), pick));
      at.to_send = there.send;
      return there;
    });
  return taken(at, design, {loom::moved_to_pick(at.place, at.section, design.draft.picks(), pick), {}, {}});
}

LoomStep go_to(AtLoom& at, const Design& design, int number) {
  at.remark.clear();
  if (at.work == LoomWork::kThread) return moved_to_end(design, number);
  if (at.work == LoomWork::kSley) return moved_to_dent(design, number);
  return go_to_pick(at, design, number);
}

LoomStep keep_to_section(AtLoom& at, const Design& design, loom::PickRange section) {
  at.section = section;
  return taken(at, design, {place_of(at, design), {}, {}});
}

std::vector<int> to_press(const Draft& draft, int pick) {
  std::vector<int> out;
  const BitMatrix& rows = draft.shed_control == ShedControl::kLiftplan ? draft.liftplan : draft.treadling;
  if (pick >= 0 && pick < rows.rows()) for_each_bit(rows.row(pick), [&out](int mark) { out.push_back(mark); });
  return out;
}

int ends_on_loom(const Design& design) {
  if (design.draft.ends() == 0) return 0;
  const int64_t ends = design.plan.width_mm > 0 ? cloth_measures(design).ends : design.draft.ends();
  return static_cast<int>(std::min<int64_t>(ends, draft::kMaxThreads));
}

int dents_on_loom(const Design& design) {
  const int64_t dents = dents_for(ends_on_loom(design), design.plan.sleying);
  return static_cast<int>(std::min<int64_t>(dents, design::kMaxLoomDents - 2)) +
         (design.plan.floating_selvedges ? 2 : 0);
}

DentEnds ends_in_dent(const Design& design, int dent) {
  const bool floating = design.plan.floating_selvedges;
  if (floating && (dent == 0 || dent == dents_on_loom(design) - 1)) return {0, 0, true};
  if (design.plan.sleying.empty()) return {};
  if (floating) --dent;
  const std::vector<int>& sleying = design.plan.sleying;
  const int dents = static_cast<int>(sleying.size()), in_pattern = dent % dents;
  const auto ends_of = [&sleying](int count) {
    return std::accumulate(sleying.begin(), sleying.begin() + count, int64_t{0});
  };
  const int64_t before = dent / dents * ends_of(dents) + ends_of(in_pattern);
  const int ends = ends_on_loom(design), first = static_cast<int>(std::min<int64_t>(before, ends));
  return {first, std::min(sleying[static_cast<size_t>(in_pattern)], ends - first), false};
}

}  // namespace weftlight::session
