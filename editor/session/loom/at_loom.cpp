#include "session/loom/at_loom.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "draft/drawdown.h"

namespace weftlight::session {

using base::tr;
using draft::BitMatrix, draft::ShedControl, draft::for_each_bit, draft::lifts;

namespace {

constexpr uint64_t kLoomStrokes = uint64_t{1} << 61;  // distinct from mouse strokes

LoomStep taken(AtLoom& at, const Design& design, loom::LoomReply reply) {
  at.place = reply.state;
  if (!reply.remark.empty()) at.remark = std::move(reply.remark);
  LoomStep step;
  step.send = std::move(reply.send);
  if (const int next = at.place.next_pick; next != design.loom.next_pick)
    step.edit = Edit{tr("Weave at the loom"),
                     [next](Design d) {
                       d.loom.next_pick = next;
                       return d;
                     },
                     kLoomStrokes | at.session};
  return step;
}

/// Calls `what` with the draft and its lifted shafts.
template <class What>
LoomStep with_weaving(AtLoom& at, const Design& design, What what) {
  const BitMatrix lifted = lifts(design.draft);
  return taken(at, design,
               what(loom::WeavingSetup{design.draft, lifted, at.section, at.protocol}, place_of(at, design)));
}

}  // namespace

loom::WeavingState place_of(const AtLoom& at, const Design& design) {
  loom::WeavingState place = at.place;
  const bool elsewhere = place.next_pick != design.loom.next_pick;
  const loom::WeavingState brought =
      loom::moved_to_pick(place, at.section, design.draft.picks(), design.loom.next_pick);
  return elsewhere || brought.next_pick != place.next_pick ? brought : place;
}

LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected) {
  at.remark.clear();
  return with_weaving(at, design, [=](const loom::WeavingSetup& w, loom::WeavingState place) {
    if (connected) return loom::step_by_hand(w, place, forwards);
    place.weaving = forwards;
    place = loom::advanced(place, w.range, w.lifts.rows());
    place.weaving = true;
    place.waiting = false;  // no loom has received this pick yet; the next that connects does
    return loom::LoomReply{place, {}, {}};
  });
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
  return taken(at, design, {loom::moved_to_pick(at.place, at.section, design.draft.picks(), pick), {}, {}});
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

}  // namespace weftlight::session
