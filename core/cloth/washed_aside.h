#pragma once
// How washing draws threads sideways. Where no thread of the other system passes between two neighbours, they slide
// together; where one does, it holds them apart, and takes the room that the others have left. So the ends of a huck
// lace gather in groups with holes between them, and the blocks of a deflected double weave become ovals.
//
// No source: the rule is our own. It moves no thread in a cloth whose threads touch, and none in plain weave, twills
// and satins, whose threads are all held alike.

#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

/// How far a thread moves at a crossing depends on the cells up to this many threads away.
inline constexpr int kAsideReach = 14;

/// Largest number of crossings of a cloth whose threads move: 8 bytes each, and as much for the other face.
inline constexpr int64_t kMaxAsideCrossings = int64_t{1} << 22;

/// Offsets of the threads at their crossings towards +across in mm, picks x ends as `up`; empty where none moves.
struct WashedAside {
  std::vector<float> warp_mm, weft_mm;
};

/// washed: 0 to 1. Of a cloth of one layer; a moved thread stays within half its spacing, and keeps off its neighbours.
WashedAside washed_aside(const Cloth& cloth, float washed);

/// The furthest that any thread of the cloth is moved, mm.
float furthest_aside(const Cloth& cloth);

}  // namespace weftlight::cloth
