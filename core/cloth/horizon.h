#pragma once
// Horizons of a periodic height field: the elevation in one direction below which the surface hides the sky, at each
// point. Linear time, by a convex-hull stack for each sweep line.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cloth/maps.h"

namespace weftlight::cloth {

/// A sweep in one direction over a height field. `major` is the axis along which a line advances one texel a step. The
/// field is cut into blocks along it, and a point looks for occluders to the end of its block plus `ahead` texels,
/// which bounds what a change of height can affect.
struct Sweep {
  bool along_x = true;
  bool forward = true;        // the light is at +major
  double shear = 0;           // texels along the minor axis for a step of +1 along major
  float step_mm = 1;          // length of that step
  int length = 1, lines = 1;  // texels along major and minor
  int block = 1, ahead = 1;   // texels
  // Offset within the period of the field that is read and written, along major and minor.
  int first = 0, first_line = 0;
  int blocks() const { return (length + block - 1) / block; }
};

/// Extra lines that a sweep reads beside the requested ones.
inline constexpr int kSweepMargin = 10;

/// Sweep of a field of width x height texels of dx_mm x dy_mm towards an azimuth (0: +x, pi/2: +y). It looks at least
/// reach_mm far, but at most once along the field.
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

/// Writes the horizon as the sine of its elevation, unorm8, for lines [line0, line1) (they wrap) of one block. Line j
/// starts at (0, j); its value at step i goes to texel (i, j + floor(i * shear)).
void sweep_block(const Sweep& sweep, FieldView<const float> height, int line0, int line1, int block,
                 FieldView<uint8_t> out);

/// Horizons of the points of `window` (texels of the period, may leave it); other points of the same blocks are
/// written as well.
void sweep_window(const Sweep& sweep, FieldView<const float> height, const TexelRect& window, FieldView<uint8_t> out);

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

/// Horizons of a window of a field. `turned` is the transposed field, for sweeps along x. The rest of the result is
/// undefined.
Plane<uint8_t> horizon(const Plane<float>& height_mm, const Plane<float>& turned, const Sweep& sweep,
                       const TexelRect& window);
/// The whole field.
Plane<uint8_t> horizon(const Plane<float>& height_mm, const Sweep& sweep);

}  // namespace weftlight::cloth
