#pragma once
// Keeps the drawn window in a texture and redraws only the areas that differ from the previous frame.

#include <imgui.h>

#include "ui/damage.h"

namespace weftlight::ui {

class Redraw {
 public:
  Redraw() = default;
  ~Redraw();
  Redraw(const Redraw&) = delete;
  Redraw& operator=(const Redraw&) = delete;

  /// Draws into the window's framebuffer, width x height pixels. True if it must be presented: something changed, or
  /// `show`.
  bool draw(ImDrawData& data, int width, int height, ImU32 background, bool show);
  /// Redraws everything next time, as after a change of fonts or theme.
  void invalidate() { damage_.invalidate(); }

 private:
  void resize(int width, int height);
  void draw_area(ImDrawData& data, const Area& area) const;

  Damage damage_;
  unsigned framebuffer_ = 0, picture_ = 0;
  int width_ = 0, height_ = 0;
  ImU32 background_ = 0;
};

}  // namespace weftlight::ui
