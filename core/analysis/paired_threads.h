#pragma once
// Weaves whose threads take turns: two warps, two wefts or two cloths of every other thread. For weave_family().

#include "draft/bit_matrix.h"

namespace weftlight::analysis {

using draft::BitMatrix;

/// Whether every other thread follows a line that the threads between them follow too, some shafts apart: echo weave
/// and jin; or in blocks with the threads between opposite to it: shadow weave. One thread a row, which repeats.
bool is_parallel(const BitMatrix& threads);

/// Whether the threads go in pairs that cross alike over every other thread of the other system, which binds them, and
/// opposite to each other over the rest: taquete and samitum, where one of each pair is on the face. One thread a row.
bool is_compound(const BitMatrix& threads);

/// Whether stripes of plain weave cross under and over stripes of threads that do not bind with them: deflected double
/// weave. Picks x ends.
bool is_deflected(const BitMatrix& cells);

/// Whether every other end and pick make one cloth and the rest another, with a few crossings between them: stitched
/// double cloth. Picks x ends.
bool is_stitched(const BitMatrix& cells);

/// Every other thread of both systems.
BitMatrix every_other(const BitMatrix& cells, int first_pick, int first_end);

/// The fractions of cells amid eight others that cross alike, on top and underneath.
struct SolidShare {
  double up = 0, down = 0;
};
SolidShare share_of_solid(const BitMatrix& cells);

/// The fraction of cells whose four neighbours all cross the other way.
double share_of_plain(const BitMatrix& cells);

}  // namespace weftlight::analysis
