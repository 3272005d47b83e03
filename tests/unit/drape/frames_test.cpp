// Frames of surfaces whose normals and tangents are known by hand.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "drape/mesh.h"

namespace weftlight::drape {
namespace {

template <class Surface>
Mesh grid(int columns, int rows, float width, float depth, Surface surface) {
  Mesh mesh;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float u = width * static_cast<float>(i) / static_cast<float>(columns - 1);
      const float v = depth * static_cast<float>(j) / static_cast<float>(rows - 1);
      mesh.uv_mm.push_back({u, v});
      mesh.position_mm.push_back(surface(u, v));
    }
  }
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const auto a = static_cast<uint32_t>(j * columns + i), c = static_cast<uint32_t>(columns);
      mesh.index.insert(mesh.index.end(), {a, a + 1, a + c + 1, a, a + c + 1, a + c});
    }
  }
  compute_frames(mesh);
  return mesh;
}

TEST(Frames, FlatSwatchFacesFrontWithTheWeftAlongX) {
  const Mesh mesh = grid(4, 3, 30, 20, [](float u, float v) { return Vec3{u, v, 0}; });
  for (size_t i = 0; i < mesh.position_mm.size(); ++i) {
    EXPECT_EQ(mesh.normal[i], (Vec3{0, 0, 1}));
    EXPECT_EQ(mesh.tangent[i], (Vec3{1, 0, 0}));
  }
}

TEST(Frames, CylinderHasRadialNormalsAndTheWeftRoundIt) {
  const float radius = 100;
  const Mesh mesh = grid(64, 8, radius, 50, [&](float u, float v) {
    return Vec3{radius * std::sin(u / radius), v, radius * std::cos(u / radius)};
  });
  for (size_t i = 0; i < mesh.position_mm.size(); ++i) {
    const float phi = mesh.uv_mm[i][0] / radius;
    EXPECT_GT(dot(mesh.normal[i], {std::sin(phi), 0, std::cos(phi)}), 0.9999f);
    EXPECT_GT(dot(mesh.tangent[i], {std::cos(phi), 0, -std::sin(phi)}), 0.9999f);
    EXPECT_NEAR(dot(mesh.tangent[i], mesh.normal[i]), 0, 1e-5f);
  }
}

TEST(Frames, SpherePatchHasRadialNormals) {
  const float radius = 80;
  const Mesh mesh = grid(40, 40, 1, 1, [&](float u, float v) {
    const float phi = (u - 0.5f) * 1.2f, theta = (v - 0.5f) * 1.2f;
    return Vec3{radius * std::cos(theta) * std::sin(phi), radius * std::sin(theta),
                radius * std::cos(theta) * std::cos(phi)};
  });
  for (size_t i = 0; i < mesh.position_mm.size(); ++i) {
    const Vec3 p = mesh.position_mm[i];
    EXPECT_GT(dot(mesh.normal[i], {p[0] / radius, p[1] / radius, p[2] / radius}), 0.9995f);
    EXPECT_NEAR(mesh.tangent[i][1], 0, 0.02f);
  }
}

TEST(Frames, BothSidesOfASeamShareTheNormalAndKeepTheirOwnTangent) {
  // A ridge of two squares, each with uv of its own; the second one's weft runs the other way.
  Mesh mesh;
  mesh.position_mm = {{-1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {-1, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}};
  mesh.uv_mm = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}};
  mesh.index = {0, 1, 2, 0, 2, 3, 4, 5, 7, 5, 6, 7};
  compute_frames(mesh);
  EXPECT_EQ(mesh.normal[1], mesh.normal[4]);
  EXPECT_NEAR(mesh.normal[1][2], 1, 1e-6f);
  EXPECT_NEAR(mesh.tangent[1][0], 1, 1e-6f);
  EXPECT_NEAR(mesh.tangent[4][0], -1, 1e-6f);
}

TEST(Frames, ASliverThatStandsUpHardlyTurnsTheNormal) {
  // A square and, upright on the middle of one of its edges, a triangle a thousandth high by its blunt corner.
  Mesh mesh;
  mesh.position_mm = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}, {0, 0, 0.001f}, {2, 0, 0.001f}};
  mesh.uv_mm = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {0, 0}, {2, 0}};
  mesh.index = {0, 4, 3, 4, 2, 3, 4, 1, 2, 4, 5, 6};
  compute_frames(mesh);
  EXPECT_GT(mesh.normal[4][2], 0.999f);
}

TEST(Frames, DegenerateTrianglesGiveUnitVectors) {
  Mesh mesh;
  mesh.position_mm = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  mesh.uv_mm = {{0, 0}, {0, 0}, {0, 0}};
  mesh.index = {0, 1, 2};
  compute_frames(mesh);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(dot(mesh.normal[i], mesh.normal[i]), 1, 1e-6f);
    EXPECT_NEAR(dot(mesh.tangent[i], mesh.tangent[i]), 1, 1e-6f);
  }
}

}  // namespace
}  // namespace weftlight::drape
