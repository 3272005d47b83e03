#pragma once
// From threading and lifts to the drawdown: a bit a crossing, 1 where the warp is on
// top of the front face. Row by row from bitsets of the ends on each shaft.

#include "draft/draft.h"

namespace weftlight::draft {

enum class Face { kFront, kBack };

/// Half-open rectangle of cells.
struct CellRect {
  int end0 = 0, end1 = 0, pick0 = 0, pick1 = 0;
  bool empty() const { return end0 >= end1 || pick0 >= pick1; }
  bool operator==(const CellRect&) const = default;
};

/// Shafts that a pick names (through tie-up and treadling, or the liftplan): picks x shafts.
BitMatrix lifts(const Draft& draft);

/// picks x ends. Rising: up where any shaft of the end is named. Sinking: up where the end is on a
/// shaft and none of its shafts is named. An end on no shaft is never up.
BitMatrix drawdown(const Draft& draft);

/// Brings `cells` (the drawdown of `before`) to that of `after`, doing only the rows and columns that
/// changed. Returns a rectangle that holds every changed cell; the whole cloth when sizes differ.
CellRect update_drawdown(BitMatrix& cells, const Draft& before, const Draft& after);

/// The other face, in the same end order: the complement.
BitMatrix complement(const BitMatrix& cells);

}  // namespace weftlight::draft
