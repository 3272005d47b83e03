#pragma once
// A drape before it falls, and the sewn ones.

#include "drape/fabric.h"
#include "drape/names.h"
#include "drape/solver.h"

namespace weftlight::drape {

struct Drape {
  Pattern pattern;
  Distance body;
  Fabric fabric;
  Fall fall;
  std::vector<uint32_t> held;  // particles held in place (or led)
  int iron_passes = 0;
  float lower_mm = 0;  // how far the finished drape is let down, to stand near the ground
};

/// Makes it fall on the dress form, as cloth that is worn: softer than a table's. Lets it down with the form.
void wear(Drape& drape);

/// Two flared panels, a quarter circle each, sewn at the sides, held at the waist.
Drape skirt();
/// Front, back and two sleeves, sewn at shoulders, sides and armholes.
Drape tunic();
/// Front, back, long sleeves in cuffs, a stand and a collar that falls over it; with placket, yoke, pocket and buttons.
Drape shirt();

}  // namespace weftlight::drape
