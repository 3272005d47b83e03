#pragma once
// Maps: one period of a face sampled on a seamless grid. Texel (x, y) is the centre of its square: u = (x + 0.5) /
// width * width_mm along the weft, v likewise along the warp; row 0 is v = 0.

#include <cstdint>
#include <vector>

#include "cloth/cloth.h"

namespace weftlight::cloth {

template <class T>
struct Plane {
  int width = 0, height = 0;
  std::vector<T> at_;
  Plane() = default;
  Plane(int w, int h, T fill = {}) : width(w), height(h), at_(static_cast<size_t>(w) * h, fill) {}
  T& at(int x, int y) { return at_[static_cast<size_t>(y) * width + x]; }
  const T& at(int x, int y) const { return at_[static_cast<size_t>(y) * width + x]; }
  T* row(int y) { return at_.data() + static_cast<size_t>(y) * width; }
  const T* row(int y) const { return at_.data() + static_cast<size_t>(y) * width; }
};

struct Slope {
  float x = 0, y = 0;  // -dz/du, -dz/dv: the normal is (x, y, 1) normalised
};
struct Direction {
  float x = 1, y = 0, z = 0;  // unit
};

/// Half-open rectangle of texels.
struct TexelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The unfiltered surface: what is on top at each texel. coverage 0 is a gap.
struct Maps {
  float width_mm = 0, depth_mm = 0;
  Plane<float> height_mm;    // above the middle plane; gaps have the level of the lowest thread
  Plane<float> coverage;     // 0..1
  Plane<Linear> colour;      // thread colour times the tone of its fibres, linear; not premultiplied
  Plane<float> groove;       // 0..1 factor of the twist's dark grooves (VRST 2003, section 3.2)
  Plane<Slope> slope;        // of the thread's surface
  Plane<Direction> tangent;  // fibre direction at the surface, with twist
  Plane<uint8_t> system;     // 0 warp, 1 weft (in gaps: of the nearest thread)
  Plane<uint32_t> thread;    // index in its system
  Plane<float> occlusion;    // 0..1, visible fraction of the cosine-weighted sky
  // Horizons: azimuth k points to (cos, sin)(2 pi k / azimuths) in (u, v). The value is the sine of the elevation
  // below which light is blocked, 0..1.
  int azimuths = 0;
  std::vector<Plane<uint8_t>> horizon;  // unorm8
};

struct MapsSize {
  int width = 1024, height = 1024;
  int azimuths = 16;
  int threads = 0;           // worker threads; 0: one a core. The result does not depend on it
  int samples_a_thread = 3;  // where a texel holds several threads
};

/// Bakes all maps of one period. Sizes are clamped to 1..16384, azimuths to 0..64. The result is the same bit for bit
/// on any number of threads.
Maps bake(const Cloth& cloth, const MapsSize& size);

/// A window of the maps that bake(cloth, whole) would give, bit for bit, at the cost of the window; here `whole` may
/// have up to 2^22 texels a side. The window is in texels of the whole; it may cross the period's edges and is cut to
/// one period and 16384 texels a side. width_mm and depth_mm are the window's.
Maps bake(const Cloth& cloth, const MapsSize& whole, const TexelRect& window);

/// Only the horizons and the occlusion that bake(cloth, size) would give, bit for bit, in a third of the memory; all
/// other planes are empty.
Maps bake_horizons(const Cloth& cloth, const MapsSize& size);

/// Rebakes the part of `maps` (baked as a whole from `before`) that the changed cells of `after` can affect. Both
/// cloths must have the same thread positions. The result equals bake(after, size) bit for bit. Returns disjoint
/// rectangles that hold every changed texel.
std::vector<TexelRect> rebake(Maps& maps, const Cloth& before, const Cloth& after);

/// The same for maps that were not kept: puts what bake(after, size) would give at the touched texels into `maps`,
/// which are made if they are empty. Everywhere else they stay as they are.
std::vector<TexelRect> bake_changed(Maps& maps, const Cloth& before, const Cloth& after, const MapsSize& size);

/// Every `step`th texel of the maps along both sides, without horizons: enough for means. Which one of a step differs
/// from place to place, since threads are as regular as a grid.
Maps subsampled(const Maps& maps, int step);
/// Brings the texels of a rectangle of the maps up to date in it.
void subsample_into(Maps& sampled, const Maps& maps, int step, const TexelRect& rect);

/// Boolean shadow of one light direction (VRST 2003, section 3.4): 1 lit, 0 in shadow.
Plane<uint8_t> shadow_map(const Maps& maps, float light_azimuth_rad, float light_elevation_rad);

}  // namespace weftlight::cloth
