#pragma once
// What programs that simulate garments need to know of a cloth, computed from its yarns and sett.

#include "design/design.h"

namespace weftlight::files {

struct FabricPhysics {
  // core/analysis/handle.h
  double kg_per_m2 = 0, thickness_mm = 0;
  double bending_n_m = 0;        // stiffness for each metre of width, geometric mean of warp and weft
  double bending_length_mm = 0;  // Peirce
  // As our own drapes are simulated (core/drape/stiffness.h): the same for all cloth along the threads, by the bending
  // length along the bias.
  double stretch_n_per_m = 0, bias_n_per_m = 0;
};
/// Zeros for a draft without threads.
FabricPhysics fabric_physics(const design::Design& design);

}  // namespace weftlight::files
