#pragma once
// Cloth of several layers that lie one on the other: double cloth, pockets, tubes. Which threads of a drawdown are of
// which layer, which layer lies above where, and how such a cloth is laid out.

#include <cstdint>
#include <vector>

#include "cloth/cloth.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// Which layer each thread is of. Where two layers change places (pockets) a thread keeps its own, and the layer is
/// above in some groups of threads and below in others.
struct LayerPlan {
  int layers = 1;
  std::vector<uint8_t> end_layer, pick_layer;
  // Two layers that change places or are stitched: threads in a group, and for each group, a row a pick's, whether
  // layer 0 lies above. Empty: each layer lies above the next everywhere.
  int group_ends = 1, group_picks = 1, groups = 0;  // groups: along a row
  std::vector<bool> first_above;

  /// Whether layer a lies above layer b at a crossing.
  bool above(int a, int b, int end, int pick) const;
};

/// The layers of a drawdown that repeats in both directions; one where it hangs together as a single cloth. Threads
/// come apart as a whole (analysis/weave_layers.h), or two layers interleave thread by thread (1:1, 2:2, 2:1) and are
/// stitched to each other, or change places, here and there.
LayerPlan find_layers(const BitMatrix& cells);

/// Puts a cloth's threads in the order of their layers and finds their levels, so that layers touch and threads do not
/// cut into each other but where two layers change places. The places of the threads are those in their layers.
/// `up` has the order of the draft; ends and picks, by layer, are those of the draft's threads in `ends_of`,
/// `picks_of`.
void put_in_layers(Cloth& cloth, const LayerPlan& plan, const std::vector<int>& end_order,
                   const std::vector<int>& pick_order);

/// Layer i as a cloth of its own, at its level; of a cloth in one layer, that.
Cloth one_layer(const Cloth& cloth, int i);

/// Each layer as a cloth of its own; none where there is one alone.
std::vector<Cloth> layers_apart(const Cloth& cloth);

inline int layer_count(const Cloth& cloth) { return cloth.layers.empty() ? 1 : static_cast<int>(cloth.layers.size()); }

/// The layer that is seen most on this face.
int front_layer(const Cloth& cloth);

/// The layer that a thread is of.
int layer_of(const Cloth& cloth, System system, int thread);

}  // namespace weftlight::cloth
