#include "session/at_loom.h"

#include <algorithm>
#include <utility>

#include "draft/drawdown.h"

namespace weftlight::session {
namespace {

constexpr uint64_t kLoomStrokes = uint64_t{1} << 61;  // apart from those of the mouse

LoomStep taken(AtLoom& at, const Design& design, loom::Answer answer) {
  at.place = answer.place;
  if (!answer.remark.empty()) at.remark = std::move(answer.remark);
  LoomStep step;
  step.send = std::move(answer.send);
  if (const int next = at.place.next_pick; next != design.loom.next_pick)
    step.edit = Edit{"Weave at the loom",
                     [next](Design d) {
                       d.loom.next_pick = next;
                       return d;
                     },
                     kLoomStrokes | at.session};
  return step;
}

/// Calls `what` with the draft as the loom sees it.
template <class What>
LoomStep with_weaving(AtLoom& at, const Design& design, What what) {
  const BitMatrix lifted = lifts(design.draft);
  return taken(at, design, what(loom::Weaving{design.draft, lifted, at.section, at.protocol}, place_of(at, design)));
}

}  // namespace

loom::Place place_of(const AtLoom& at, const Design& design) {
  loom::Place place = at.place;
  const bool elsewhere = place.next_pick != design.loom.next_pick;
  const loom::Place brought = loom::jumped(place, at.section, design.draft.picks(), design.loom.next_pick);
  return elsewhere || brought.next_pick != place.next_pick ? brought : place;
}

LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected) {
  at.remark.clear();
  return with_weaving(at, design, [=](const loom::Weaving& w, loom::Place place) {
    if (connected) return loom::step_by_hand(w, place, forwards);
    place.weaving = forwards;
    place = loom::stepped(place, w.section, w.lifts.rows());
    place.weaving = true;
    place.waiting = false;  // no loom was told: the first that comes is
    return loom::Answer{place, {}, {}};
  });
}

LoomStep hear(AtLoom& at, const Design& design, const loom::LoomReport& report) {
  return with_weaving(at, design,
                      [&](const loom::Weaving& w, const loom::Place& place) { return loom::answer(w, place, report); });
}

LoomStep greet(AtLoom& at, const Design& design) {
  at.remark.clear();
  return with_weaving(at, design,
                      [](const loom::Weaving& w, const loom::Place& place) { return loom::on_connected(w, place); });
}

LoomStep go_to_pick(AtLoom& at, const Design& design, int pick) {
  return taken(at, design, {loom::jumped(at.place, at.section, design.draft.picks(), pick), {}, {}});
}

LoomStep keep_to_section(AtLoom& at, const Design& design, loom::Section section) {
  at.section = section;
  return taken(at, design, {place_of(at, design), {}, {}});
}

std::vector<int> to_press(const Draft& draft, int pick) {
  std::vector<int> out;
  const BitMatrix& rows = draft.drive == ShedControl::kLiftplan ? draft.liftplan : draft.treadling;
  if (pick >= 0 && pick < rows.rows()) for_each_bit(rows.row(pick), [&out](int mark) { out.push_back(mark); });
  return out;
}

}  // namespace weftlight::session
