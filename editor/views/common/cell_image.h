#pragma once
// The drawdown as an image, for cells too small to draw one by one. Each pixel is the mean colour of the crossings that
// it covers.

#include <cstdint>
#include <vector>

#include "ui/axis.h"
#include "views/common/crossing_colors.h"
#include "views/common/panel.h"

namespace weftlight::views {

using draft::BitMatrix, draft::Draft, draft::Face, draft::System;
using session::DrawdownStyle;
using ui::Axis, ui::Colors;

/// True where the warp is on top on the given face.
inline bool warp_on_top(const BitMatrix& cells, Face face, int end, int pick) {
  return cells.get(pick, end) == (face == Face::kFront);
}

struct CellImage {
  int width = 0, height = 0;
  std::vector<ImU32> pixels;  // row 0 on top
};

/// One pixel per pixel of the panes of the two axes. kStructure: ink where the warp is on top. `tiled`: the drawdown
/// repeats beyond its edges.
CellImage cell_image(const design::Design& design, const BitMatrix& cells, Face face, DrawdownStyle style,
                     const Colors& colors, const Axis& ends, const Axis& picks, bool tiled = false);

}  // namespace weftlight::views
