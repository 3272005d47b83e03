#pragma once
// Which rungs of `auto` the cloth on screen needs, and which share of it each draws, from the triangles' footprints.
// Knows no OpenGL and does not read pixels back; what hides behind other folds counts too.

#include <array>

#include "upload/ambient.h"
#include "upload/camera.h"
#include "upload/names.h"

namespace weftlight::upload {

/// So little of a rung changes no colour by what an eye could tell.
inline constexpr float kUnseenWeight = 0.05f;

struct RungShares {
  std::array<float, 4> of{};     // yarn, cell, repeat, cloth; sum 1, or all 0 without cloth on screen
  float yarns_per_pixel = 0;     // mean of the logarithm
  std::array<bool, 4> needed{};  // by more than a few pixels
};
RungShares rung_shares(const PreparedMesh& mesh, const Camera& camera, int width, int height, float spacing_mm,
                       const std::array<float, 3>& edges);

}  // namespace weftlight::upload
