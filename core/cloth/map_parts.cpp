// Parts of maps: blank ones, windows copied into the whole, and subsampled copies.

#include "cloth/bake_parts.h"

namespace weftlight::cloth {

namespace {

/// Calls visit(plane of a, plane of b) for each kind but the horizons.
template <class A, class B, class Visit>
void for_planes(A& a, B& b, const Visit& visit) {
  visit(a.height_mm, b.height_mm), visit(a.coverage, b.coverage), visit(a.colour, b.colour);
  visit(a.groove, b.groove), visit(a.slope, b.slope), visit(a.tangent, b.tangent);
  visit(a.system, b.system), visit(a.thread, b.thread), visit(a.occlusion, b.occlusion);
}

/// The texel that stands for one of a subsampled copy.
glm::ivec2 source_of(int x, int y, int step, int width, int height) {
  const uint32_t random = (static_cast<uint32_t>(x) * 0x9E3779B1u + static_cast<uint32_t>(y)) * 0x85EBCA77u;
  const int part = static_cast<int>(random >> 8);
  return {std::min(x * step + part % step, width - 1), std::min(y * step + part / step % step, height - 1)};
}

}  // namespace

Maps blank_maps(const MapsSize& size) {
  Maps maps;
  for_planes(maps, maps, [&](auto& plane, auto&) { plane = std::decay_t<decltype(plane)>(size.width, size.height); });
  maps.azimuths = size.azimuths;
  maps.horizon.assign(static_cast<size_t>(size.azimuths), Plane<uint8_t>(size.width, size.height));
  return maps;
}

void copy_window(Maps& maps, const Maps& window, const TexelRect& at) {
  const auto copy = [&](auto& to, const auto& from) {
    for (int y = at.y0; y < at.y1; ++y) std::copy_n(from.row(y - at.y0), at.x1 - at.x0, to.row(y) + at.x0);
  };
  for_planes(maps, window, copy);
  for (size_t k = 0; k < maps.horizon.size(); ++k) copy(maps.horizon[k], window.horizon[k]);
}

Maps subsampled(const Maps& maps, int step) {
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  Maps sampled = blank_maps({(w + step - 1) / step, (h + step - 1) / step, 0});
  sampled.width_mm = maps.width_mm, sampled.depth_mm = maps.depth_mm, sampled.azimuths = maps.azimuths;
  subsample_into(sampled, maps, step, {0, 0, w, h});
  return sampled;
}

void subsample_into(Maps& sampled, const Maps& maps, int step, const TexelRect& rect) {
  const int w = maps.height_mm.width, h = maps.height_mm.height;
  for (int y = rect.y0 / step; y < std::min((rect.y1 + step - 1) / step, sampled.height_mm.height); ++y) {
    for (int x = rect.x0 / step; x < std::min((rect.x1 + step - 1) / step, sampled.height_mm.width); ++x) {
      const glm::ivec2 from = source_of(x, y, step, w, h);
      if (from.x < rect.x0 || from.x >= rect.x1 || from.y < rect.y0 || from.y >= rect.y1) continue;
      for_planes(sampled, maps, [&](auto& to, const auto& of) { to.at(x, y) = of.at(from.x, from.y); });
    }
  }
}

}  // namespace weftlight::cloth
