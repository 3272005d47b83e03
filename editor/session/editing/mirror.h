#pragma once
// Symmetric drawing: strokes are mirrored across the ends, the picks or both, about the middle of the selection or else
// of the draft.

#include <optional>
#include <vector>

#include "session/editing/drawing_state.h"

namespace weftlight::session {

using draft::Draft, draft::Selection;

/// The axis as the index of a thread plus that of its image. Not mirrored if empty.
struct Mirror {
  std::optional<int> ends, picks;
};
Mirror mirror_of(const DrawingState& drawing, const Selection& selected, const Draft& draft);

/// The cell and its images, in a fixed order. Images may lie outside of the grid.
std::vector<Cell> images_of(const Mirror& mirror, GridId grid, Cell at);

}  // namespace weftlight::session
