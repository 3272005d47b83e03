#pragma once
// A drape before it is simulated, and the sewn garments.

#include "drape/fabric.h"
#include "drape/solver.h"

namespace weftlight::drape {

struct Drape {
  Pattern pattern;
  Distance body;
  Fabric fabric;
  Fall fall;
  std::vector<uint32_t> held;  // particles that are held in place, or moved by Fall::move_held
  int smoothing_passes = 0;
  float lower_mm = 0;  // how far the finished drape is lowered, so that it stands near the ground
};

/// Sets the dress form as the body and a fabric for clothes, which is softer than that of a tablecloth.
void put_on_form(Drape& drape);

/// Two flared panels, a quarter circle each, sewn at the sides, held at the waist.
Drape skirt();
/// Front, back and two sleeves, sewn at shoulders, sides and armholes.
Drape tunic();
/// Front, back, long sleeves with cuffs, a collar stand and a collar; with placket, yoke, pocket and buttons.
Drape shirt();

}  // namespace weftlight::drape
