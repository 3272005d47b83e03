#pragma once
// The grids under a pressed mouse button: they stand where they stood when it went down, whatever an edit adds to the
// draft, the zoom or the window changes meanwhile. So a press is one cell, and a stroke goes on where the hand goes.

#include <optional>

#include "views/common/names.h"
#include "views/draft/draft_layout.h"

namespace weftlight::views {

/// Where the hand is: the pointer, but while a button is down and it has not left the pixels about the press, the
/// press.
ImVec2 hand_at(const Style& style);

class HeldLayout {
 public:
  /// The layout of this frame: `now` as the draft would be laid out, or its cells where they were pressed. `down`: a
  /// mouse button is.
  DraftLayout of(const DraftLayout& now, const DocumentView& view, bool down);
  /// A button is down over a grid: it stands like this until all are let go.
  void hold(const DraftLayout& layout, const DocumentView& view);
  /// The hand itself scrolls: the view's scroll counts in the next frame.
  void let_scroll() { scrolls_ = true; }
  bool is_held() const { return held_.has_value(); }

 private:
  std::optional<DraftLayout> held_;
  const DocumentView* view_ = nullptr;  // that it is of
  bool scrolls_ = false;
};

}  // namespace weftlight::views
