// Based on: V. Timonen, J. Westerholm, Scalable Height Field Self-Shadowing, 2010: along a line swept
// towards the viewer from the light's side, the occluder of each point is on the upper convex hull of
// the points passed, and each point enters and leaves the hull once.
// Differs: the lines shear the periodic field and read between its texels; results are read back between
// two lines; the lines are cut into blocks, each with a run-up, to bound what an edit can touch.

#include "cloth/horizon.h"

#include <algorithm>
#include <cmath>

#include "cloth/wrap.h"

namespace weftlight::cloth {
namespace {

constexpr int kSmallestBlock = 32, kSmallestAhead = 8;

/// Position of each step of the lines of a block: texel along the line, whole texels of shear, and the remainder.
struct Steps {
  std::vector<int> along, shift;
  std::vector<float> rest;
};

/// Steps from the far end of the run-up to the near end of the block.
Steps steps_of(const Sweep& s, int from, int to) {
  const int n = to - from + s.ahead;
  Steps steps;
  steps.along.resize(static_cast<size_t>(n));
  steps.shift.resize(static_cast<size_t>(n));
  steps.rest.resize(static_cast<size_t>(n));
  for (int k = 0; k < n; ++k) {
    const int i = s.forward ? to - 1 + s.ahead - k : from - s.ahead + k;
    const double sheared = i * s.shear, whole = std::floor(sheared);
    steps.along[static_cast<size_t>(k)] = wrap(i - s.first, s.length);
    steps.shift[static_cast<size_t>(k)] = wrap(static_cast<int>(whole) - s.first_line, s.lines);
    steps.rest[static_cast<size_t>(k)] = static_cast<float>(sheared - whole);
  }
  return steps;
}

// Lines are swept side by side: their texels are neighbours in memory, so reads and writes vectorise, and their hulls
// are independent.
constexpr int kLanes = 8;
static_assert(kLanes + 2 <= kSweepMargin);

struct HullPoint {
  float z, k;
};

/// Buffers of a bundle of lines; value k of lane j is at [k * kLanes + j].
struct Bundle {
  std::vector<float> z;
  // Sines, with the line before the first lane in front: [i * (kLanes + 1) + 1 + j].
  std::vector<float> sine;
  std::vector<HullPoint> hull;  // one stack a line
};

void read_lines(const Sweep& s, const Steps& steps, FieldView<const float> z, int line, float* out) {
  const int start = wrap(line, s.lines);
  for (size_t k = 0; k < steps.along.size(); ++k, out += kLanes) {
    int r = start + steps.shift[k];
    r -= r >= s.lines ? s.lines : 0;
    const float* p = z.at + steps.along[k] * z.step;
    const float rest = steps.rest[k];
    if (z.line_step == 1 && r + kLanes < s.lines) {
      p += r;
      for (int j = 0; j < kLanes; ++j) out[j] = p[j] + rest * (p[j + 1] - p[j]);
      continue;
    }
    for (int j = 0; j < kLanes; ++j) {
      const int next = r + 1 == s.lines ? 0 : r + 1;
      const float a = p[r * z.line_step], b = p[next * z.line_step];
      out[j] = a + rest * (b - a);
      r = next;
    }
  }
}

/// Steepest rise, in height a step, from each point to any point before it, for the points from `first` on.
void rises(Bundle& b, int n, int first) {
  HullPoint* top[kLanes];
  HullPoint* bottom[kLanes];
  for (int j = 0; j < kLanes; ++j) bottom[j] = b.hull.data() + static_cast<size_t>(j) * static_cast<size_t>(n + 1);
  for (int j = 0; j < kLanes; ++j) *(top[j] = bottom[j]) = {b.z[static_cast<size_t>(j)], 0.0f};
  const float* z = b.z.data();
  for (int i = 0; i < n; ++i, z += kLanes) {
    const float k = static_cast<float>(i);
    float* out = i >= first ? b.sine.data() + static_cast<size_t>(i - first) * (kLanes + 1) + 1 : nullptr;
    for (int j = 0; j < kLanes; ++j) {
      HullPoint* t = top[j];
      // The first point is already on the stack.
      while (t > bottom[j] && (t[0].z - z[j]) * (k - t[-1].k) <= (t[-1].z - z[j]) * (k - t[0].k)) --t;
      if (out) out[j] = i > 0 ? (t->z - z[j]) / (k - t->k) : 0.0f;
      if (i > 0) *++t = {z[j], k};
      top[j] = t;
    }
  }
}

void to_sines(std::vector<float>& rise, float per_step) {
  for (float& v : rise) {
    const float slope = std::max(0.0f, v * per_step);
    v = slope / std::sqrt(1.0f + slope * slope);
  }
}

/// A texel lies 1 - rest of the way from the previous line to its own.
void write_lines(const Sweep& s, const Steps& steps, const Bundle& b, int line, int lanes, FieldView<uint8_t> out) {
  const int start = wrap(line, s.lines);
  const float* v = b.sine.data() + 1;
  for (size_t k = static_cast<size_t>(s.ahead); k < steps.along.size(); ++k, v += kLanes + 1) {
    int r = start + steps.shift[k];
    r -= r >= s.lines ? s.lines : 0;
    uint8_t* p = out.at + steps.along[k] * out.step;
    const float rest = steps.rest[k];
    const auto value = [&](int j) {
      return static_cast<uint8_t>(static_cast<int>((v[j] + rest * (v[j - 1] - v[j])) * 255.0f + 0.5f));
    };
    if (out.line_step == 1 && lanes == kLanes && r + kLanes <= s.lines) {
      p += r;
      for (int j = 0; j < kLanes; ++j) p[j] = value(j);
      continue;
    }
    for (int j = 0; j < lanes; ++j) {
      p[r * out.line_step] = value(j);
      r = r + 1 == s.lines ? 0 : r + 1;
    }
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
  s.shear = std::round(minor / major * 1e9) * 1e-9;  // exact on axes and diagonals
  s.step_mm = static_cast<float>(s.along_x ? std::hypot(dx, s.shear * dy) : std::hypot(dy, s.shear * dx));
  s.length = s.along_x ? width : height;
  s.lines = s.along_x ? height : width;
  const double wanted = std::ceil(static_cast<double>(reach_mm) / static_cast<double>(s.step_mm));
  s.ahead = static_cast<int>(std::clamp(wanted, 1.0 * std::min(kSmallestAhead, s.length), 1.0 * s.length));
  // Equal blocks, each at least twice its run-up if there is more than one.
  const int blocks = std::max(1, s.length / std::max(kSmallestBlock, 2 * s.ahead));
  s.block = (s.length + blocks - 1) / blocks;
  return s;
}

void sweep_block(const Sweep& s, FieldView<const float> height, int line0, int line1, int block,
                 FieldView<uint8_t> out) {
  const int from = block * s.block, to = std::min(s.length, from + s.block);
  const Steps steps = steps_of(s, from, to);
  const size_t n = steps.along.size(), shown = static_cast<size_t>(to - from);
  Bundle b;
  b.z.resize(n * kLanes);
  b.sine.resize(shown * (kLanes + 1));
  b.hull.resize((n + 1) * kLanes);
  std::vector<float> before(shown);
  // The first bundle only computes the line before line0, as its last lane.
  for (int line = line0 - kLanes; line < line1; line += kLanes) {
    read_lines(s, steps, height, line, b.z.data());
    rises(b, static_cast<int>(n), s.ahead);
    to_sines(b.sine, 1.0f / s.step_mm);
    for (size_t i = 0; i < shown; ++i) {
      b.sine[i * (kLanes + 1)] = before[i];
      before[i] = b.sine[i * (kLanes + 1) + kLanes];
    }
    if (line >= line0) write_lines(s, steps, b, line, std::min(kLanes, line1 - line), out);
  }
}

void sweep_window(const Sweep& s, FieldView<const float> height, const TexelRect& window, FieldView<uint8_t> out) {
  const int a0 = s.along_x ? window.x0 : window.y0, a1 = s.along_x ? window.x1 : window.y1;
  const int c0 = s.along_x ? window.y0 : window.x0, c1 = s.along_x ? window.y1 : window.x1;
  const auto shift = [&](int i) { return static_cast<int>(std::floor(i * s.shear)); };
  for (int turn = (a0 - wrap(a0, s.length)) / s.length; turn * s.length < a1; ++turn) {
    for (int b = 0; b < s.blocks(); ++b) {
      const int from = std::max(b * s.block, a0 - turn * s.length);
      const int to = std::min({s.length, (b + 1) * s.block, a1 - turn * s.length});
      if (from >= to) continue;
      const int low = std::min(shift(from), shift(to - 1)), high = std::max(shift(from), shift(to - 1));
      const int line = c0 - high;
      sweep_block(s, height, line, std::min(c1 - low, line + s.lines), b, out);
    }
  }
}

Plane<uint8_t> horizon(const Plane<float>& height_mm, const Plane<float>& turned, const Sweep& s,
                       const TexelRect& window) {
  // Neighbouring lines should be neighbours in memory: sweeps along x use the transposed field.
  const Plane<float>& field = s.along_x ? turned : height_mm;
  Plane<uint8_t> out(field.width, field.height);
  sweep_window(s, {field.row(0), field.width, 1}, window, {out.row(0), out.width, 1});
  return s.along_x ? transposed(out) : out;
}

Plane<uint8_t> horizon(const Plane<float>& height_mm, const Sweep& s) {
  return horizon(height_mm, s.along_x ? transposed(height_mm) : Plane<float>{}, s,
                 {0, 0, height_mm.width, height_mm.height});
}

}  // namespace weftlight::cloth
