#include "ui/axis.h"

#include <algorithm>
#include <cmath>

namespace weftlight::ui {
namespace {

/// Pixels scrolled away. Rounded, so that drawing and hit testing agree.
float scrolled_px(const Axis& a) { return std::round(a.scroll * a.pitch); }

/// Pixels from the pane's edge at index 0 to the near edge of cell i.
float offset(const Axis& a, int i) { return std::round(static_cast<float>(i) * a.pitch) - scrolled_px(a); }

}  // namespace

int cell_at(const Axis& a, float pixel) {
  if (a.reversed) return static_cast<int>(std::ceil((a.start + a.length - pixel + scrolled_px(a)) / a.pitch)) - 1;
  return static_cast<int>(std::floor((pixel - a.start + scrolled_px(a)) / a.pitch));
}

float Axis::low(int i) const { return reversed ? start + length - offset(*this, i + 1) : start + offset(*this, i); }

float Axis::high(int i) const { return reversed ? start + length - offset(*this, i) : start + offset(*this, i + 1); }

int Axis::at(float pixel) const {
  if (pixel < start || pixel >= start + length) return -1;
  const int cell = cell_at(*this, pixel);
  return cell >= 0 && cell < count ? cell : -1;
}

int Axis::nearest(float pixel) const {
  const int last = end_visible() - 1;
  return count == 0 ? -1 : std::clamp(cell_at(*this, pixel), std::min(first_visible(), last), last);
}

int Axis::first_visible() const { return std::clamp(static_cast<int>(std::floor(scroll)), 0, count); }

int Axis::end_visible() const { return std::clamp(static_cast<int>(std::ceil(scroll + length / pitch)), 0, count); }

float clamp_scroll(const Axis& axis, float scroll) {
  const float max_scroll = std::max(0.0f, static_cast<float>(axis.count) - axis.length / axis.pitch);
  return std::clamp(scroll, 0.0f, max_scroll);
}

float scroll_about(const Axis& axis, float pixel, float new_pitch) {
  const float along = axis.reversed ? axis.start + axis.length - pixel : pixel - axis.start;
  return axis.scroll + along / axis.pitch - along / new_pitch;
}

int label_step(float pitch, float pixels) {
  constexpr int kFirst[] = {1, 2, 5};
  for (int ten = 1; ten <= 100000; ten *= 10)
    for (int f : kFirst)
      if (static_cast<float>(f * ten) * pitch >= pixels) return f * ten;
  return 1000000;
}

}  // namespace weftlight::ui
