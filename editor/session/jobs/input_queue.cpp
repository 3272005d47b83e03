#include "session/jobs/input_queue.h"

#include <algorithm>
#include <utility>

namespace weftlight::session {
namespace {

using Kind = InputEvent::Kind;

/// Frames until a field that a click or a command opened takes characters: it appears in one frame and has the keyboard
/// in the next.
constexpr int kOpeningFrames = 2;
/// Frames until a field that a click or a command closed no longer has the keyboard.
constexpr int kClosingFrames = 1;

}  // namespace

struct InputQueue::Frame {
  bool moved = false, scrolled = false, typed = false, ended = false;
  Modifiers held;                  // with the scroll
  std::vector<unsigned> released;  // keys
};

/// True if the first event is a key press that types a character: the window system reports both together.
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
    // A drag must see its last position before the release.
    case Kind::kButton:
      return !f.scrolled && !f.typed && (e.down || !f.moved);
    case Kind::kScroll:
      return !f.typed && (!f.scrolled || f.held == e.held);
    case Kind::kKey:
      if (!e.down) return true;
      if (types()) return frames_since_action_ > kOpeningFrames;
      // A release and a press in one frame would look like a held key.
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
