#pragma once
// Threading, sleying and weaving the open draft at a loom, end by end, dent by dent and pick by pick. The design holds
// the places, so that the file keeps them; undo leaves them. The rest of the state lasts as long as the window.

#include <string>
#include <vector>

#include "design/design.h"
#include "loom/weaving.h"
#include "session/document/edit.h"

namespace weftlight::session {

using design::Design;
using draft::Draft;

enum class LoomWork { kThread, kSley, kWeave };

struct AtLoom {
  bool open = false;  // the window shows the loom
  LoomWork work = LoomWork::kWeave;
  loom::Protocol protocol = loom::Protocol::kPlain;
  loom::PickRange section;   // woven repeatedly; the whole draft if empty
  loom::WeavingState place;  // place_of() takes its next pick from the design
  std::string remark;        // what the loom reported that the weaver should check
  std::string to_send;       // to a loom that takes picks ahead, because the weaver went to another pick
};

/// The edit that a step makes, and the bytes to send to the loom.
struct LoomStep {
  MaybeEdit edit{};
  std::string send{};
};

/// The weaving state with the design's next pick, moved into the section, and its place between tabby picks.
loom::WeavingState place_of(const AtLoom& at, const Design& design);
/// A step forwards or back by key or click. Weaving with a loom (`connected`), the first step forwards raises the
/// shafts of the pick that is shown, and later steps those of the next pick; without one every step is a pick.
/// Threading and sleying, a step ticks off an end or a dent, or takes the last tick away.
LoomStep step_by_hand(AtLoom& at, const Design& design, bool forwards, bool connected);
/// A tabby pick before the pick that is shown, which comes back after it; at a tabby pick, its other shed. A remark if
/// the threading has no tabby.
LoomStep give_tabby(AtLoom& at, const Design& design, bool connected);
/// A tabby pick before every pattern pick from now on, or no more.
LoomStep put_tabby_between(AtLoom& at, const Design& design, bool on);
/// Handles a report of the loom.
LoomStep hear(AtLoom& at, const Design& design, const loom::LoomReport& report);
/// Called when the connection to the loom is made or restored.
LoomStep greet(AtLoom& at, const Design& design);
/// Continues from this pick, counted from 0.
LoomStep go_to_pick(AtLoom& at, const Design& design, int pick);
/// Continues from this end, dent or pick of the work that is shown, counted from 0.
LoomStep go_to(AtLoom& at, const Design& design, int number);
/// Weaves only these picks from now on, half-open from 0; all picks if the range is empty.
LoomStep keep_to_section(AtLoom& at, const Design& design, loom::PickRange section);

/// Treadles to press in a pick, or the shafts to lift if the draft has a liftplan; from 0.
std::vector<int> to_press(const Draft& draft, int pick);

/// What the loom holds: the ends of the planned cloth, for which the draft repeats or is cut off, at most kMaxThreads;
/// without the floating selvedges.
int ends_on_loom(const Design& design);
/// The dents that those ends fill, with empty ones between them, and one for each floating selvedge.
int dents_on_loom(const Design& design);
/// Of a dent: the ends in it, from 0.
struct DentEnds {
  int first = 0, count = 0;
  bool floating = false;  // a floating selvedge alone
};
DentEnds ends_in_dent(const Design& design, int dent);

}  // namespace weftlight::session
