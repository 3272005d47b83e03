#pragma once
// Numbers the gestures: the edits of one gesture are one undo step, those of two are two, however close in time.

#include <cstdint>

namespace weftlight::session {

class Strokes {
 public:
  /// Call once per frame. `pressed`: a mouse button went down; `held`: one is down, or a control is being changed.
  void frame(bool pressed, bool held);
  bool going_on() const { return held_; }
  /// The number of the gesture for History::commit; 0 between gestures.
  uint64_t now() const { return held_ ? number_ : 0; }

 private:
  uint64_t number_ = 0;
  bool held_ = false;
};

}  // namespace weftlight::session
