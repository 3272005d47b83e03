// Normals and tangents of a draped mesh.

#include <algorithm>
#include <map>

#include "drape/mesh.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

/// One number for each distinct position; both sides of a seam get the same number.
std::vector<uint32_t> weld_by_position(const std::vector<Vec3>& positions) {
  std::map<Vec3, uint32_t, PositionOrder> numbers;
  std::vector<uint32_t> weld(positions.size());
  for (size_t i = 0; i < positions.size(); ++i) {
    weld[i] = numbers.emplace(positions[i], static_cast<uint32_t>(i)).first->second;
  }
  return weld;
}

/// Any unit vector at right angles to n.
Vec3 perpendicular(Vec3 n) {
  const Vec3 axis = std::fabs(n[0]) < 0.9f ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
  return unit(axis - n * dot(axis, n));
}

/// The angle at corner v[k] in radians. Normals weighted by it do not depend on which way the diagonal of a cell runs
/// (Thuermer and Wuethrich 1998).
float corner_angle(const Mesh& mesh, const uint32_t* v, int k) {
  const Vec3 at = mesh.position_mm[v[k]];
  const Vec3 e = mesh.position_mm[v[(k + 1) % 3]] - at, f = mesh.position_mm[v[(k + 2) % 3]] - at;
  return std::atan2(length(cross(e, f)), dot(e, f));
}

/// The triangle's normal, with the length of twice its area over the square of its longest side: the normal of a sliver
/// is unreliable, and its angle weight is large.
Vec3 weighted_normal(const Mesh& mesh, const uint32_t* v) {
  const Vec3 e = mesh.position_mm[v[1]] - mesh.position_mm[v[0]], f = mesh.position_mm[v[2]] - mesh.position_mm[v[0]];
  const float longest = std::max({dot(e, e), dot(f, f), dot(f - e, f - e)});
  return longest > 0 ? cross(e, f) / longest : Vec3{};
}

/// d position / du of a triangle times twice its uv area, with the sign that keeps it along +u.
Vec3 weft_direction(const Mesh& mesh, const uint32_t* v) {
  const Vec3 e1 = mesh.position_mm[v[1]] - mesh.position_mm[v[0]];
  const Vec3 e2 = mesh.position_mm[v[2]] - mesh.position_mm[v[0]];
  const Vec2 d1 = mesh.uv_mm[v[1]] - mesh.uv_mm[v[0]];
  const Vec2 d2 = mesh.uv_mm[v[2]] - mesh.uv_mm[v[0]];
  const float area = d1[0] * d2[1] - d2[0] * d1[1];
  const Vec3 along = e1 * d2[1] - e2 * d1[1];
  return area < 0 ? along * -1.0f : along;
}

}  // namespace

void compute_frames(Mesh& mesh) {
  const size_t count = mesh.position_mm.size();
  const std::vector<uint32_t> weld = weld_by_position(mesh.position_mm);
  std::vector<Vec3> normals(count, Vec3{}), tangents(count, Vec3{});
  for (size_t t = 0; t + 2 < mesh.index.size(); t += 3) {
    const uint32_t* v = &mesh.index[t];
    const Vec3 face = weighted_normal(mesh, v);
    const Vec3 along = weft_direction(mesh, v);
    for (int corner = 0; corner < 3; ++corner) {
      normals[weld[v[corner]]] += corner_angle(mesh, v, corner) * face;
      tangents[v[corner]] += along;
    }
  }
  mesh.normal.resize(count);
  mesh.tangent.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const Vec3 n = unit(normals[weld[i]]);
    const Vec3 flat = tangents[i] - n * dot(tangents[i], n);
    mesh.normal[i] = n;
    mesh.tangent[i] = unit(flat, perpendicular(n));
  }
}

}  // namespace weftlight::drape
