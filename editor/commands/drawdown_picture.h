#pragma once
// The coloured drawdown as an image or as a vector drawing: each crossing has the colour of the thread on top.

#include <string>

#include "commands/commands.h"
#include "draft/drawdown.h"

namespace weftlight::commands {

using draft::BitMatrix, draft::Draft;

/// The colour of the thread on top at a place of the picture, from its left and from its top.
const draft::Rgb& color_on_top(const BitMatrix& cells, const Draft& draft, DrawdownOrigin origin, int x, int y);
/// Writes a .png, .jpg or .tif, its longer side about 1,024 pixels.
base::Result<void> write_drawdown_image(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                        DrawdownOrigin origin);
/// The point paper of a Jacquard loom: one pixel per crossing, black where the warp is on top, end 1 at the right and
/// pick 1 at the top.
base::Result<void> write_drawdown_points(const std::string& path, const BitMatrix& cells);
/// Writes a .svg or .pdf with 2 mm per crossing; less if a side would be longer than a metre.
base::Result<void> write_drawdown_drawing(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                          DrawdownOrigin origin);

}  // namespace weftlight::commands
