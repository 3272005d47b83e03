#pragma once
// Rulers along two sides of a picture: a band at its left and one below it, which meet in a corner with the unit.

#include <functional>
#include <vector>

#include "ui/ruler.h"
#include "views/common/panel.h"

namespace weftlight::views {

using ui::RulerMark;

// Pixels at 96 dpi.
inline constexpr float kRulerWide = 34, kRulerHigh = 22;

/// The rectangle of a ruler, and on which of its long sides the measured thing lies.
struct RulerBand {
  ImVec2 min, max;
  bool upright = false;      // measures downwards; its thing is at its right
  bool thing_below = false;  // of a level one; otherwise above it
};
/// `pixel_of`: where a mark in mm lies along the band. Marks outside it are not drawn.
void draw_ruler_band(ImDrawList* dl, const PanelContext& c, const RulerBand& band, const std::vector<RulerMark>& marks,
                     const std::function<float(double)>& pixel_of);
/// The unit, small, in the middle of the rectangle where two bands meet.
void draw_ruler_unit(ImDrawList* dl, const PanelContext& c, ImVec2 min, ImVec2 max);

}  // namespace weftlight::views
