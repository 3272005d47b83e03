#pragma once
// The handle of a cloth: its weight and bending stiffness, computed from its yarns and its sett alone.

#include "design/design.h"

namespace weftlight::analysis {

using design::Design;

/// Bending stiffness is the geometric mean of warp and weft, per metre of width.
///
/// Based on: the bending of a yarn whose fibres slide freely, N E I, and of one whose fibres are bound, N^2 E I (S.
/// Backer 1952; J. D. Owen, G. Livesey 1964: cloth lies between); the geometric mean of both, times kCohesion, less
/// for filament without twist. E of fibres in bending: W. E. Morton, J. W. S. Hearle, Physical Properties of Textile
/// Fibres, ch. 17 (flax: a value in between, as its ultimates are kinked). The twist of crepe yarns contracts the
/// cloth and does not bind the fibres. Bending length, (B / (w g))^(1/3): F. T. Peirce 1930, The "handle" of cloth as a
/// measurable quantity.
struct ClothHandle {
  double kg_per_m2 = 0;
  double bending_n_m = 0;
  double bending_length_mm = 0;
  double thickness_mm = 0;  // of two crossing threads, flattened as their yarns are
};
/// All 0 for a draft without threads.
ClothHandle cloth_handle(const Design& design);

}  // namespace weftlight::analysis
