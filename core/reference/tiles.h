#pragma once
// A ray through the tiles of a cloth that repeats.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

namespace weftlight::reference {

/// The part of the cloth that is kept: [0, size] where it repeats; where it does not, size is infinite.
struct Tiling {
  glm::vec2 size{std::numeric_limits<float>::infinity()};
  float z_min = 0, z_max = 0;
};

// A ray almost in the plane would cross tiles for ever; this is more than any light at 89.9 degrees crosses before it
// leaves the cloth.
inline constexpr int kMaxTiles = 4096;

/// Visits the tiles that a ray crosses: visit(origin in the tile, t_near, t_far) returns true to stop. Whether one did.
template <class Visit>
bool walk_tiles(const Tiling& tiling, glm::vec3 origin, glm::vec3 direction, float t_min, Visit visit) {
  float t0 = t_min, t1 = std::numeric_limits<float>::infinity();
  if (std::abs(direction.z) > 1e-12f) {
    const float a = (tiling.z_min - origin.z) / direction.z, b = (tiling.z_max - origin.z) / direction.z;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::max(a, b);
  } else if (origin.z < tiling.z_min || origin.z > tiling.z_max) {
    return false;
  }
  float whole = 0;
  for (int k = 0; k < 2; ++k)
    if (std::isfinite(tiling.size[k])) whole += tiling.size[k];
  const float epsilon = 1e-5f * whole;  // a point this far beyond t0 lies in the tile that the ray enters
  for (int tiles = 0; tiles < kMaxTiles && t0 <= t1; ++tiles) {
    const glm::vec3 p = origin + direction * (t0 + epsilon);
    glm::vec3 local = origin;
    float exit = t1;
    for (int k = 0; k < 2; ++k) {
      if (!std::isfinite(tiling.size[k])) continue;
      local[k] -= std::floor(p[k] / tiling.size[k]) * tiling.size[k];
      if (direction[k] > 0) exit = std::min(exit, (tiling.size[k] - local[k]) / direction[k]);
      if (direction[k] < 0) exit = std::min(exit, -local[k] / direction[k]);
    }
    exit = std::max(exit, t0 + epsilon);
    if (visit(local, t0, exit)) return true;
    t0 = exit;
    if (exit >= t1) break;
  }
  return false;
}

}  // namespace weftlight::reference
