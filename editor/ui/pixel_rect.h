#pragma once
// A rectangle of the screen, in pixels.

#include <imgui.h>

namespace weftlight::ui {

struct PixelRect {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
  ImVec2 middle() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
};

}  // namespace weftlight::ui
