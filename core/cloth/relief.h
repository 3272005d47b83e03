#pragma once
// Relief of a washed cloth. Washed threads shrink and draw their floats in: where both faces differ in their floats,
// the cloth bulges towards the face that has the longer ones. So the frames of a waffle weave rise and its squares
// sink, the pattern blocks of an overshot stand over the tabby. Twills and satins, whose floats are as long on both
// faces of a crossing, stay flat, and so do
// baskets and ribs.
//
// No source: the rule is our own, its size by eye beside washed waffles, whose cells are about a third as deep as wide.

#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

/// A crossing's relief depends on the cells up to this many threads away.
inline constexpr int kReliefReach = 9;

/// Height of each crossing over the middle plane in mm, picks x ends as `up`; empty where the cloth stays flat: one of
/// several layers, without shrinkage, or of more than kMaxReliefCrossings crossings. washed: 0 to 1;
/// shrinkage: mean of both systems, a fraction.
std::vector<float> washed_relief(const Cloth& cloth, float washed, float shrinkage);

/// 2048 x 2048: the relief takes 16 bytes a crossing, of both faces.
inline constexpr int64_t kMaxReliefCrossings = int64_t{1} << 22;

}  // namespace weftlight::cloth
