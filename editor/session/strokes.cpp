#include "session/strokes.h"

namespace weftlight::session {

void Strokes::frame(bool pressed, bool held) {
  // In a slow frame the next press may come before a frame in which nothing is held.
  if (pressed || (held && !held_)) ++number_;
  held_ = held || pressed;
}

}  // namespace weftlight::session
