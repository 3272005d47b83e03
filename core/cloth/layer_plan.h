#pragma once
// Multi-layer cloth: double cloth, pockets, tubes. Finds the layer of each thread and which layer lies above where,
// and lays such a cloth out.

#include <cstdint>
#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

using draft::BitMatrix, draft::System;

/// The layer of each thread. Where two layers change places (pockets) a thread keeps its layer, which is above in some
/// groups of threads and below in others.
struct LayerPlan {
  int layers = 1;
  std::vector<uint8_t> end_layer, pick_layer;
  // For two layers that change places or are stitched: threads in a group, and for each group (row by row of picks)
  // whether layer 0 lies above. Empty: each layer lies above the next everywhere.
  int group_ends = 1, group_picks = 1, groups = 0;  // groups: along a row
  std::vector<bool> first_above;

  /// Whether layer a lies above layer b at a crossing.
  bool above(int a, int b, int end, int pick) const;
};

/// Layers of a drawdown that repeats in both directions; one if it is a single connected cloth. Either the layers are
/// not connected at all (analysis/weave_layers.h), or two layers interleave thread by thread (1:1, 2:2, 2:1) and are
/// stitched or change places.
LayerPlan find_layers(const BitMatrix& cells);

/// Orders the threads of a cloth by layer and computes levels at which layers touch without intersecting, except where
/// two layers change places. On entry `up` is in the draft's order; ends and picks are already ordered by layer, as
/// `end_order` and `pick_order` say.
void put_in_layers(Cloth& cloth, const LayerPlan& plan, const std::vector<int>& end_order,
                   const std::vector<int>& pick_order);

}  // namespace weftlight::cloth
