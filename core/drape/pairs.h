#pragma once
// Finds particles that are close in space but not along the cloth.

#include "drape/fabric.h"

namespace weftlight::drape {

struct ParticlePair {
  uint32_t a, b;  // a < b
};

/// All pairs closer than reach_mm that are not neighbours along the cloth, in a fixed order.
void find_pairs(const SimulatedCloth& cloth, double reach_mm, std::vector<ParticlePair>& pairs);

}  // namespace weftlight::drape
