#pragma once
// The layers of a cloth that is laid out (layer_plan.h).

#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

using draft::System;

/// Layer i as a cloth of its own, at its level; a single-layer cloth is returned as it is.
Cloth one_layer(const Cloth& cloth, int i);

/// Each layer as a cloth of its own; empty for a single layer.
std::vector<Cloth> layers_apart(const Cloth& cloth);

inline int layer_count(const Cloth& cloth) { return cloth.layers.empty() ? 1 : static_cast<int>(cloth.layers.size()); }

/// The layer that is most visible on this face.
int front_layer(const Cloth& cloth);

int layer_of(const Cloth& cloth, System system, int thread);

}  // namespace weftlight::cloth
