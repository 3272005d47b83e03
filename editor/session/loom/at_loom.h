#pragma once
// Weaving the open draft at a loom, pick by pick. The design holds the next pick, so that the file keeps it; the rest
// of the weaving state lasts as long as the window.

#include <cstdint>
#include <string>
#include <vector>

#include "design/design.h"
#include "loom/weaving.h"
#include "session/document/edit.h"

namespace weftlight::session {

using design::Design;
using draft::Draft;

struct AtLoom {
  bool open = false;  // the window shows the loom
  loom::Protocol protocol = loom::Protocol::kPlain;
  loom::PickRange section;   // woven repeatedly; the whole draft if empty
  loom::WeavingState place;  // place_of() takes its next pick from the design
  std::string remark;        // what the loom reported that the weaver should check
  uint64_t session = 0;      // the picks of one session are one step of undo
};

/// The edit that a step makes, and the bytes to send to the loom.
struct LoomStep {
  MaybeEdit edit{};
  std::string send{};
};

/// The weaving state with the design's next pick, moved into the section.
loom::WeavingState place_of(const AtLoom& at, const Design& design);
/// A step forwards or back by key or click. With a loom (`connected`) the first step forwards raises the shafts of the
/// pick that is shown, and later steps those of the next pick; without one every step is a pick.
LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected);
/// Handles a report of the loom.
LoomStep hear(AtLoom& at, const Design& design, const loom::LoomReport& report);
/// Called when the connection to the loom is made or restored.
LoomStep greet(AtLoom& at, const Design& design);
/// Continues from this pick, counted from 0.
LoomStep go_to_pick(AtLoom& at, const Design& design, int pick);
/// Weaves only these picks from now on, half-open from 0; all picks if the range is empty.
LoomStep keep_to_section(AtLoom& at, const Design& design, loom::PickRange section);

/// Treadles to press in a pick, or the shafts to lift if the draft has a liftplan; from 0.
std::vector<int> to_press(const Draft& draft, int pick);

}  // namespace weftlight::session
