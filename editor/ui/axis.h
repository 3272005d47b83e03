#pragma once
// One direction of a grid on the screen: which pixels a thread, shaft or treadle covers. Index 0 lies at
// the low pixel (left, top) or, reversed, at the high one.

namespace weftlight::ui {

struct Axis {
  float start = 0, length = 0;  // pixels of the pane
  float pitch = 12;             // pixels a cell, > 0
  float scroll = 0;             // cells that lie before the pane, on the side of index 0
  int count = 0;
  bool reversed = false;

  /// Low and high pixel of cell i, on whole pixels, so that neighbours meet without a seam.
  float low(int i) const;
  float high(int i) const;
  /// Cell at a pixel, or -1 outside the pane or the grid.
  int at(float pixel) const;
  /// As `at`, but the closest cell for pixels outside (for drags that leave the pane). -1 if there are no cells.
  int nearest(float pixel) const;
  /// Half-open range of the cells that the pane shows, whole or in part.
  int first_visible() const;
  int end_visible() const;
  /// Pixels that all cells take.
  float extent() const { return pitch * static_cast<float>(count); }
};

/// Cell at a pixel, also beyond pane and grid.
int cell_at(const Axis& axis, float pixel);
/// Held between 0 and the scroll at which the last cell meets the edge of the pane.
float clamp_scroll(const Axis& axis, float scroll);
/// The scroll that keeps the cell under `pixel` in place when the pitch becomes `new_pitch`.
float scroll_about(const Axis& axis, float pixel, float new_pitch);
/// Smallest of 1, 2, 5, 10, 20, 50 ... cells whose width is at least `pixels`.
int label_step(float pitch, float pixels);

}  // namespace weftlight::ui
