// Which way the diagonals of a mesh's cells run.
// Based on: Dyn, Levin, Rippa 1990, "Data dependent triangulations for piecewise linear interpolation". Differs: edges
// of cells stay, and each cell is looked at once.

#include <algorithm>

#include "drape/mesh.h"
#include "drape/vec.h"

namespace weftlight::drape {

namespace {

/// From the corner at `at` of a mesh's index to the next one of its triangle.
struct HalfEdge {
  uint32_t low, high;  // its vertices
  size_t at;
};

/// Two triangles that meet in a diagonal from a to b: (a, b, c) and (b, a, d).
struct Cell {
  uint32_t a, b, c, d;
  size_t first, second;  // triangles
  float gain;            // by the other diagonal, in squared differences of normals
};

size_t next_corner(size_t at) { return at % 3 == 2 ? at - 2 : at + 1; }

std::vector<HalfEdge> sorted_half_edges(const Mesh& mesh) {
  std::vector<HalfEdge> edges(mesh.index.size() / 3 * 3);
  for (size_t i = 0; i < edges.size(); ++i) {
    const auto [low, high] = std::minmax(mesh.index[i], mesh.index[next_corner(i)]);
    edges[i] = {low, high, i};
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
    return x.low != y.low ? x.low < y.low : x.high != y.high ? x.high < y.high : x.at < y.at;
  });
  return edges;
}

template <class V>
float square(V v) {
  return glm::dot(v, v);
}

float uv_area(const Mesh& mesh, uint32_t a, uint32_t b, uint32_t c) {
  const Vec2 e = mesh.uv_mm[b] - mesh.uv_mm[a], f = mesh.uv_mm[c] - mesh.uv_mm[a];
  return e.x * f.y - e.y * f.x;
}

/// Area of a triangle's shadow on a plane: negative if it faces away from it.
float area_along(const Mesh& mesh, Vec3 normal, uint32_t a, uint32_t b, uint32_t c) {
  const Vec3 at = mesh.position_mm[a];
  return glm::dot(normal, glm::cross(mesh.position_mm[b] - at, mesh.position_mm[c] - at));
}

/// Whether the other diagonal divides the quadrangle about as evenly, by the areas of its triangles.
template <class Area>
bool divides_evenly(const Cell& q, const Area& area) {
  constexpr float kSmallest = 0.25f;
  const float whole = area(q.a, q.b, q.c) + area(q.b, q.a, q.d), sign = whole < 0 ? -1.0f : 1.0f;
  return std::min(sign * area(q.a, q.d, q.c), sign * area(q.d, q.b, q.c)) > kSmallest * sign * whole;
}

/// Whether the quadrangle has two diagonals that are about as long and divide it about as evenly, in the cloth and in
/// space, where a cell may be folded. Two triangles beside an edge of a cell have not.
bool has_two_diagonals(const Mesh& mesh, const Cell& q) {
  constexpr float kLonger = 1.5f;
  const float now = square(mesh.uv_mm[q.a] - mesh.uv_mm[q.b]), other = square(mesh.uv_mm[q.c] - mesh.uv_mm[q.d]);
  if (now > kLonger * kLonger * other || other > kLonger * kLonger * now) return false;
  const Vec3 normal = mesh.normal[q.a] + mesh.normal[q.b] + mesh.normal[q.c] + mesh.normal[q.d];
  return divides_evenly(q, [&](uint32_t a, uint32_t b, uint32_t c) { return uv_area(mesh, a, b, c); }) &&
         divides_evenly(q, [&](uint32_t a, uint32_t b, uint32_t c) { return area_along(mesh, normal, a, b, c); });
}

/// Cells whose other diagonal is better, the most urgent first.
std::vector<Cell> cells_to_turn(const Mesh& mesh) {
  constexpr float kLeastGain = 1e-6f;
  const std::vector<HalfEdge> edges = sorted_half_edges(mesh);
  const auto same = [&](size_t i, size_t k) { return edges[i].low == edges[k].low && edges[i].high == edges[k].high; };
  std::vector<Cell> cells;
  for (size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && same(i, end);) ++end;
    if (end != i + 2) continue;
    const size_t one = edges[i].at, two = edges[i + 1].at;
    if (mesh.index[one] == mesh.index[two]) continue;  // of triangles that face opposite ways
    Cell q{mesh.index[one],
           mesh.index[two],
           mesh.index[next_corner(next_corner(one))],
           mesh.index[next_corner(next_corner(two))],
           one / 3,
           two / 3,
           0};
    q.gain = square(mesh.normal[q.a] - mesh.normal[q.b]) - square(mesh.normal[q.c] - mesh.normal[q.d]);
    if (q.gain > kLeastGain && has_two_diagonals(mesh, q)) cells.push_back(q);
  }
  std::stable_sort(cells.begin(), cells.end(), [](const Cell& x, const Cell& y) { return x.gain > y.gain; });
  return cells;
}

}  // namespace

void turn_diagonals(Mesh& mesh) {
  const size_t count = mesh.position_mm.size();
  if (mesh.uv_mm.size() < count || mesh.normal.size() < count) return;
  std::vector<bool> turned(mesh.index.size() / 3, false);
  const auto set = [&](size_t triangle, uint32_t x, uint32_t y, uint32_t z) {
    const size_t at = 3 * triangle;
    mesh.index[at] = x, mesh.index[at + 1] = y, mesh.index[at + 2] = z, turned[triangle] = true;
  };
  for (const Cell& q : cells_to_turn(mesh)) {
    if (turned[q.first] || turned[q.second]) continue;
    set(q.first, q.a, q.d, q.c);
    set(q.second, q.d, q.b, q.c);
  }
}

}  // namespace weftlight::drape
