#include "loom/weaving.h"

#include <algorithm>

namespace weftlight::loom {
namespace {

PickRange bounded(const PickRange& s, int picks) {
  const PickRange in{std::clamp(s.first, 0, picks), std::clamp(s.end, 0, picks)};
  return in.first < in.end ? in : PickRange{0, picks};
}

/// Raises the shafts of the next pick.
LoomReply raised(const WeavingSetup& w, WeavingState state) {
  const std::optional<uint32_t> shafts = raised_shafts(w.draft, w.lifts, state.next_pick);
  if (!shafts)
    return {state,
            {},
            "the line can name " + std::to_string(kMaxLoomShafts) + " shafts, and the draft has " +
                std::to_string(w.draft.shafts)};
  state.waiting = true;
  return {state, raise_command(w.protocol, *shafts), {}};
}

}  // namespace

WeavingState advanced(WeavingState state, const PickRange& section, int picks) {
  const PickRange s = bounded(section, picks);
  if (s.first >= s.end) return state;
  state = moved_to_pick(state, s, picks, state.next_pick);
  const int step = state.weaving ? 1 : -1, count = s.end - s.first;
  state.next_pick = s.first + (state.next_pick - s.first + step + count) % count;
  state.woven += step;
  return state;
}

WeavingState moved_to_pick(WeavingState state, const PickRange& section, int picks, int pick) {
  const PickRange s = bounded(section, picks);
  state.next_pick = s.first < s.end ? std::clamp(pick, s.first, s.end - 1) : 0;
  state.waiting = false;
  return state;
}

LoomReply reply_to(const WeavingSetup& w, const WeavingState& state, const LoomReport& report) {
  switch (report.kind) {
    case LoomReport::kPickWanted:
      // The pick whose shafts were up has been woven; the first one of all has not.
      return raised(w, state.waiting ? advanced(state, w.section, w.lifts.rows()) : state);
    case LoomReport::kDirection: {
      WeavingState turned = state;
      turned.weaving = report.on;
      return {turned, {}, {}};
    }
    case LoomReport::kShaftsRaised: {
      const std::optional<uint32_t> wanted = raised_shafts(w.draft, w.lifts, state.next_pick);
      const bool other = state.waiting && wanted && *wanted != report.shafts;
      return {state, {}, other ? "the loom has raised other shafts than were sent" : ""};
    }
    case LoomReport::kMotion:
      return {state, {}, {}};
    case LoomReport::kUnknown:
      break;
  }
  return {state, {}, "the loom said something that is not known: " + report.text};
}

LoomReply on_connected(const WeavingSetup& w, const WeavingState& state) {
  LoomReply first = state.waiting ? raised(w, state) : LoomReply{state, {}, {}};
  first.send.insert(0, direction_command(w.protocol, state.weaving));
  return first;
}

LoomReply step_by_hand(const WeavingSetup& w, const WeavingState& state, bool forwards) {
  WeavingState turned = state;
  turned.weaving = forwards;
  LoomReply next = raised(w, state.waiting || !forwards ? advanced(turned, w.section, w.lifts.rows()) : turned);
  if (turned.weaving != state.weaving) next.send.insert(0, direction_command(w.protocol, forwards));
  return next;
}

}  // namespace weftlight::loom
