#pragma once
// The repeat of a drawdown, and of all that makes a cloth look as it does.

#include "draft/design.h"
#include "draft/drawdown.h"

namespace weftlight::draft {

/// Smallest period in ends and in picks (each divides the count, or is the count itself).
struct Repeat {
  int ends = 0, picks = 0;
};
/// Of the structure alone.
Repeat structure_repeat(const BitMatrix& cells);
/// Of structure, colours, yarns, spacing and thickness together: the tile of a texture.
Repeat design_repeat(const Design& design, const BitMatrix& cells);

/// Share of crossings with the warp on top, 0..1.
double warp_up_fraction(const BitMatrix& cells);

}  // namespace weftlight::draft
