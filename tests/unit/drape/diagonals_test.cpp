// Diagonals of a mesh's cells, on folds whose normals are known by hand.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../folded_cloth.h"
#include "drape/mesh.h"

namespace weftlight::drape {
namespace {

constexpr int kCells = 16;
constexpr float kCell = kFoldedSide / kCells;  // mm

Mesh folded(float slope) { return folded_cloth(slope, kCells); }

float uv_area(const Mesh& mesh, const uint32_t* v) {
  const Vec2 e = mesh.uv_mm[v[1]] - mesh.uv_mm[v[0]], f = mesh.uv_mm[v[2]] - mesh.uv_mm[v[0]];
  return (e.x * f.y - e.y * f.x) / 2;
}

/// Light from the side at a place of the pattern, between its triangle's corners as a renderer interpolates it.
float light_at(const Mesh& mesh, Vec2 uv) {
  const Vec3 towards = glm::normalize(Vec3{1, 1, 0.5f});
  for (size_t t = 0; t < mesh.index.size(); t += 3) {
    const uint32_t* v = &mesh.index[t];
    const auto part = [&](uint32_t p, uint32_t q) {
      const Vec2 e = mesh.uv_mm[p] - uv, f = mesh.uv_mm[q] - uv;
      return (e.x * f.y - e.y * f.x) / (2 * uv_area(mesh, v));
    };
    const float a = part(v[1], v[2]), b = part(v[2], v[0]), c = part(v[0], v[1]);
    if (std::min({a, b, c}) < -1e-4f) continue;
    return glm::dot(glm::normalize(a * mesh.normal[v[0]] + b * mesh.normal[v[1]] + c * mesh.normal[v[2]]), towards);
  }
  return NAN;
}

/// The largest change of the light along lines on which a fold of slope 1 has one normal.
float teeth(const Mesh& mesh) {
  float most = 0;
  for (int line = 0; line < 30; ++line) {
    const float across = 60 + 1.3f * static_cast<float>(line);
    float low = 1, high = -1;
    for (int step = -20; step <= 20; ++step) {
      const float along = 0.7f * static_cast<float>(step);
      const float light = light_at(mesh, {across / 2 + along, across / 2 - along});
      low = std::min(low, light), high = std::max(high, light);
    }
    most = std::max(most, high - low);
  }
  return most;
}

TEST(Diagonals, LightIsTheSameAllAlongAFold) {
  Mesh mesh = folded(1);
  EXPECT_GT(teeth(mesh), 0.1f);
  turn_diagonals(mesh);
  EXPECT_LT(teeth(mesh), 1e-4f);
}

TEST(Diagonals, ThoseAlongTheFoldStay) {
  Mesh mesh = folded(-1);
  const std::vector<uint32_t> before = mesh.index;
  turn_diagonals(mesh);
  EXPECT_EQ(mesh.index, before);
}

TEST(Diagonals, TrianglesCoverThePatternAsBefore) {
  for (const float slope : {1.0f, 0.3f, -0.4f, 2.5f}) {
    Mesh mesh = folded(slope);
    turn_diagonals(mesh);
    ASSERT_EQ(mesh.index.size(), size_t{6} * kCells * kCells);
    float longest = 0;
    for (size_t t = 0; t < mesh.index.size(); t += 3) {
      const uint32_t* v = &mesh.index[t];
      EXPECT_NEAR(uv_area(mesh, v), kCell * kCell / 2, 1e-3f) << slope << ' ' << t / 3;
      for (size_t k = 0; k < 3; ++k)
        longest = std::max(longest, glm::distance(mesh.uv_mm[v[k]], mesh.uv_mm[v[(k + 1) % 3]]));
    }
    EXPECT_NEAR(longest, kCell * std::sqrt(2.0f), 1e-3f) << slope << ": an edge of a cell was turned";
  }
}

TEST(Diagonals, FlatClothStaysAsItIs) {
  Mesh mesh = folded(1);
  std::fill(mesh.normal.begin(), mesh.normal.end(), Vec3{0, 0, 1});
  const std::vector<uint32_t> before = mesh.index;
  turn_diagonals(mesh);
  EXPECT_EQ(mesh.index, before);
}

/// Two triangles that meet between vertices 0 and 1, which the other two corners would join better.
Mesh two_triangles() {
  Mesh mesh;
  mesh.uv_mm = {{0, 0}, {1, 1}, {0, 1}, {1, 0}};
  for (const Vec2 uv : mesh.uv_mm) mesh.position_mm.push_back({uv, 0});
  mesh.normal = {{0.6f, 0, 0.8f}, {-0.6f, 0, 0.8f}, {0, 0, 1}, {0, 0, 1}};
  mesh.tangent.assign(4, {1, 0, 0});
  mesh.index = {0, 1, 2, 1, 0, 3};
  return mesh;
}

TEST(Diagonals, OnlyTwoTrianglesOfOneCellAreTurned) {
  Mesh mesh = two_triangles();
  turn_diagonals(mesh);
  EXPECT_EQ(mesh.index, (std::vector<uint32_t>{0, 3, 2, 3, 1, 2}));

  const auto expect_kept = [](const char* what, Mesh odd) {
    const std::vector<uint32_t> before = odd.index;
    turn_diagonals(odd);
    EXPECT_EQ(odd.index, before) << what;
  };
  Mesh odd = two_triangles();
  odd.index.insert(odd.index.end(), {0, 1, 3});
  expect_kept("three triangles at one edge", odd);
  odd = two_triangles();
  std::swap(odd.index[4], odd.index[3]);
  expect_kept("triangles that face opposite ways", odd);
  odd = two_triangles();
  odd.uv_mm[3] = {1.6f, 1.2f};
  expect_kept("a quadrangle with a corner that turns inwards", odd);
  odd = two_triangles();
  odd.uv_mm.assign(4, {0, 0});
  expect_kept("a pattern without area", odd);
  odd.uv_mm.clear();
  expect_kept("no pattern", odd);
  odd = two_triangles();
  odd.index = {0, 1};
  expect_kept("no whole triangle", odd);
}

}  // namespace
}  // namespace weftlight::drape
