// Folds of few triangles are drawn as curved ones, without cracks.

#include "render_data/curved_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render_data/flyaways.h"

namespace weftlight::render_data {

using drape::Mesh;

namespace {

constexpr float kRadius = 10, kHeight = 40;  // mm

/// A tube along y of edges that turn by 15 degrees, or a flat sheet; at the seam the vertices are there twice.
PreparedMesh tube_or_sheet(bool tube) {
  constexpr int kAround = 24, kUp = 4;
  PreparedMesh prepared;
  Mesh& m = prepared.mesh;
  for (int y = 0; y <= kUp; ++y) {
    for (int x = 0; x <= kAround; ++x) {
      const float turn = 6.2831853f * static_cast<float>(x % kAround) / kAround;
      const float up = kHeight * static_cast<float>(y) / kUp,
                  along = kRadius * 6.2831853f * static_cast<float>(x) / kAround;
      const float s = tube ? std::sin(turn) : 0, c = tube ? std::cos(turn) : 1;
      m.position_mm.push_back(tube ? drape::Vec3{kRadius * s, up, kRadius * c} : drape::Vec3{along, up, 0});
      m.normal.push_back({s, 0, c});
      m.tangent.push_back({c, 0, -s});
      m.uv_mm.push_back({along, up});
    }
  }
  for (int y = 0; y < kUp; ++y) {
    for (int x = 0; x < kAround; ++x) {
      const auto a = static_cast<uint32_t>(y * (kAround + 1) + x), b = a + kAround + 1;
      m.index.insert(m.index.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  prepared.sky.resize(m.position_mm.size());
  prepared.fine = m.index;
  return prepared;
}

/// Largest distance of a triangle's middle from the tube.
float farthest_inside(const PreparedMesh& p) {
  float most = 0;
  for (size_t i = 0; i < p.fine.size(); i += 3) {
    const glm::vec3 middle =
        (p.mesh.position_mm[p.fine[i]] + p.mesh.position_mm[p.fine[i + 1]] + p.mesh.position_mm[p.fine[i + 2]]) / 3.0f;
    most = std::max(most, std::abs(kRadius - std::hypot(middle.x, middle.z)));
  }
  return most;
}

TEST(CurvedMesh, AFoldIsRound) {
  PreparedMesh tube = tube_or_sheet(true);
  const float flat = farthest_inside(tube);
  const std::vector<uint32_t> index = tube.mesh.index;
  split_curved_edges(tube);
  EXPECT_LT(farthest_inside(tube), 0.1f * flat);
  EXPECT_EQ(tube.mesh.index, index);
  ASSERT_EQ(tube.sky.size(), tube.mesh.position_mm.size());
  ASSERT_EQ(tube.mesh.uv_mm.size(), tube.mesh.position_mm.size());
  for (size_t v = 0; v < tube.mesh.normal.size(); ++v) {
    const glm::vec3 p = tube.mesh.position_mm[v];
    EXPECT_NEAR(glm::dot(tube.mesh.normal[v], glm::vec3(p.x, 0, p.z) / kRadius), 1, 1e-3f);
    EXPECT_NEAR(glm::dot(tube.mesh.tangent[v], tube.mesh.normal[v]), 0, 1e-4f);
    EXPECT_NEAR(tube.mesh.uv_mm[v].y, p.y, 1e-4f);
  }
}

TEST(CurvedMesh, HasNoCracks) {
  PreparedMesh tube = tube_or_sheet(true);
  split_curved_edges(tube);
  for (const Hem& hem : hems_of(tube.mesh, tube.fine)) {
    const float up = tube.mesh.position_mm[hem.from].y;
    EXPECT_EQ(up, tube.mesh.position_mm[hem.to].y);
    EXPECT_TRUE(up == 0 || up == kHeight) << up;
  }
}

TEST(CurvedMesh, FlatClothKeepsItsTriangles) {
  PreparedMesh sheet = tube_or_sheet(false);
  split_curved_edges(sheet);
  EXPECT_EQ(sheet.fine, sheet.mesh.index);
}

}  // namespace
}  // namespace weftlight::render_data
