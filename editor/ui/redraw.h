#pragma once
// Draws ImGui's frames into a picture that is kept, and of each frame only what differs from the one before.

#include <imgui.h>

#include "ui/damage.h"

namespace weftlight::ui {

class Redraw {
 public:
  Redraw() = default;
  ~Redraw();
  Redraw(const Redraw&) = delete;
  Redraw& operator=(const Redraw&) = delete;

  /// Into the window's framebuffer, width x height pixels. True when it must be shown: something changed, or `show`.
  bool draw(ImDrawData& data, int width, int height, ImU32 background, bool show);
  /// The fonts or the theme are others.
  void forget() { damage_.forget(); }

 private:
  void resize(int width, int height);
  void draw_area(ImDrawData& data, const Area& area) const;

  Damage damage_;
  unsigned framebuffer_ = 0, picture_ = 0;
  int width_ = 0, height_ = 0;
  ImU32 background_ = 0;
};

}  // namespace weftlight::ui
