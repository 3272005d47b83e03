#pragma once
// The symmetric pen: what is drawn appears mirrored across the ends, the picks or both, about the middle of what is
// selected there, else of the draft.

#include <optional>
#include <vector>

#include "session/document_view.h"
#include "session/names.h"

namespace weftlight::session {

/// Index of a thread plus that of its image: the axis, in half threads. None: not mirrored.
struct Mirror {
  std::optional<int> ends, picks;
};
Mirror mirror_of(const DocumentView& view, const Draft& draft);

/// The grid's columns are ends; its rows are picks.
bool has_ends(GridId grid);
bool has_picks(GridId grid);

/// The cell, and its images as far as the grid has them, always in the same order. Some may lie outside of the grid.
std::vector<Cell> images_of(const Mirror& mirror, GridId grid, Cell at);

}  // namespace weftlight::session
