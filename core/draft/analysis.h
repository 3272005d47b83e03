#pragma once
// What a weaver wants to know of a drawdown: floats and repeats. The cloth is taken to
// repeat in both directions, so that a float may run over the edge.

#include "draft/design.h"
#include "draft/drawdown.h"

namespace weftlight::draft {

/// Longest float, in threads crossed, of each system on each face.
struct LongestFloats {
  int warp_front = 0, warp_back = 0, weft_front = 0, weft_back = 0;
};
LongestFloats longest_floats(const BitMatrix& cells);

/// Smallest period in ends and in picks (each divides the count, or is the count itself).
struct Repeat {
  int ends = 0, picks = 0;
};
/// Of the structure alone.
Repeat structure_repeat(const BitMatrix& cells);
/// Of structure, colours, yarns, spacing and thickness together: the tile of a texture.
Repeat design_repeat(const Design& design, const BitMatrix& cells);

/// Share of crossings with the warp on top, 0..1.
double warp_up_share(const BitMatrix& cells);

}  // namespace weftlight::draft
