#pragma once
// Which texels a change touches, a bit each, and few rectangles that hold them.

#include <vector>

#include "cloth/maps.h"
#include "cloth/names.h"
#include "draft/bit_matrix.h"

namespace weftlight::cloth {

/// Sets the bits [from, to) of a row.
void set_run(std::span<uint64_t> row, int from, int to);

/// Rectangles that do not overlap and hold every set bit. Greedy: a rectangle costs its area and
/// `overhead` texels.
std::vector<TexelRect> cover(const BitMatrix& mask, int overhead);

}  // namespace weftlight::cloth
