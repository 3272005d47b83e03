#pragma once
// A draped cloth: triangles in millimetres, with texture coordinates in millimetres along weft (u) and warp (v). +y is
// up, front is +z. Right-handed; counter-clockwise faces the front of the cloth.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace weftlight::drape {

using Vec3 = glm::vec3;
using Vec2 = glm::vec2;

/// Order for tables of positions: by x, then y, then z.
struct PositionOrder {
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
  std::vector<uint32_t> index;  // three per triangle
};

/// Fills normals (weighted by the corners' angles) and tangents from positions and uv. Vertices at the same position
/// (the two sides of a seam) share their normal; each keeps its own tangent, at right angles to it.
void compute_frames(Mesh& mesh);

/// Turns the diagonals of a mesh's cells the way along which normals differ less, which is along folds. Across a fold
/// they give the light on it teeth, since light is interpolated along them.
void turn_diagonals(Mesh& mesh);

/// Names of the shipped drapes, in menu order: plane, sphere, tablecloth, curtain, skirt, tunic, shirt, scarf, cushion.
const std::vector<std::string>& drape_names();

/// Simulates a shipped drape; the ground is y = 0. Deterministic. `steps_scale` < 1 shortens the simulated time, for
/// quick tests. Empty for unknown names.
Mesh simulate_drape(const std::string& name, float steps_scale = 1.0f);

/// The body under a shipped drape (table, ball, rod, dress form), drawn in a neutral material: with normals and
/// tangents, uv all zero. No vertices for the plane and for unknown names.
Mesh body_mesh(const std::string& name);

}  // namespace weftlight::drape
