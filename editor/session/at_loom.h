#pragma once
// Weaving the open draft at a loom, pick by pick. The next pick stands in the design, so that it is kept with the file;
// what else is known of the place lasts as long as the window.

#include <cstdint>
#include <string>
#include <vector>

#include "draft/design.h"
#include "loom/weaving.h"
#include "session/edit.h"
#include "session/names.h"

namespace weftlight::session {

struct AtLoom {
  bool open = false;  // the window shows the loom
  loom::Protocol protocol = loom::Protocol::kPlain;
  loom::PickRange section;   // woven over and over; empty: the whole draft
  loom::WeavingState place;  // its next pick is the design's (place_of)
  std::string remark;        // of the loom, to be looked into
  uint64_t session = 0;      // joins the steps of one sitting to one step of undo
};

/// What a step makes of the design, and the bytes that the loom is to get.
struct LoomStep {
  MaybeEdit edit{};
  std::string send{};
};

/// The place, with the next pick of the design, brought into the section.
loom::WeavingState place_of(const AtLoom& at, const Design& design);
/// By key or click: on, or back. With a loom on the line (`connected`) the first step on raises the shafts of the pick
/// that is shown, and each after it those of the next; without one, every step is a pick.
LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected);
/// Something that the loom said.
LoomStep hear(AtLoom& at, const Design& design, const loom::LoomReport& report);
/// The line to the loom stands (again).
LoomStep greet(AtLoom& at, const Design& design);
/// Goes on from this pick, from 0.
LoomStep go_to_pick(AtLoom& at, const Design& design, int pick);
/// Only these picks from now on, half-open from 0; all where there are none.
LoomStep keep_to_section(AtLoom& at, const Design& design, loom::PickRange section);

/// Treadles to press in a pick, or shafts to lift by hand where there are none; from 0.
std::vector<int> to_press(const Draft& draft, int pick);

}  // namespace weftlight::session
