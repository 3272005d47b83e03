#pragma once
// Which particles of a cloth come close to others that are not near along the cloth.

#include "drape/fabric.h"
#include "drape/names.h"

namespace weftlight::drape {

struct Pair {
  uint32_t a, b;  // a < b
};

/// All pairs closer than reach_mm, near ones left out, in a fixed order.
void find_pairs(const Cloth& cloth, double reach_mm, std::vector<Pair>& pairs);

}  // namespace weftlight::drape
