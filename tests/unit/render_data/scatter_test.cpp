// Roots of flyaway fibres are as many and as evenly spread as they should be. Each test fails with probability
// kFalseAlarm for a sound scatterer with other random numbers.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "../statistics.h"
#include "designs.h"
#include "render_data/flyaways.h"

namespace weftlight::render_data {

using drape::Mesh;

namespace {

constexpr float kLength = 40;  // mm

/// Seen edge-on, so that every root counts, with pixels far smaller than a fibre.
FlyawayView edge_on() {
  FlyawayView view;
  view.width = view.height = 16000;
  view.eye = {0, -1e6f, 0};
  view.world_to_clip = glm::scale(glm::mat4(1), glm::vec3(0.5f / kLength, 0.5f / kLength, 1e-3f));
  return view;
}

PreparedMesh sheet() {
  PreparedMesh prepared;
  Mesh& m = prepared.mesh;
  m.position_mm = {{0, 0, 0}, {kLength, 0, 0}, {0, kLength / 2, 0}};
  m.normal.assign(3, {0, 0, 1});
  m.uv_mm = {{0, 0}, {kLength, 0}, {0, kLength / 2}};
  return prepared;
}

FlyawayGrowth growth(float per_mm2) { return {{per_mm2, per_mm2}, {2, 2}, 0.5f}; }

TEST(Scatter, RootsOfAHemAreEvenAlongAndAroundIt) {
  const PreparedMesh prepared = sheet();
  const FlyawayGrowth wool = growth(600);
  const std::vector<Flyaway> roots = scatter_flyaways(prepared, {{0, 1, {0, -1, 0}}}, {0, 0}, wool, edge_on());
  double stand_for = 0;
  constexpr size_t kAlong = 20, kAround = 8;
  std::vector<double> counted(kAlong * kAround);
  for (const Flyaway& f : roots) {
    stand_for += static_cast<double>(f.stands_for);
    const glm::vec3 out = f.normal;
    const double along = static_cast<double>(f.root.x / kLength),
                 around = static_cast<double>(std::atan2(out.z, -out.y)) / std::numbers::pi + 0.5;
    ++counted[std::min(static_cast<size_t>(along * kAlong), kAlong - 1) * kAround +
              std::min(static_cast<size_t>(std::max(around, 0.0) * kAround), kAround - 1)];
  }
  ASSERT_GT(roots.size(), 5000u);
  EXPECT_GT(chi_square(counted, std::vector<double>(counted.size(), 1)), kFalseAlarm);
  const double expected = static_cast<double>(kLength) * std::numbers::pi * 0.5 * 600;
  EXPECT_NEAR(stand_for / expected, 1, 4 / std::sqrt(static_cast<double>(roots.size()))) << "four standard deviations";
}

TEST(Scatter, RootsOfATriangleAreEvenOverItsArea) {
  PreparedMesh prepared = sheet();
  prepared.fine = {0, 1, 2};
  const std::vector<Flyaway> roots = scatter_flyaways(prepared, {}, {0, 0}, growth(40), edge_on());
  ASSERT_GT(roots.size(), 5000u);
  constexpr size_t kCells = 12;
  std::vector<double> counted(kCells * kCells * 2);
  for (const Flyaway& f : roots) {
    // Barycentric: the part of the triangle beyond the line through the root, and the root's place on that line.
    const double u = static_cast<double>(f.root.x / kLength), v = static_cast<double>(f.root.y / (kLength / 2));
    const double beyond = (u + v) * (u + v), on = v / std::max(u + v, 1e-9);
    const auto cell = [](double at) { return std::min(static_cast<size_t>(at * kCells), kCells - 1); };
    ++counted[(f.side > 0 ? 0 : kCells * kCells) + cell(beyond) * kCells + cell(on)];
  }
  EXPECT_GT(chi_square(counted, std::vector<double>(counted.size(), 1)), kFalseAlarm);
}

}  // namespace
}  // namespace weftlight::render_data
