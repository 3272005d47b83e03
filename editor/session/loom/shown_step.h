#pragma once
// The step that a weaver does next at the loom, in words and colours: for the loom view and the page in the local
// network alike.

#include <optional>
#include <string>
#include <vector>

#include "session/loom/at_loom.h"
#include "session/loom/thread_groups.h"

namespace weftlight::session {

struct ShownColor {
  draft::Rgb color;
  std::string text;
};

struct ShownStep {
  LoomWork work = LoomWork::kWeave;
  std::string heading;       // "Pick", "Tabby before pick", "End", "Dent"
  int number = 0, of = 0;    // from 1; `number` is of + 1 when all is done, and `of` 0 when there is nothing to do
  std::string what;          // "Treadle 3 + 5", "Shaft 4", "Ends 23 and 24"
  std::string group;         // "Section 3 of 12: end 5 of 16"; may be empty
  std::vector<bool> shafts;  // those that rise, or that the end is on; empty where there are none to show
  std::optional<ShownColor> color, next_color;
  bool tabby = false;
  std::string progress;  // "Woven: 12 picks"
  bool done() const { return number > of; }
};

/// The step as it is said aloud: "Pick 12. Treadle 3 + 5".
std::string words_of(const ShownStep& step);

/// What a design is counted by; as long as it is the same design.
struct LoomGroups {
  std::vector<ThreadGroup> ends, picks;
};
LoomGroups loom_groups(const Design& design);

/// `lifts`: of the design's draft.
ShownStep shown_step(const AtLoom& at, const Design& design, const draft::BitMatrix& lifts, const LoomGroups& groups);

/// What to press or lift for a pick: "Treadle 3 + 5", "Lift 1 + 2 + 4", "Lift nothing".
std::string press_text(const Draft& draft, int pick);

}  // namespace weftlight::session
