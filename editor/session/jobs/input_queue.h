#pragma once
// A queue of input events in their order, handed out frame by frame. However slow the frames are, no event is lost or
// overtakes another: text typed after a click goes to what the click opened.

#include <deque>
#include <string>
#include <vector>

namespace weftlight::session {

struct Modifiers {
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const Modifiers&) const = default;
};

struct InputEvent {
  enum class Kind { kMove, kButton, kScroll, kKey, kModifier, kCharacter };
  Kind kind;
  double x = 0, y = 0;     // pointer position in window units; scroll steps of a scroll
  unsigned code = 0;       // button, key, or Unicode character
  bool down = false;       // for a button, key or modifier
  Modifiers held = {};     // with a button, scroll or key
  std::string shortcut{};  // for a key press, as in menus: "Ctrl+Shift+S"
};

class InputQueue {
 public:
  void add(InputEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// As many waiting events as one frame can handle. Moves, scrolls and typed characters are combined; a button or a
  /// command (a key that types nothing) ends the frame; events that ImGui would reorder or lose wait. Call once per
  /// frame.
  std::vector<InputEvent> next_frame();

 private:
  struct Frame;
  bool fits(const Frame& frame) const;
  bool types() const;

  std::deque<InputEvent> waiting_;
  int frames_since_action_ = 1000;  // since a button or command
};

}  // namespace weftlight::session
