#pragma once
// Which edits belong together: those of one gesture of the hand are one step of undo, those of two are two, however
// soon the second follows the first.

#include <cstdint>

#include "session/names.h"

namespace weftlight::session {

class Strokes {
 public:
  /// Once a frame. `pressed`: a mouse button went down in it; `held`: one is down, or a control is being changed.
  void frame(bool pressed, bool held);
  bool going_on() const { return held_; }
  /// For History::commit: the gesture's number, or 0 between gestures.
  uint64_t now() const { return held_ ? number_ : 0; }

 private:
  uint64_t number_ = 0;
  bool held_ = false;
};

}  // namespace weftlight::session
