#include "session/input_queue.h"

#include <algorithm>
#include <utility>

namespace weftlight::session {
namespace {

using Kind = InputEvent::Kind;

/// Frames until a field that a click or a command opened takes characters: it appears in one, has the keys in
/// the next.
constexpr int kOpeningFrames = 2;
/// Frames until a field that a click or a command closed no longer takes the keys.
constexpr int kClosingFrames = 1;

}  // namespace

struct InputQueue::Frame {
  bool moved = false, scrolled = false, typed = false, ended = false;
  Modifiers held;                  // with the scroll
  std::vector<unsigned> released;  // keys
};

/// Whether the first event is a key that went down for a character: the window system says both at once.
bool InputQueue::types() const {
  return waiting_[0].kind == Kind::kKey && waiting_[0].down && waiting_.size() > 1 &&
         waiting_[1].kind == Kind::kCharacter;
}

bool InputQueue::fits(const Frame& f) const {
  const InputEvent& e = waiting_.front();
  if (e.kind == Kind::kModifier) return true;
  if (f.ended) return false;
  switch (e.kind) {
    case Kind::kMove:
      return !f.scrolled && !f.typed;
    // A drag must see where it ended before it is let go.
    case Kind::kButton:
      return !f.scrolled && !f.typed && (e.down || !f.moved);
    case Kind::kScroll:
      return !f.typed && (!f.scrolled || f.held == e.held);
    case Kind::kKey:
      if (!e.down) return true;
      if (types()) return frames_since_action_ > kOpeningFrames;
      // Up and down again in one frame would be a key held.
      return !f.scrolled && frames_since_action_ > kClosingFrames &&
             std::find(f.released.begin(), f.released.end(), e.code) == f.released.end();
    case Kind::kCharacter:
      return frames_since_action_ > kOpeningFrames;
    case Kind::kModifier:
      break;
  }
  return true;
}

std::vector<InputEvent> InputQueue::next_frame() {
  Frame f;
  std::vector<InputEvent> events;
  frames_since_action_ = std::min(frames_since_action_ + 1, kOpeningFrames + 1);
  while (!waiting_.empty() && fits(f)) {
    const InputEvent& e = waiting_.front();
    const bool command = e.kind == Kind::kKey && e.down && !types();
    f.moved |= e.kind == Kind::kMove;
    f.typed |= e.kind == Kind::kCharacter;
    if (e.kind == Kind::kScroll) {
      f.scrolled = true;
      f.held = e.held;
    }
    if (e.kind == Kind::kKey && !e.down) f.released.push_back(e.code);
    if (command || e.kind == Kind::kButton) {
      f.ended = true;
      frames_since_action_ = 0;
    }
    events.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return events;
}

}  // namespace weftlight::session
