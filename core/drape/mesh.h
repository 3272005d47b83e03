#pragma once
// A draped cloth: triangles in millimetres with physical texture coordinates, millimetres along weft (u)
// and warp (v). +y is up, front is +z. Right-handed; counter-clockwise faces the front of the cloth.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "drape/names.h"

namespace weftlight::drape {

using Vec3 = glm::vec3;
using Vec2 = glm::vec2;

/// For tables of places: by x, then y, then z.
struct PlaceOrder {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }
};

struct Mesh {
  std::string name;
  std::vector<Vec3> position_mm;
  std::vector<Vec3> normal;
  std::vector<Vec3> tangent;  // unit d position / du (along the weft)
  std::vector<Vec2> uv_mm;
  std::vector<uint32_t> index;  // three a triangle
};

/// Fills normals (weighted by the corners' angles) and tangents from positions and uv. Vertices at the very same place
/// (the two sides of a seam) share their normal; each keeps its own tangent, at right angles to it.
void compute_frames(Mesh& mesh);

/// Names of the shipped drapes, in menu order: plane, sphere, tablecloth, curtain, skirt, tunic, shirt, scarf, cushion.
const std::vector<std::string>& drape_names();

/// Simulates a shipped drape; the ground is y = 0. Deterministic. `steps_scale` < 1 shortens the
/// simulated time, for quick tests. Empty for unknown names.
Mesh simulate_drape(const std::string& name, float steps_scale = 1.0f);

/// What a shipped drape lies on (table, ball, rod, dress form), to be drawn under it in a neutral
/// material: normals and a right-angled tangent, uv all zero. Empty (no vertices) for the plane and
/// for unknown names.
Mesh body_mesh(const std::string& name);

}  // namespace weftlight::drape
