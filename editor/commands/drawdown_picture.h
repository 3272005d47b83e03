#pragma once
// The coloured drawdown as an image or as a drawing: each crossing in the colour of the thread on top.

#include <string>

#include "commands/commands.h"
#include "commands/names.h"
#include "draft/drawdown.h"

namespace weftlight::commands {

/// Into a .png, .jpg or .tif, the longer side about 1,024 pixels. Empty: done; else what went wrong.
std::string write_drawdown_image(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                 DrawdownOrigin origin);
/// The same as a loom reads it: a pixel a crossing, black where the warp is on top. End 1 is at the right, pick 1 at
/// the top, as pictures are read.
std::string write_drawdown_points(const std::string& path, const BitMatrix& cells);
/// Into a .svg or .pdf, 2 mm a crossing, smaller where a side would pass a metre.
std::string write_drawdown_drawing(const std::string& path, const BitMatrix& cells, const Draft& draft,
                                   DrawdownOrigin origin);

}  // namespace weftlight::commands
