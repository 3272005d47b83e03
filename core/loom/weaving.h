#pragma once
// Weaving a draft at a loom: which pick is next, what is sent, and how the state is kept when the line breaks off.

#include <string>
#include <vector>

#include "loom/protocol.h"

namespace weftlight::loom {

/// The picks that are woven, over and over: all of them, or a section.
struct PickRange {
  int first = 0, end = 0;  // half-open; empty: the whole draft
};

/// The state at the loom. A pick counts as woven when the loom asks for the next one; what was sent but not
/// confirmed is sent again, so that a line that broke off loses no state.
struct WeavingState {
  int next_pick = 0;     // that the loom is to weave next
  int64_t woven = 0;     // picks since the beginning, less those taken back
  bool weaving = true;   // false: unweaving
  bool waiting = false;  // its shafts are up, or on their way
  bool operator==(const WeavingState&) const = default;
};

/// One step on (or back): the state after a pick of `section` was woven.
WeavingState advanced(WeavingState state, const PickRange& section, int picks);
/// Brought into the section, with nothing on its way.
WeavingState moved_to_pick(WeavingState state, const PickRange& section, int picks, int pick);

/// What to send and the state after something that the loom said.
struct LoomReply {
  WeavingState state;
  std::string send;
  std::string remark;  // what a person should know
};
struct WeavingSetup {
  const Draft& draft;
  const BitMatrix& lifts;  // of the draft
  PickRange section;
  Protocol protocol = Protocol::kPlain;
};
LoomReply reply_to(const WeavingSetup& weaving, const WeavingState& state, const LoomReport& report);
/// What to send when a line is made (again): the direction, and the shafts of a pick that was on its way.
LoomReply on_connected(const WeavingSetup& weaving, const WeavingState& state);
/// A step by key or click, as if the loom had asked: for a Toika, or a loom that is trodden by foot.
LoomReply step_by_hand(const WeavingSetup& weaving, const WeavingState& state, bool forwards);

}  // namespace weftlight::loom
