// Heights of threads where they cross (shaders/crossing_height.glsl has the formulas), and the curve between crossings,
// which bulges between the crossings of a float, as a bent yarn does (shaders/thread_curve.glsl).

#include "cloth/centre_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "cloth/thickness.h"
#include "cloth/thread_texture.h"
#include "cloth/wrap.h"

namespace weftlight::cloth {

using draft::BitMatrix;
using thread_formulas::bending_stiffness, thread_formulas::crimp_fraction, thread_formulas::longest_rise,
    thread_formulas::rise_of;

namespace {

using RiseTable = std::array<float, (kFloatReach + 1) * (kFloatReach + 1)>;

RiseTable rise_table() {
  RiseTable table{};
  for (int b = 0; b <= kFloatReach; ++b)
    for (int a = 0; a <= kFloatReach; ++a) table[static_cast<size_t>(b * (kFloatReach + 1) + a)] = rise_of(b, a);
  return table;
}

float mean_spacing(const std::vector<ThreadBody>& threads, float period) {
  return std::max(1e-6f, period / static_cast<float>(threads.size()));
}

struct ThreadFacts {
  float height = 0, stiffness = 0, rise = 0;
};

std::vector<ThreadFacts> facts(const std::vector<ThreadBody>& threads, int first, int last, float span_mm) {
  std::vector<ThreadFacts> out;
  for (int i = first; i < last; ++i) {
    const ThreadBody& t = threads[static_cast<size_t>(wrap(i, static_cast<int>(threads.size())))];
    out.push_back({t.height_mm, bending_stiffness(t.width_mm, t.height_mm, span_mm),
                   longest_rise(t.width_mm, t.height_mm, t.spacing_mm)});
  }
  return out;
}

/// Cells of the window, padded by kFloatReach on all sides and wrapped, one byte each.
struct Cells {
  int rows = 0, cols = 0;
  std::vector<uint8_t> up;
  Cells(const BitMatrix& bits, const CellRect& w)
      : rows(w.pick1 - w.pick0 + 2 * kFloatReach), cols(w.end1 - w.end0 + 2 * kFloatReach) {
    up.resize(static_cast<size_t>(rows) * static_cast<size_t>(cols));
    std::vector<int> col_of(static_cast<size_t>(cols));
    for (int c = 0; c < cols; ++c) col_of[static_cast<size_t>(c)] = wrap(w.end0 - kFloatReach + c, bits.cols());
    for (int r = 0; r < rows; ++r) {
      const auto words = bits.row(wrap(w.pick0 - kFloatReach + r, bits.rows()));
      uint8_t* out = up.data() + static_cast<size_t>(r) * static_cast<size_t>(cols);
      for (int c = 0; c < cols; ++c) {
        const int e = col_of[static_cast<size_t>(c)];
        out[c] = (words[static_cast<size_t>(e >> 6)] >> (e & 63)) & 1u;
      }
    }
  }
  /// Crossings of the same float in steps of `stride` from `at`, at most kFloatReach.
  int run(size_t at, std::ptrdiff_t stride) const {
    int n = 0;
    const uint8_t* p = up.data() + at;
    while (n < kFloatReach && p[stride * (n + 1)] == p[0]) ++n;
    return n;
  }
};

/// Adds the levels of a layer of a multi-layer cloth.
void add_levels(CentreLines& lines, const Cloth& cloth) {
  if (cloth.warp_level_mm.empty()) return;
  const int ends = cloth.up.cols(), picks = cloth.up.rows();
  size_t out = 0;
  for (int p = lines.window.pick0; p < lines.window.pick1; ++p) {
    const size_t row = static_cast<size_t>(wrap(p, picks)) * static_cast<size_t>(ends);
    for (int e = lines.window.end0; e < lines.window.end1; ++e, ++out) {
      const size_t from = row + static_cast<size_t>(wrap(e, ends));
      lines.warp_mm[out] += cloth.warp_level_mm[from], lines.weft_mm[out] += cloth.weft_level_mm[from];
    }
  }
}

}  // namespace

CentreLines centre_lines(const Cloth& cloth, const CellRect& window) {
  CentreLines lines;
  lines.window = window;
  if (cloth.ends.empty() || cloth.picks.empty() || window.empty()) return lines;
  static const RiseTable kRises = rise_table();
  const auto warp = facts(cloth.ends, window.end0, window.end1, mean_spacing(cloth.picks, cloth.depth_mm));
  const auto weft = facts(cloth.picks, window.pick0, window.pick1, mean_spacing(cloth.ends, cloth.width_mm));
  const Cells cells(cloth.up, window);
  const int ends = lines.ends(), picks = window.pick1 - window.pick0;
  lines.warp_mm.resize(static_cast<size_t>(ends) * static_cast<size_t>(picks));
  lines.weft_mm.resize(lines.warp_mm.size());
  const bool is_uneven = uneven(cloth, System::kWarp) || uneven(cloth, System::kWeft);
  const auto rise = [&](size_t at, std::ptrdiff_t stride) {
    return kRises[static_cast<size_t>(cells.run(at, -stride) * (kFloatReach + 1) + cells.run(at, stride))];
  };
  size_t out = 0;
  for (int p = 0; p < picks; ++p) {
    const ThreadFacts& f = weft[static_cast<size_t>(p)];
    for (int e = 0; e < ends; ++e, ++out) {
      const ThreadFacts& w = warp[static_cast<size_t>(e)];
      const size_t at =
          static_cast<size_t>(p + kFloatReach) * static_cast<size_t>(cells.cols) + static_cast<size_t>(e + kFloatReach);
      const float warp_part = crimp_fraction(w.stiffness, f.stiffness);
      const float apart = is_uneven ? section_at(cloth, System::kWarp, window.end0 + e, window.pick0 + p).y +
                                          section_at(cloth, System::kWeft, window.pick0 + p, window.end0 + e).y
                                    : 0.5f * (w.height + f.height);
      const float side = cells.up[at] ? 1.0f : -1.0f;
      lines.warp_mm[out] = side * (warp_part * apart + w.rise * rise(at, cells.cols));
      lines.weft_mm[out] = -side * ((1.0f - warp_part) * apart + f.rise * rise(at, 1));
    }
  }
  add_levels(lines, cloth);
  return lines;
}

CentreLines centre_lines(const Cloth& cloth) {
  // A step before the first crossing begins at -1, and its curve reads one more.
  return centre_lines(cloth, {-2, cloth.up.cols() + 2, -2, cloth.up.rows() + 2});
}

CentrePoint centre_between(float z0, float z1, float z2, float z3, const CentreStep& step) {
  const glm::vec4 cubic = thread_formulas::cubic_through(z1, centre_slope(z0, z2, step.h0 + step.h1), z2,
                                                         centre_slope(z1, z3, step.h1 + step.h2), step.h1);
  const glm::vec3 c = thread_formulas::cubic_at(cubic, step.t * step.h1);
  return {c.x, c.y, c.z};
}

CentrePoint centre_at(const CentreLines& lines, System system, int thread, const CentreStep& step) {
  const bool warp = system == System::kWarp;
  const int dp = warp ? 1 : 0, de = 1 - dp;
  const int e = warp ? thread : step.crossing, p = warp ? step.crossing : thread;
  return centre_between(lines.at(system, e - de, p - dp), lines.at(system, e, p), lines.at(system, e + de, p + dp),
                        lines.at(system, e + 2 * de, p + 2 * dp), step);
}

}  // namespace weftlight::cloth
