#pragma once
// A draped cloth: triangles in millimetres with physical texture coordinates, millimetres along weft (u)
// and warp (v). +y is up, front is +z. Right-handed; counter-clockwise faces the front of the cloth.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace weftlight {

using Vec3 = std::array<float, 3>;
using Vec2 = std::array<float, 2>;

struct Mesh {
  std::string name;
  std::vector<Vec3> position_mm;
  std::vector<Vec3> normal;
  std::vector<Vec3> tangent;   // unit d position / du (along the weft)
  std::vector<Vec2> uv_mm;
  std::vector<uint32_t> index; // three a triangle
};

/// Fills normals (area-weighted) and tangents from positions and uv.
void compute_frames(Mesh& mesh);

/// Names of the shipped drapes, in menu order: plane, sphere, tablecloth, curtain, skirt, tunic.
const std::vector<std::string>& drape_names();

/// Simulates a shipped drape. Deterministic. `steps_scale` < 1 for quick tests.
Mesh simulate_drape(const std::string& name, float steps_scale = 1.0f);

}  // namespace weftlight
