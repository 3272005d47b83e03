#pragma once
// What every control needs to draw itself: the look, the map that it is noted in, and where the keyboard goes.

#include <string>

#include "ui/names.h"
#include "ui/style.h"
#include "ui/ui_map.h"

namespace weftlight::ui {

/// The tooltip, by the clock and not by frames, which may be slow or not drawn at all.
struct Tip {
  double rest_s = 0;                  // how long the pointer has not moved
  bool shown = false, drawn = false;  // in the last frame and in this one
  float x = 0, y = 0;                 // of the control that it belongs to
  /// To be called before every frame.
  void begin(double rest) { rest_s = rest, shown = drawn, drawn = false; }
};

struct Context {
  const Style& style;
  UiMap& map;
  Tip& tip;
  std::string& focus;  // control that the keyboard goes to next, by its name in the --ui-map
};

}  // namespace weftlight::ui
