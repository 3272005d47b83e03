#pragma once
// The drawdown from threading and lifts: one bit per crossing, 1 where the warp is on top on the front face.

#include <vector>

#include "draft/draft.h"

namespace weftlight::draft {

enum class Face { kFront, kBack };

/// Half-open rectangle of cells.
struct CellRect {
  int end0 = 0, end1 = 0, pick0 = 0, pick1 = 0;
  bool empty() const { return end0 >= end1 || pick0 >= pick1; }
  bool operator==(const CellRect&) const = default;
};

/// The shafts each pick names, through tie-up and treadling or in the liftplan: picks x shafts.
BitMatrix lifts(const Draft& draft);

/// picks x ends. Rising shed: an end is up if any of its shafts is named. Sinking shed: it is up if it has a shaft and
/// none of its shafts is named. An end on no shaft is never up.
BitMatrix drawdown(const Draft& draft);

/// The columns of these ends: a row of picks for each. They cost these ends alone.
BitMatrix drawdown_columns(const Draft& draft, const std::vector<int>& ends);

/// Updates `cells` from the drawdown of `before` to that of `after`, recomputing only the rows and columns that
/// changed. Returns a rectangle with every changed cell; the whole cloth if the numbers of ends or picks differ.
CellRect update_drawdown(BitMatrix& cells, const Draft& before, const Draft& after);

/// The drawdown of the other face, in the same order of ends.
BitMatrix complement(const BitMatrix& cells);

}  // namespace weftlight::draft
