#pragma once
// What every control needs to draw itself: the style, the map that records its position, and the keyboard focus.

#include <string>

#include "ui/style.h"
#include "ui/ui_map.h"

namespace weftlight::ui {

/// State of the tooltip. Timed by the clock, because frames may be slow or skipped.
struct Tip {
  double rest_s = 0;                  // seconds since the pointer last moved
  bool shown = false, drawn = false;  // in the last frame and in this one
  float x = 0, y = 0;                 // of its control
  /// Call before every frame.
  void begin(double rest) { rest_s = rest, shown = drawn, drawn = false; }
};

struct Context {
  const Style& style;
  UiMap& map;
  Tip& tip;
  std::string& focus;  // control that gets the keyboard next, by its name in the --ui-map
};

}  // namespace weftlight::ui
