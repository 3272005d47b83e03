#pragma once
// The drawdown as pixels, for cells too small to draw one by one: every pixel is the mean colour of the
// crossings it covers.

#include <cstdint>
#include <vector>

#include "ui/axis.h"
#include "views/common/names.h"
#include "views/common/panel.h"

namespace weftlight::views {

/// Colour of every thread of a system, as ImGui packs it.
std::vector<ImU32> thread_colors(const Draft& draft, System system);

/// True where the warp is seen on the given face.
inline bool warp_on_top(const BitMatrix& cells, Face face, int end, int pick) {
  return cells.get(pick, end) == (face == Face::kFront);
}

struct CellImage {
  int width = 0, height = 0;
  std::vector<ImU32> pixels;  // row 0 on top
};

/// What the panes of the two axes show, a pixel a pixel. kStructure: ink where the warp is on top. `tiled`: the
/// drawdown goes on beyond its edges, over and over.
CellImage cell_image(const Draft& draft, const BitMatrix& cells, Face face, DrawdownStyle look, const Colors& colors,
                     const Axis& ends, const Axis& picks, bool tiled = false);

}  // namespace weftlight::views
