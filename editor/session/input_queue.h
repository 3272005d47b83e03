#pragma once
// What the hand did, in its order, handed out frame by frame. However slow the frames are, nothing is lost and
// nothing overtakes: what is typed after a click goes to what the click opened.

#include <deque>
#include <string>
#include <vector>

#include "session/names.h"

namespace weftlight::session {

struct Modifiers {
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Modifiers&) const = default;
};

struct InputEvent {
  enum class Kind { kMove, kButton, kScroll, kKey, kModifier, kCharacter };
  Kind kind;
  double x = 0, y = 0;     // where the pointer was, in window units; of a scroll its steps
  unsigned code = 0;       // button, key, or Unicode character
  bool down = false;       // of a button, key or modifier
  Modifiers held = {};     // with a button, scroll or key
  std::string shortcut{};  // of a key that went down, as menus write it: "Ctrl+Shift+S"
};

class InputQueue {
 public:
  void add(InputEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// As many of the waiting events as one frame can tell apart: moves, scrolls and typed characters run
  /// together; a button or a command (a key that types nothing) ends the frame; what ImGui would see in another
  /// order, or not at all, waits. To be called once a frame.
  std::vector<InputEvent> next_frame();

 private:
  struct Frame;
  bool fits(const Frame& frame) const;
  bool types() const;

  std::deque<InputEvent> waiting_;
  int frames_since_action_ = 1000;  // a button or command
};

}  // namespace weftlight::session
