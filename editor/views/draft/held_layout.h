#pragma once
// Freezes the layout of the grids while a mouse button is down, whatever an edit, the zoom or the window size changes
// meanwhile, and until the pointer moves on. So a click is one cell, a second click undoes the first, and a stroke
// follows the pointer.

#include <optional>

#include "views/draft/draft_layout.h"

namespace weftlight::views {

using session::DraftView;
using ui::Style;

/// The pointer; while a button is down and the pointer stays within a few pixels, the point where it went down.
ImVec2 hand_at(const Style& style);

/// What the hand does in this frame.
struct Hand {
  bool down = false;  // with a mouse button
  bool moves = true;  // the pointer or the wheel, or it presses a key
  ImVec2 window{};    // the size of the window
};
Hand hand_of_frame();

class HeldLayout {
 public:
  /// The layout of this frame: `now`, or the held layout while one is held.
  DraftLayout of(const DraftLayout& now, const DraftView& view, Hand hand);
  /// A button went down over a grid: holds the layout until all buttons are released and the hand moves, or
  /// the window changes its size.
  void hold(const DraftLayout& layout, const DraftView& view);
  /// The user scrolls during the press: the next frame uses the view's scroll.
  void let_scroll() { scrolls_ = true; }
  bool is_held() const { return held_.has_value(); }

 private:
  std::optional<DraftLayout> held_;
  const DraftView* view_ = nullptr;  // of the held layout
  ImVec2 window_;                    // of the last frame
  bool scrolls_ = false;
};

}  // namespace weftlight::views
