#pragma once
// Internal to printing: drawing on a sheet, in millimetres from the upper left corner.

#include <cairo.h>

#include <string>

#include "draft/draft.h"

namespace weftlight::print {

using draft::Rgb;

inline constexpr double kMargin = 14;  // mm
inline constexpr Rgb kInk{0.13f, 0.14f, 0.17f}, kFaint{0.78f, 0.78f, 0.79f}, kMuted{0.45f, 0.46f, 0.5f};

/// The unit of the Cairo context is a millimetre.
class Pen {
 public:
  explicit Pen(cairo_t* context) : context_(context) {}
  cairo_t* context() const { return context_; }
  void fill(double x, double y, double width, double height, const Rgb& color) const;
  /// `opacity`: 0..1.
  void line(double x0, double y0, double x1, double y1, double width, const Rgb& color, double opacity = 1) const;
  void frame(double x, double y, double width, double height, double line, const Rgb& color) const;
  /// Baseline at y; `size` is the font size in mm. Returns the width.
  double text(double x, double y, double size, const std::string& text, const Rgb& color = kInk,
              bool bold = false) const;
  /// Right-aligned at x.
  void text_right(double x, double y, double size, const std::string& text, const Rgb& color = kInk) const;
  double width_of(double size, const std::string& text, bool bold = false) const;

 private:
  void font(double size, bool bold) const;
  cairo_t* context_;
};

}  // namespace weftlight::print
