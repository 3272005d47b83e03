#pragma once
// What every control needs to draw itself: the look, the map that it is noted in, and where the keyboard goes.

#include <string>

#include "ui/names.h"
#include "ui/style.h"
#include "ui/ui_map.h"

namespace weftlight::ui {

struct Context {
  const Style& style;
  UiMap& map;
  std::string& focus;  // control that the keyboard goes to next, by its name in the --ui-map
};

}  // namespace weftlight::ui
