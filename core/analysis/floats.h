#pragma once
// Floats of a drawdown that repeats in both directions, so that a float may run over the edge.

#include <vector>

#include "analysis/names.h"
#include "draft/drawdown.h"

namespace weftlight::analysis {

/// Longest float, in threads crossed, of each system on each face.
struct LongestFloats {
  int warp_front = 0, warp_back = 0, weft_front = 0, weft_back = 0;
};
LongestFloats longest_floats(const BitMatrix& cells);

/// A thread that lies free over `length` crossing threads from `first` on, round the edge if need be.
struct Float {
  System system = System::kWarp;
  Face face = Face::kFront;
  int thread = 0, first = 0, length = 0;
  bool operator==(const Float&) const = default;
};

/// Floats of more than `limit` threads.
struct LongFloats {
  int64_t count = 0;
  std::vector<Float> listed;  // the longest first; of equals warp before weft, front before back, by thread
};
/// Lists at most `most` of them.
LongFloats long_floats(const BitMatrix& cells, int limit, int most = 10000);

/// picks x ends: the crossings that lie in a float of more than `limit` threads of either system, on one face.
BitMatrix crossings_in_floats(const BitMatrix& cells, int limit, Face face);

}  // namespace weftlight::analysis
