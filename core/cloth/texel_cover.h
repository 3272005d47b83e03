#pragma once
// Bit sets of changed texels, and few rectangles that cover them.

#include <vector>

#include "cloth/maps.h"
#include "draft/bit_matrix.h"

namespace weftlight::cloth {

using draft::BitMatrix;

/// Sets the bits [from, to) of a row.
void set_run(std::span<uint64_t> row, int from, int to);

/// Disjoint rectangles that cover every set bit. Greedy: a rectangle costs its area plus `overhead` texels.
std::vector<TexelRect> cover(const BitMatrix& mask, int overhead);

}  // namespace weftlight::cloth
