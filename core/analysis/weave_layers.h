#pragma once
// Whether the cloth is connected, or falls apart into separate layers (double cloth) and loose threads.

#include <vector>

#include "draft/bit_matrix.h"

namespace weftlight::analysis {

using draft::BitMatrix;

/// Threads that cannot be separated without cutting. A layer of ends only or of picks only is a loose thread.
struct WeaveLayer {
  std::vector<int> ends, picks;
  bool loose() const { return ends.empty() || picks.empty(); }
  bool operator==(const WeaveLayer&) const = default;
};

/// The layers of a drawdown that repeats in both directions, front to back.
std::vector<WeaveLayer> weave_layers(const BitMatrix& cells);

}  // namespace weftlight::analysis
