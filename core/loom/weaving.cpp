#include "loom/weaving.h"

#include <algorithm>

#include "base/text.h"
#include "loom/tabby.h"

namespace weftlight::loom {

using base::arg, base::fill, base::tr;

namespace {

PickRange clipped(const PickRange& s, int picks) {
  const PickRange in{std::clamp(s.first, 0, picks), std::clamp(s.end, 0, picks)};
  return in.first < in.end ? in : PickRange{0, picks};
}

/// The shafts that rise for the tabby pick, or for the next pick; nothing if the protocol has no room for them.
std::optional<uint32_t> wanted_shafts(const WeavingSetup& w, const WeavingState& state) {
  const std::optional<TabbySheds> sheds = state.at_tabby ? tabby_sheds(w.draft) : std::nullopt;
  if (!sheds) return raised_shafts(w.draft, w.lifts, state.next_pick);
  if (w.draft.shafts > kMaxLoomShafts) return {};
  uint32_t shafts = 0;
  for (const int shaft : state.second_tabby ? sheds->second : sheds->first) shafts |= uint32_t{1} << shaft;
  return shafts;
}

/// Raises the shafts of the tabby pick, or of the next pick.
LoomReply raised(const WeavingSetup& w, WeavingState state) {
  const std::optional<uint32_t> shafts = wanted_shafts(w, state);
  if (!shafts)
    return {state,
            {},
            fill(tr("the loom's protocol has room for {most} shafts, and the draft has {count}"),
                 arg("most", kMaxLoomShafts), arg("count", w.draft.shafts))};
  state.waiting = true;
  if (takes_picks_ahead(w.protocol)) state.shed = WeavingState::Shed::kSent;
  return {state, raise_command(w.protocol, *shafts), {}};
}

/// Sends the shafts of the pick after the next, whose own shed is open.
LoomReply raised_ahead(const WeavingSetup& w, WeavingState state) {
  LoomReply after = raised(w, advanced(state, w.range, w.lifts.rows(), w.tabby_between));
  if (after.send.empty()) return {state, {}, after.remark};
  state.waiting = true;
  state.shed = WeavingState::Shed::kAhead;
  return {state, std::move(after.send), {}};
}

/// What a loom that takes picks ahead is sent when it can take shafts.
LoomReply shafts_to_take(const WeavingSetup& w, const WeavingState& state, bool shed_open) {
  using Shed = WeavingState::Shed;
  if (state.shed == Shed::kUnknown || state.shed == Shed::kSent) return raised(w, state);
  if (state.shed == Shed::kAhead || shed_open) return raised_ahead(w, state);
  return {state, {}, {}};
}

LoomReply shed_closed(const WeavingSetup& w, const WeavingState& state) {
  using Shed = WeavingState::Shed;
  WeavingState next_state =
      state.shed == Shed::kAhead ? advanced(state, w.range, w.lifts.rows(), w.tabby_between) : state;
  if (state.shed != Shed::kUnknown) next_state.shed = Shed::kFixed;
  next_state.waiting = false;
  return {next_state, {}, {}};
}

}  // namespace

WeavingState advanced(WeavingState state, const PickRange& range, int picks, bool tabby_between) {
  const PickRange s = clipped(range, picks);
  if (s.first >= s.end) return state;
  const bool was_tabby = state.at_tabby;
  state = moved_to_pick(state, s, picks, state.next_pick);
  const int step = state.weaving ? 1 : -1, count = s.end - s.first;
  if (was_tabby && !state.weaving && !tabby_between) return state;  // it was asked for by mistake
  state.woven += step;
  const auto go = [&] { state.next_pick = s.first + (state.next_pick - s.first + step + count) % count; };
  if (state.weaving) {
    if (was_tabby) {
      state.second_tabby = !state.second_tabby;
    } else {
      go();
      state.at_tabby = tabby_between;
    }
  } else if (was_tabby || !tabby_between) {
    go();
  } else {
    state.at_tabby = true;
    state.second_tabby = !state.second_tabby;
  }
  return state;
}

WeavingState moved_to_pick(WeavingState state, const PickRange& range, int picks, int pick) {
  const PickRange s = clipped(range, picks);
  state.next_pick = s.first < s.end ? std::clamp(pick, s.first, s.end - 1) : 0;
  state.waiting = false;
  state.at_tabby = false;
  state.shed = WeavingState::Shed::kUnknown;
  return state;
}

LoomReply reply_to(const WeavingSetup& w, const WeavingState& state, const LoomReport& report) {
  switch (report.kind) {
    case LoomReport::kPickWanted:
      // The request confirms that the pick on its way was woven; at the first request there is none.
      return raised(w, state.waiting ? advanced(state, w.range, w.lifts.rows(), w.tabby_between) : state);
    case LoomReport::kDirection: {
      WeavingState next_state = state;
      next_state.weaving = report.on;
      return {next_state, {}, {}};
    }
    case LoomReport::kShaftsRaised: {
      const std::optional<uint32_t> wanted = wanted_shafts(w, state);
      const bool other = state.waiting && wanted && *wanted != report.shafts;
      return {state, {}, other ? tr("the loom raised shafts other than those sent") : ""};
    }
    case LoomReport::kMotion:
      return {state, {}, {}};
    case LoomReport::kReady:
      return shafts_to_take(w, state, false);
    case LoomReport::kShedOpen:
      return shafts_to_take(w, state, true);
    case LoomReport::kShedClosed:
      return shed_closed(w, state);
    case LoomReport::kPasswordWanted:
      return {state, password_command(), {}};
    case LoomReport::kNegativeDobby:
      return {state, {}, tr("this loom has a negative dobby: it lowers the shafts that are sent; use a sinking shed")};
    case LoomReport::kUnknown:
      break;
  }
  return {state, {}, fill(tr("the loom sent an unknown message: {message}"), arg("message", report.text))};
}

LoomReply on_connected(const WeavingSetup& w, const WeavingState& state) {
  if (takes_picks_ahead(w.protocol)) return {state, greeting(w.protocol), {}};
  LoomReply first = state.waiting ? raised(w, state) : LoomReply{state, {}, {}};
  first.send.insert(0, direction_command(w.protocol, state.weaving));
  return first;
}

LoomReply sent_again(const WeavingSetup& w, const WeavingState& state) {
  return takes_picks_ahead(w.protocol) ? raised(w, state) : LoomReply{state, {}, {}};
}

LoomReply step_by_hand(const WeavingSetup& w, const WeavingState& state, bool forwards) {
  WeavingState next_state = state;
  next_state.weaving = forwards;
  const bool sent = takes_picks_ahead(w.protocol) ? state.shed != WeavingState::Shed::kUnknown : state.waiting;
  if (sent || !forwards) next_state = advanced(next_state, w.range, w.lifts.rows(), w.tabby_between);
  LoomReply next = raised(w, next_state);
  if (forwards != state.weaving) next.send.insert(0, direction_command(w.protocol, forwards));
  return next;
}

LoomReply insert_tabby(const WeavingSetup& w, const WeavingState& state, bool connected) {
  if (!tabby_sheds(w.draft))
    return {state, {}, tr("This threading has no tabby: odd and even ends share a shaft, or all are on the same ones")};
  WeavingState next_state = state;
  if (state.at_tabby) next_state.second_tabby = !state.second_tabby;
  next_state.at_tabby = true;
  next_state.weaving = true;
  next_state.waiting = false;
  if (!connected) return {next_state, {}, {}};
  LoomReply next = raised(w, next_state);
  if (!state.weaving) next.send.insert(0, direction_command(w.protocol, true));
  return next;
}

}  // namespace weftlight::loom
