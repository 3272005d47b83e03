#pragma once
// The coloured drawdown as an image or as a vector drawing: each crossing has the colour of the thread on top.

#include <string>

#include "commands/commands.h"
#include "design/dye.h"
#include "draft/drawdown.h"

namespace weftlight::commands {

using design::Design;
using draft::BitMatrix;

/// The cells of a drawdown in the colours of the threads on top.
class ColoredCells {
 public:
  ColoredCells(const BitMatrix& cells, const Design& design, DrawdownOrigin origin)
      : cells_(cells), draft_(design.draft), dyed_(design), origin_(origin) {}
  const BitMatrix& cells() const { return cells_; }
  /// At a place of the picture, from its left and from its top.
  const draft::Rgb& at(int x, int y) const;

 private:
  const BitMatrix& cells_;
  const draft::Draft& draft_;
  design::DyedThreads dyed_;
  DrawdownOrigin origin_;
};

/// Writes a .png, .jpg or .tif, its longer side about 1,024 pixels.
base::Result<void> write_drawdown_image(const std::string& path, const ColoredCells& cells);
/// The point paper of a Jacquard loom: one pixel per crossing, black where the warp is on top, end 1 at the right and
/// pick 1 at the top.
base::Result<void> write_drawdown_points(const std::string& path, const BitMatrix& cells);
/// Writes a .svg or .pdf with 2 mm per crossing; less if a side would be longer than a metre.
base::Result<void> write_drawdown_drawing(const std::string& path, const ColoredCells& cells);

}  // namespace weftlight::commands
