#pragma once
// Weaving a draft at a loom: which pick is next, what is sent, and how the place is kept when the line breaks off.

#include <string>
#include <vector>

#include "loom/protocol.h"

namespace weftlight::loom {

/// The picks that are woven, over and over: all of them, or a section.
struct Section {
  int first = 0, end = 0;  // half-open; empty: the whole draft
};

/// The place at the loom. A pick counts as woven when the loom asks for the next one; what was sent but not
/// confirmed is sent again, so that a line that broke off loses no place.
struct Place {
  int next_pick = 0;     // that the loom is to weave next
  int64_t woven = 0;     // picks since the beginning, less those taken back
  bool weaving = true;   // false: unweaving
  bool waiting = false;  // its shafts are up, or on their way
  bool operator==(const Place&) const = default;
};

/// One step on (or back): the place after a pick of `section` was woven.
Place stepped(Place place, const Section& section, int picks);
/// Brought into the section, with nothing on its way.
Place jumped(Place place, const Section& section, int picks, int pick);

/// What to send and the place after something that the loom said.
struct Answer {
  Place place;
  std::string send;
  std::string remark;  // what a person should know
};
struct Weaving {
  const Draft& draft;
  const BitMatrix& lifts;  // of the draft
  Section section;
  Protocol protocol = Protocol::kPlain;
};
Answer answer(const Weaving& weaving, const Place& place, const LoomReport& report);
/// What to send when a line is made (again): the direction, and the shafts of a pick that was on its way.
Answer on_connected(const Weaving& weaving, const Place& place);
/// A step by key or click, as if the loom had asked: for a Toika, or a loom that is trodden by foot.
Answer step_by_hand(const Weaving& weaving, const Place& place, bool forwards);

}  // namespace weftlight::loom
