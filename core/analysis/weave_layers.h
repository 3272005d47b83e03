#pragma once
// Does the cloth hang together, or does it come apart into layers (double cloth) and loose threads?

#include <vector>

#include "analysis/names.h"
#include "draft/bit_matrix.h"

namespace weftlight::analysis {

/// Threads that cannot be parted without cutting. One end alone or one pick alone is a loose thread.
struct Layer {
  std::vector<int> ends, picks;
  bool loose() const { return ends.empty() || picks.empty(); }
  bool operator==(const Layer&) const = default;
};

/// The layers of a drawdown that repeats in both directions, front to back.
std::vector<Layer> layers(const BitMatrix& cells);

}  // namespace weftlight::analysis
