#pragma once
// From a drawdown, or from lifts, back to what a loom is tied to: threading, tie-up and treadling within so
// many shafts and treadles. Where a number that the weaver gave still fits, it stays.

#include <optional>
#include <string>

#include "draft/draft.h"

namespace weftlight::draft {

struct LoomSize {
  int shafts = kMaxShafts, treadles = kMaxShafts;
  bool operator==(const LoomSize&) const = default;
};

/// A draft that weaves what was asked, or why the loom cannot.
struct Factored {
  Draft draft;                   // unless done(): as it was given, or (closest_drawdown) what comes nearest
  std::string why;               // "this takes 12 shafts, and there are 8"; empty: done
  int shafts = 0, treadles = 0;  // the fewest that would do; 0: not found out
  int64_t wrong = 0;             // crossings that `draft` shows otherwise (closest_drawdown)
  bool done() const { return why.empty(); }
};

/// `like` woven by `lifts` (picks x shafts). A liftplan is replaced; of a treadled draft each pick keeps its
/// treadle while that still fits, treadles that no pick needs any more are untied, and new ones are added up to
/// `most_treadles`. Shafts that no end hangs on count too.
Factored with_lifts(const Draft& like, const BitMatrix& lifts, int most_treadles);

/// `like` with the drawdown `cells` (picks x ends): ends that no longer weave as their shaft move to one that
/// does, to a free one, or to a new one, up to `most`; then as with_lifts.
Factored with_drawdown(const Draft& like, const BitMatrix& cells, LoomSize most);

/// The same with wrong crossings where the loom is too small: the columns (rows) that cost the fewest
/// crossings are woven as the most like of the others. Exact at each step, not over all steps.
Factored closest_drawdown(const Draft& like, const BitMatrix& cells, LoomSize most);

/// The same cloth on a loom of that size. The weaver's numbers stay where all of them fit.
Factored within_loom(const Draft& like, LoomSize most);

/// The fewest shafts and treadles (one a pick) of any draft with this drawdown: the distinct columns, and the
/// distinct rows with a thread to lift.
LoomSize fewest_for(const BitMatrix& cells);

/// Treadles that to_treadling would make: distinct lifts, but for the empty one.
int treadles_needed(const Draft& draft);

}  // namespace weftlight::draft
