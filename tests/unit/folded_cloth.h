#pragma once
// A square of folds, with normals that are known by hand.

#include <cmath>
#include <glm/geometric.hpp>

#include "drape/mesh.h"

namespace weftlight {

constexpr float kFoldedSide = 80;  // mm

/// Folds run where u + slope * v is constant, a sine of about 30 mm along u; diagonals run along (1, 1). Faces +z.
inline drape::Mesh folded_cloth(float slope, int cells) {
  drape::Mesh mesh;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const drape::Vec2 uv = kFoldedSide / static_cast<float>(cells) * drape::Vec2(i, j);
      const float turn = 0.2f * (uv.x + slope * uv.y), rise = 0.8f * std::cos(turn);
      mesh.uv_mm.push_back(uv);
      mesh.position_mm.push_back({uv.x - kFoldedSide / 2, uv.y, 4 * std::sin(turn)});
      mesh.normal.push_back(glm::normalize(drape::Vec3(-rise, -slope * rise, 1)));
      mesh.tangent.push_back(glm::normalize(drape::Vec3(1, 0, rise)));
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = static_cast<uint32_t>(j * (cells + 1) + i), b = a + static_cast<uint32_t>(cells) + 1;
      mesh.index.insert(mesh.index.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

}  // namespace weftlight
