#pragma once
// Factors a drawdown, or lifts, into threading, tie-up and treadling within given numbers of shafts and treadles. The
// weaver's numbering of shafts and treadles is kept where it still fits.

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "draft/draft.h"

namespace weftlight::draft {

struct LoomSize {
  int shafts = kMaxShafts, treadles = kMaxShafts;
  bool operator==(const LoomSize&) const = default;
};

// The errors say why the loom cannot: "this needs 12 shafts, but the loom has 8".

/// Whether a loom of that size weaves this draft as it stands. A liftplan takes no treadles.
base::Result<void> fits(const Draft& draft, LoomSize most);

/// `base` with other lifts (picks x shafts). A liftplan is replaced. In a treadling each pick keeps its treadle where
/// that still fits, treadles that no pick uses any more are untied, and new ones are added up to `most_treadles`.
/// Shafts without ends count too.
base::Result<Draft> with_lifts(const Draft& base, const BitMatrix& lifts, int most_treadles);

/// `base` with the drawdown `cells` (picks x ends). Ends that no longer weave as their shaft move to a shaft that does,
/// to a free one, or to a new one, up to `most`; then as with_lifts.
base::Result<Draft> with_drawdown(const Draft& base, const BitMatrix& cells, LoomSize most);

/// The same for the drawdown of `base` with other columns of some ends: for each of `ends`, in ascending order, a row
/// of picks. It costs the shafts and these ends, not the whole drawdown.
base::Result<Draft> with_columns(const Draft& base, const std::vector<int>& ends, const BitMatrix& columns,
                                 LoomSize most);

/// A weave that the loom can make, close to the requested one.
struct ClosestDraft {
  Draft draft;
  base::Result<void> exact;  // or why the weaver's own shafts and treadles cannot weave the request
  int64_t wrong = 0;         // crossings that differ from the request
};
/// As with_drawdown, with wrong crossings if the loom is too small: greedily, the column (row) that costs the fewest
/// crossings is woven as the most similar other one. Each step is optimal, their sequence need not be. Takes up to
/// seconds; asked to stop, it soon returns some draft that the loom can weave, or `base`.
ClosestDraft closest_drawdown(const Draft& base, const BitMatrix& cells, LoomSize most,
                              const base::TaskProgress& progress = {});

/// The same cloth on a loom of that size. The weaver's numbering is kept if all of it fits.
base::Result<Draft> within_loom(const Draft& base, LoomSize most);

/// The draft without the treadles and shafts that went out of use since `before`: no pick (no end) uses them, and they
/// tie and lift nothing. Only those beyond `given`, which painting added; later ones move up. The drawdown stays the
/// same.
Draft without_spare(Draft draft, const Draft& before, LoomSize given);

/// The fewest shafts and treadles (one per pick) for this drawdown: its distinct columns, and its distinct rows other
/// than the empty one.
LoomSize fewest_for(const BitMatrix& cells);

/// Treadles that to_treadling would make: distinct lifts other than the empty one.
int treadles_needed(const Draft& draft);

}  // namespace weftlight::draft
