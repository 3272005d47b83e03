#pragma once
// Floats of a drawdown. The drawdown repeats in both directions, so that a float may continue over the edge.

#include <vector>

#include "draft/drawdown.h"

namespace weftlight::analysis {

using draft::BitMatrix, draft::Face, draft::System;

/// Longest float, in threads crossed, of each system on each face.
struct LongestFloats {
  int warp_front = 0, warp_back = 0, weft_front = 0, weft_back = 0;
};
LongestFloats longest_floats(const BitMatrix& cells);

/// `thread` passes over `length` crossing threads from `first` on, cyclically.
struct Float {
  System system = System::kWarp;
  Face face = Face::kFront;
  int thread = 0, first = 0, length = 0;
  bool operator==(const Float&) const = default;
};

/// Longest float allowed, in threads, where the weaver says nothing else.
inline constexpr int kFloatLimit = 7;

/// Floats of more than `limit` threads.
struct LongFloats {
  int64_t count = 0;
  std::vector<Float> listed;  // longest first; floats of one length: warp before weft, front before back, by thread
};
/// Lists at most `most` of them.
LongFloats long_floats(const BitMatrix& cells, int limit, int most = 10000);

/// picks x ends: the crossings in a float of more than `limit` threads, of either system, on one face.
BitMatrix crossings_in_floats(const BitMatrix& cells, int limit, Face face);

}  // namespace weftlight::analysis
