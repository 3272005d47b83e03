// Based on: V. Timonen, J. Westerholm, Scalable Height Field Self-Shadowing, 2010: along a line swept
// towards the viewer from the light's side, the occluder of each point is on the upper convex hull of
// the points passed, and each point enters and leaves the hull once.
// Differs: the lines shear the periodic field and read between its texels; results are read back between
// two lines; the lines are cut into blocks, each with a run-up, to bound what an edit can touch.

#include "cloth/horizon.h"

#include <algorithm>
#include <cmath>

namespace weftlight {
namespace {

constexpr int kSmallestBlock = 32, kSmallestAhead = 8;

int wrap(int i, int n) {
  const int r = i % n;
  return r < 0 ? r + n : r;
}

/// Where each step of the lines of a block is: texel along the line, texels of shear, and the rest.
struct Steps {
  std::vector<int> along, shift;
  std::vector<float> rest;
};

/// From the far end of the run-up to the near end of the block.
Steps steps_of(const Sweep& s, int from, int to) {
  const int n = to - from + s.ahead;
  Steps steps;
  steps.along.resize(static_cast<size_t>(n));
  steps.shift.resize(static_cast<size_t>(n));
  steps.rest.resize(static_cast<size_t>(n));
  for (int k = 0; k < n; ++k) {
    const int i = s.forward ? to - 1 + s.ahead - k : from - s.ahead + k;
    const double sheared = i * s.shear, whole = std::floor(sheared);
    steps.along[static_cast<size_t>(k)] = wrap(i, s.length);
    steps.shift[static_cast<size_t>(k)] = wrap(static_cast<int>(whole), s.lines);
    steps.rest[static_cast<size_t>(k)] = static_cast<float>(sheared - whole);
  }
  return steps;
}

void read_line(const Sweep& s, const Steps& steps, FieldView<const float> z, int line, float* out) {
  const int start = wrap(line, s.lines);
  for (size_t k = 0; k < steps.along.size(); ++k) {
    int r = start + steps.shift[k];
    r -= r >= s.lines ? s.lines : 0;
    const int next = r + 1 == s.lines ? 0 : r + 1;
    const float* p = z.at + steps.along[k] * z.step;
    const float a = p[r * z.line_step], b = p[next * z.line_step];
    out[k] = a + steps.rest[k] * (b - a);
  }
}

struct HullPoint {
  float z;
  int k;
};

/// Steepest rise to any point before, for the points from `first` on; 0 or more.
void rises(const float* z, int n, int first, HullPoint* hull, float* out) {
  int top = -1;
  for (int k = 0; k < n; ++k) {
    const float here = z[k];
    while (top > 0) {
      const HullPoint a = hull[top], b = hull[top - 1];
      if ((a.z - here) * static_cast<float>(k - b.k) > (b.z - here) * static_cast<float>(k - a.k)) break;
      --top;
    }
    if (k >= first) out[k - first] = top < 0 ? 0.0f : (hull[top].z - here) / static_cast<float>(k - hull[top].k);
    hull[++top] = {here, k};
  }
}

}  // namespace

Sweep sweep_towards(double azimuth_rad, int width, int height, float dx_mm, float dy_mm, float reach_mm) {
  const double dx = static_cast<double>(dx_mm), dy = static_cast<double>(dy_mm);
  const double x = std::cos(azimuth_rad) / dx, y = std::sin(azimuth_rad) / dy;
  Sweep s;
  s.along_x = std::abs(x) >= std::abs(y);
  const double major = s.along_x ? x : y, minor = s.along_x ? y : x;
  s.forward = major > 0;
  s.shear = std::round(minor / major * 1e9) * 1e-9;  // axes and diagonals exactly
  s.step_mm = static_cast<float>(s.along_x ? std::hypot(dx, s.shear * dy) : std::hypot(dy, s.shear * dx));
  s.length = s.along_x ? width : height;
  s.lines = s.along_x ? height : width;
  const double wanted = std::ceil(static_cast<double>(reach_mm) / static_cast<double>(s.step_mm));
  s.ahead = static_cast<int>(std::clamp(wanted, 1.0 * std::min(kSmallestAhead, s.length), 1.0 * s.length));
  s.block = std::min(s.length, std::max(kSmallestBlock, 2 * s.ahead));
  return s;
}

void sweep_block(const Sweep& s, FieldView<const float> height, int line0, int line1, int block,
                 FieldView<uint8_t> out) {
  const int from = block * s.block, to = std::min(s.length, from + s.block), n = to - from;
  const Steps steps = steps_of(s, from, to);
  std::vector<float> z(steps.along.size()), sine(static_cast<size_t>(n)), before(static_cast<size_t>(n));
  std::vector<HullPoint> hull(z.size());
  const float per_step = 1.0f / s.step_mm;
  for (int line = line0 - 1; line < line1; ++line) {
    read_line(s, steps, height, line, z.data());
    std::swap(sine, before);
    rises(z.data(), static_cast<int>(z.size()), s.ahead, hull.data(), sine.data());
    for (float& v : sine) {
      const float slope = std::max(0.0f, v * per_step);
      v = slope / std::sqrt(1.0f + slope * slope);
    }
    if (line < line0) continue;
    const int start = wrap(line, s.lines);
    for (int i = 0; i < n; ++i) {
      const size_t k = static_cast<size_t>(i + s.ahead);
      int r = start + steps.shift[k];
      r -= r >= s.lines ? s.lines : 0;
      // The texel lies 1 - rest of the way from the line before to this one.
      const size_t v = static_cast<size_t>(i);
      const float value = sine[v] + steps.rest[k] * (before[v] - sine[v]);
      out.at[steps.along[k] * out.step + r * out.line_step] = static_cast<uint8_t>(value * 255.0f + 0.5f);
    }
  }
}

Plane<uint8_t> horizon(const Plane<float>& height_mm, const Sweep& s) {
  Plane<uint8_t> out(height_mm.width, height_mm.height);
  // Along y the texels of a line are far apart in memory: sweep a transposed copy.
  Plane<float> turned;
  FieldView<const float> z{height_mm.row(0), 1, height_mm.width};
  if (!s.along_x) {
    turned = transposed(height_mm);
    z = {turned.row(0), 1, turned.width};
  }
  Plane<uint8_t> swept = s.along_x ? Plane<uint8_t>{} : Plane<uint8_t>(turned.width, turned.height);
  Plane<uint8_t>& target = s.along_x ? out : swept;
  const FieldView<uint8_t> to{target.row(0), 1, target.width};
  for (int b = 0; b < s.blocks(); ++b) sweep_block(s, z, 0, s.lines, b, to);
  return s.along_x ? out : transposed(swept);
}

}  // namespace weftlight
