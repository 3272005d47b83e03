#pragma once
// What a cloth is like in the hand: how heavy it is and how stiffly it bends, from its yarns and its sett alone.

#include "analysis/names.h"
#include "draft/design.h"

namespace weftlight::analysis {

/// Bending is the mean (geometric) of both systems', for a strip a metre wide.
///
/// Based on: the bending of a yarn whose fibres slide freely, N E I, and of one whose fibres are bound, N^2 E I (S.
/// Backer 1952; J. D. Owen, G. Livesey 1964: cloth lies between); the geometric mean of both, times kCohesion, less
/// for filament without twist. E of fibres in bending: W. E. Morton, J. W. S. Hearle, Physical Properties of Textile
/// Fibres, ch. 17 (an E in between for flax, whose ultimates are kinked). Crepe yarns, by their twist, contract the
/// cloth and bind nothing. Bending length, (B / (w g))^(1/3): F. T. Peirce 1930, The "handle" of cloth as a measurable
/// quantity.
struct ClothHandle {
  double kg_per_m2 = 0;
  double bending_n_m = 0;
  double bending_length_mm = 0;
  double thickness_mm = 0;  // of two threads that cross, pressed as their yarns are
};
/// All 0 of a draft without threads.
ClothHandle cloth_handle(const Design& design);

}  // namespace weftlight::analysis
