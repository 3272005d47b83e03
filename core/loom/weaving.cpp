#include "loom/weaving.h"

#include <algorithm>

#include "base/text.h"

namespace weftlight::loom {

using base::arg, base::fill, base::tr;

namespace {

PickRange clipped(const PickRange& s, int picks) {
  const PickRange in{std::clamp(s.first, 0, picks), std::clamp(s.end, 0, picks)};
  return in.first < in.end ? in : PickRange{0, picks};
}

/// Raises the shafts of the next pick.
LoomReply raised(const WeavingSetup& w, WeavingState state) {
  const std::optional<uint32_t> shafts = raised_shafts(w.draft, w.lifts, state.next_pick);
  if (!shafts)
    return {state,
            {},
            fill(tr("the loom's protocol has room for {most} shafts, and the draft has {count}"),
                 arg("most", kMaxLoomShafts), arg("count", w.draft.shafts))};
  state.waiting = true;
  return {state, raise_command(w.protocol, *shafts), {}};
}

}  // namespace

WeavingState advanced(WeavingState state, const PickRange& range, int picks) {
  const PickRange s = clipped(range, picks);
  if (s.first >= s.end) return state;
  state = moved_to_pick(state, s, picks, state.next_pick);
  const int step = state.weaving ? 1 : -1, count = s.end - s.first;
  state.next_pick = s.first + (state.next_pick - s.first + step + count) % count;
  state.woven += step;
  return state;
}

WeavingState moved_to_pick(WeavingState state, const PickRange& range, int picks, int pick) {
  const PickRange s = clipped(range, picks);
  state.next_pick = s.first < s.end ? std::clamp(pick, s.first, s.end - 1) : 0;
  state.waiting = false;
  return state;
}

LoomReply reply_to(const WeavingSetup& w, const WeavingState& state, const LoomReport& report) {
  switch (report.kind) {
    case LoomReport::kPickWanted:
      // The request confirms that the pick on its way was woven; at the first request there is none.
      return raised(w, state.waiting ? advanced(state, w.range, w.lifts.rows()) : state);
    case LoomReport::kDirection: {
      WeavingState next_state = state;
      next_state.weaving = report.on;
      return {next_state, {}, {}};
    }
    case LoomReport::kShaftsRaised: {
      const std::optional<uint32_t> wanted = raised_shafts(w.draft, w.lifts, state.next_pick);
      const bool other = state.waiting && wanted && *wanted != report.shafts;
      return {state, {}, other ? tr("the loom has raised other shafts than were sent") : ""};
    }
    case LoomReport::kMotion:
      return {state, {}, {}};
    case LoomReport::kUnknown:
      break;
  }
  return {state, {}, fill(tr("the loom sent an unknown message: {message}"), arg("message", report.text))};
}

LoomReply on_connected(const WeavingSetup& w, const WeavingState& state) {
  LoomReply first = state.waiting ? raised(w, state) : LoomReply{state, {}, {}};
  first.send.insert(0, direction_command(w.protocol, state.weaving));
  return first;
}

LoomReply step_by_hand(const WeavingSetup& w, const WeavingState& state, bool forwards) {
  WeavingState next_state = state;
  next_state.weaving = forwards;
  LoomReply next = raised(w, state.waiting || !forwards ? advanced(next_state, w.range, w.lifts.rows()) : next_state);
  if (next_state.weaving != state.weaving) next.send.insert(0, direction_command(w.protocol, forwards));
  return next;
}

}  // namespace weftlight::loom
