#pragma once
// Two drafts in one cloth: their ends in turn, their picks in turn, or both, one cloth on the other.

#include "base/result.h"
#include "design/design.h"

namespace weftlight::weaves {

using design::Design;

enum class JoinBy {
  kEnds,    // ends in turn; each pick weaves the pick of its number of both
  kPicks,   // picks in turn; each end is woven as the end of its number by the picks of each
  kLayers,  // ends and picks in turn: the first draft's cloth lies on the second's
};
struct Joining {
  JoinBy by = JoinBy::kEnds;
  int first = 1, second = 1;  // threads of each in turn, from 1
  bool operator==(const Joining&) const = default;
};

/// The drafts joined, as long as the one that lasts longer; the other repeats. Everything but the draft is the first's.
/// Shafts and treadles are numbered anew, by first use. Refused if there are too many threads, shafts or treadles.
base::Result<Design> joined_drafts(const Design& first, const Design& second, const Joining& joining);

}  // namespace weftlight::weaves
