#pragma once
// Horizons of a periodic height field: how high above the horizontal, in one direction, the
// surface rises as seen from each of its points. Linear time: a convex-hull stack a sweep line.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/maps.h"
#include "cloth/names.h"

namespace weftlight::cloth {

/// One direction over a height field. `major` is the axis along which a line advances one texel a step.
/// The field is cut into blocks along it; a point looks for what hides the light to the end of its block
/// and `ahead` texels more, so that what a change of height can touch is bounded.
struct Sweep {
  bool along_x = true;
  bool forward = true;        // light from +major
  double shear = 0;           // texels of the minor axis for a step of +1 along major
  float step_mm = 1;          // length of that step
  int length = 1, lines = 1;  // texels along the major and the minor axis
  int block = 1, ahead = 1;   // texels
  // Where in the period the field begins that is read and written, along the major and the minor axis.
  int first = 0, first_line = 0;
  int blocks() const { return (length + block - 1) / block; }
};

/// Lines beside those asked for that a sweep reads.
inline constexpr int kSweepMargin = 10;

/// Sweep of a field of width x height texels of dx_mm x dy_mm towards an azimuth (0: +x, pi/2: +y),
/// looking at least reach_mm far, but never further than once along the field.
Sweep sweep_towards(double azimuth_rad, int width, int height, float dx_mm, float dy_mm, float reach_mm);

/// A field seen along a sweep: element (i, j), i along the major axis, is at[i * step + j * line_step].
template <class T>
struct FieldView {
  T* at = nullptr;
  std::ptrdiff_t step = 1, line_step = 0;
};
template <class T>
FieldView<T> view_along(const Sweep& sweep, T* at, int width) {
  return sweep.along_x ? FieldView<T>{at, 1, width} : FieldView<T>{at, width, 1};
}

/// Horizon as sine of the elevation, unorm8, of lines [line0, line1) (they wrap) in one block. Line j
/// starts at (0, j); its value lands at the texel above its place: (i, j + floor(i * shear)).
void sweep_block(const Sweep& sweep, FieldView<const float> height, int line0, int line1, int block,
                 FieldView<uint8_t> out);

/// Horizons of the points of `window` (texels of the period, may leave it) and, by the way, of others of
/// their blocks.
void sweep_window(const Sweep& sweep, FieldView<const float> height, const TexelRect& window, FieldView<uint8_t> out);

/// Columns as rows.
template <class T>
Plane<T> transposed(const Plane<T>& in) {
  constexpr int kTile = 32;
  Plane<T> out(in.height, in.width);
  for (int y0 = 0; y0 < in.height; y0 += kTile)
    for (int x0 = 0; x0 < in.width; x0 += kTile)
      for (int x = x0; x < std::min(in.width, x0 + kTile); ++x)
        for (int y = y0; y < std::min(in.height, y0 + kTile); ++y) out.at(y, x) = in.at(x, y);
  return out;
}

/// Those of a window of a field; `turned` is the field transposed, for sweeps along x. The rest of the
/// field is left undefined.
Plane<uint8_t> horizon(const Plane<float>& height_mm, const Plane<float>& turned, const Sweep& sweep,
                       const TexelRect& window);
/// The whole field.
Plane<uint8_t> horizon(const Plane<float>& height_mm, const Sweep& sweep);

}  // namespace weftlight::cloth
