#pragma once
// The repeat of a drawdown, and of a whole design.

#include "design/design.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using draft::BitMatrix;

/// Smallest period in ends and in picks (each divides the count, or is the count itself).
struct Repeat {
  int ends = 0, picks = 0;
};
/// Repeat of the weave alone.
Repeat structure_repeat(const BitMatrix& cells);
/// Repeat of weave, colours, yarns, spacing and thickness together: the tile of a texture.
Repeat design_repeat(const Design& design, const BitMatrix& cells);

/// Fraction of crossings with the warp on top, 0..1.
double warp_up_fraction(const BitMatrix& cells);

}  // namespace weftlight::design
