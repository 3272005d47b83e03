#pragma once
// How the cloth is seen: from where, draped or as a flat swatch.

#include "session/editing/orbit.h"

namespace weftlight::session {

struct ClothView {
  Orbit camera;
  bool flat = false;           // a flat swatch seen straight on instead of the drape
  bool grazing = false;        // grazing light on that swatch
  Orbit draped;                // the camera restored after the swatch
  bool true_distance = false;  // that swatch is as large on the screen as it looks from Settings::seen_from_m
};

}  // namespace weftlight::session
