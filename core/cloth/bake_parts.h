#pragma once
// Shared by baking whole maps and by rebaking parts of them.

#include <algorithm>
#include <utility>
#include <vector>

#include "cloth/horizon.h"
#include "cloth/maps.h"
#include "cloth/surface_sampler.h"
#include "cloth/wrap.h"

namespace weftlight::cloth {

inline bool is_empty(const Cloth& cloth) { return cloth.ends.empty() || cloth.picks.empty(); }

/// The range [from, to) of a periodic axis of n, as pieces inside 0..n.
inline std::vector<std::pair<int, int>> pieces(int from, int to, int n) {
  if (to - from >= n) return {{0, n}};
  const int a = wrap(from, n), b = a + (to - from);
  if (b <= n) return {{a, b}};
  return {{a, n}, {0, b - n}};
}

inline std::vector<TexelRect> pieces(const TexelRect& r, int width, int height) {
  std::vector<TexelRect> out;
  for (const auto& [y0, y1] : pieces(r.y0, r.y1, height))
    for (const auto& [x0, x1] : pieces(r.x0, r.x1, width)) out.push_back({x0, y0, x1, y1});
  return out;
}

/// All 0.
Maps blank_maps(const MapsSize& size);
/// Copies maps of a window to their place in the whole.
void copy_window(Maps& maps, const Maps& window, const TexelRect& at);

/// Bakes everything but horizons and occlusion at the texels of a rectangle inside whole-period maps.
void bake_surface(Maps& maps, const Cloth& cloth, const SampleGrid& grid, const TexelRect& r);
/// Sweep k of `azimuths`, over a period of width x height texels.
Sweep sweep_of(const Cloth& cloth, int width, int height, int azimuths, int k);
/// Cosine-weighted fraction of the sky above the horizons.
void bake_occlusion(Maps& maps, const TexelRect& r);

}  // namespace weftlight::cloth
