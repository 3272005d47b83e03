#pragma once
// Small designs with known answers.

#include <cmath>
#include <string>

#include "cloth/cloth.h"
#include "cloth/maps.h"

namespace weftlight::cloth {

using design::Design;
using draft::BitMatrix, draft::Rgb, draft::Threads, draft::blank_draft;

/// Design of the given size: every thread of one yarn; spacing and thickness as given.
inline Design design_of(int ends, int picks, float spacing_mm, float thickness_mm) {
  Design d;
  d.draft = blank_draft(ends, picks, 1, 1);
  d.draft.palette = {Rgb{0.8f, 0.7f, 0.6f}, Rgb{0.2f, 0.3f, 0.5f}};
  for (Threads* t : {&d.draft.warp, &d.draft.weft}) {
    const size_t n = static_cast<size_t>(t->size());
    t->spacing_mm.assign(n, spacing_mm);
    t->thickness_mm.assign(n, thickness_mm);
    t->color.assign(n, t == &d.draft.warp ? 0 : 1);
  }
  return d;
}

/// Window of width x height texels, centred on a point of the cloth.
inline TexelRect window_around(const Cloth& cloth, const MapsSize& whole, float u_mm, float v_mm, int width,
                               int height) {
  const int x = static_cast<int>(std::lround(u_mm / cloth.width_mm * static_cast<float>(whole.width))) - width / 2,
            y = static_cast<int>(std::lround(v_mm / cloth.depth_mm * static_cast<float>(whole.height))) - height / 2;
  return {x, y, x + width, y + height};
}

template <class Up>
BitMatrix cells_of(int ends, int picks, const Up& up) {
  BitMatrix cells(picks, ends);
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) cells.set(p, e, up(e, p));
  return cells;
}

inline BitMatrix plain(int ends, int picks) {
  return cells_of(ends, picks, [](int e, int p) { return (e + p) % 2 == 0; });
}
inline BitMatrix twill(int ends, int picks) {
  return cells_of(ends, picks, [](int e, int p) { return ((e - p) % 4 + 4) % 4 < 2; });
}
/// 8-shaft satin, warp face, step 5.
inline BitMatrix satin(int ends, int picks) {
  return cells_of(ends, picks, [](int e, int p) { return (e * 5) % 8 != p % 8; });
}

/// Irregular cells from a fixed sequence.
inline BitMatrix scattered(int ends, int picks, uint32_t seed) {
  return cells_of(ends, picks, [&](int, int) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 28) < 8;
  });
}

template <class T, class Same>
bool same_plane(const Plane<T>& a, const Plane<T>& b, const Same& same) {
  if (a.width != b.width || a.height != b.height) return false;
  for (size_t i = 0; i < a.at_.size(); ++i)
    if (!same(a.at_[i], b.at_[i])) return false;
  return true;
}

/// Name of the first map that differs, or empty.
inline std::string difference(const Maps& a, const Maps& b) {
  const auto equal = [](const auto& x, const auto& y) { return x == y; };
  if (!same_plane(a.height_mm, b.height_mm, equal)) return "height";
  if (!same_plane(a.coverage, b.coverage, equal)) return "coverage";
  if (!same_plane(a.colour, b.colour,
                  [](const Linear& x, const Linear& y) { return x.r == y.r && x.g == y.g && x.b == y.b; }))
    return "colour";
  if (!same_plane(a.groove, b.groove, equal)) return "groove";
  if (!same_plane(a.slope, b.slope, [](const Slope& x, const Slope& y) { return x.x == y.x && x.y == y.y; }))
    return "slope";
  if (!same_plane(a.tangent, b.tangent,
                  [](const Direction& x, const Direction& y) { return x.x == y.x && x.y == y.y && x.z == y.z; }))
    return "tangent";
  if (!same_plane(a.system, b.system, equal)) return "system";
  if (!same_plane(a.thread, b.thread, equal)) return "thread";
  if (a.horizon.size() != b.horizon.size()) return "azimuths";
  for (size_t k = 0; k < a.horizon.size(); ++k)
    if (!same_plane(a.horizon[k], b.horizon[k], equal)) return "horizon " + std::to_string(k);
  return same_plane(a.occlusion, b.occlusion, equal) ? "" : "occlusion";
}

}  // namespace weftlight::cloth
