#pragma once
// How the cloth is seen: from where, draped or as a flat swatch.

#include "session/editing/orbit.h"

namespace weftlight::session {

struct ClothView {
  Orbit camera;
  bool flat = false;     // a flat swatch seen straight on instead of the drape
  bool grazing = false;  // grazing light on that swatch
  Orbit draped;          // the camera restored after the swatch
};

}  // namespace weftlight::session
