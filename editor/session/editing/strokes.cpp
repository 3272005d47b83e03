#include "session/editing/strokes.h"

namespace weftlight::session {

void Strokes::frame(bool pressed, bool held) {
  // With slow frames the next press may come before any frame without a held button.
  if (pressed || (held && !held_)) ++number_;
  held_ = held || pressed;
}

}  // namespace weftlight::session
