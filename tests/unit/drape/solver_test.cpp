// The solver against results computed by hand, on small cloths.

#include "drape/solver.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drape/bodies.h"
#include "drape/pairs.h"

namespace weftlight::drape {
namespace {

float nothing_near(Vec3) { return 1e6f; }

Pattern sheet(int columns, int rows, float cell_mm, float height_mm) {
  Pattern pattern;
  const float width = cell_mm * static_cast<float>(columns - 1), depth = cell_mm * static_cast<float>(rows - 1);
  add_piece(
      pattern, columns, rows,
      [=](float s, float t) {
        return Vec2{s * width, t * depth};
      },
      [=](Vec2 uv) {
        return Vec3{uv[0] - width / 2, height_mm, depth / 2 - uv[1]};
      });
  return pattern;
}

Fall seconds(double s) {
  Fall settings;
  settings.seconds = s;
  return settings;
}

TEST(Solver, FreeFallFollowsGravity) {
  SimulatedCloth cloth = make_cloth(sheet(5, 5, 10, 1000), {}, 10);
  Fall settings = seconds(0.2);
  settings.drag_per_second = 0;
  simulate(cloth, nothing_near, settings);
  const double fallen = 0.5 * 9810 * 0.2 * 0.2;
  for (const Vec3d& p : cloth.position) EXPECT_NEAR(1000 - p[1], fallen, 0.02 * fallen);
}

TEST(Solver, MassFollowsTheArea) {
  const Fabric fabric;
  const SimulatedCloth cloth = make_cloth(sheet(11, 21, 10, 0), fabric, 10);
  double mass = 0;
  for (const double w : cloth.inverse_mass) mass += 1 / w;
  EXPECT_NEAR(mass, fabric.kg_per_m2 * 0.1 * 0.2, 1e-9);
}

TEST(Solver, AFlatSheetIsAtRest) {
  const SimulatedCloth cloth = make_cloth(sheet(6, 6, 10, 0), {}, 10);
  for (const Bend& bend : cloth.bends) {
    Vec3d sum{};
    for (size_t k = 0; k < 4; ++k) sum += cloth.position[bend.particle[k]] * bend.weight[k];
    EXPECT_NEAR(length(sum), 0, 1e-4);
  }
  for (const Stretch& s : cloth.stretches) {
    EXPECT_NEAR(length(cloth.position[s.a] - cloth.position[s.b]), s.rest_mm, 1e-4);
  }
}

TEST(Solver, RestsOnTheGroundAtTheBodyGap) {
  SimulatedCloth cloth = make_cloth(sheet(9, 9, 10, 30), {}, 10);
  const Fall settings = seconds(1.5);
  simulate(cloth, ground, settings);
  for (const Vec3d& p : cloth.position) EXPECT_NEAR(p[1], settings.body_gap_mm, 0.1);
}

TEST(Solver, FrictionHoldsOnAGentleSlopeAndNotOnASteepOne) {
  const auto slid_mm = [](float slope) {
    const float c = 1 / std::sqrt(1 + slope * slope);
    Pattern pattern = sheet(5, 5, 10, 0);
    for (Vec3& p : pattern.position_mm) p[1] = slope * p[0] + 3.5f / c;
    SimulatedCloth cloth = make_cloth(pattern, {}, 10);
    const double before = cloth.position[12][0];
    simulate(
        cloth, [=](Vec3 p) { return (p[1] - slope * p[0]) * c; }, seconds(0.3));
    return before - cloth.position[12][0];
  };
  EXPECT_LT(slid_mm(0.2f), 3);   // friction 0.4 holds
  EXPECT_GT(slid_mm(1.0f), 30);  // and cannot here
}

TEST(Solver, AHeldRowCarriesTheSheet) {
  Pattern pattern = sheet(5, 21, 10, 500);
  SimulatedCloth cloth = make_cloth(pattern, {}, 10);
  for (size_t i = 100; i < 105; ++i) cloth.inverse_mass[i] = 0;
  simulate(cloth, nothing_near, seconds(3));
  for (size_t i = 100; i < 105; ++i) EXPECT_EQ(cloth.position[i], Vec3d(pattern.position_mm[i]));
  EXPECT_NEAR(cloth.position[2][1], 500 - 200, 6);  // hangs straight down, hardly stretched
}

/// A strip that hangs from its upper row, folded to a right angle along its middle and held for a third of a second.
/// Returns its width at the bottom after the release: 1 flat, 0 folded.
double unbent(double crease_per_mm) {
  Pattern pattern;
  constexpr int kColumns = 9, kRows = 13;
  add_piece(
      pattern, kColumns, kRows,
      [](float s, float t) {
        return Vec2{80 * s, 120 * t};
      },
      [](Vec2 uv) {
        const float out = (uv[0] - 40) * 0.7071f;
        return Vec3{out, 500 + uv[1], std::fabs(out)};
      });
  Fabric fabric;
  fabric.crease_per_mm = crease_per_mm;
  SimulatedCloth cloth = make_cloth(pattern, fabric, 14);
  const std::vector<double> free = cloth.inverse_mass;
  std::fill(cloth.inverse_mass.begin(), cloth.inverse_mass.end(), 0.0);
  Fall settings = seconds(2);
  settings.move_held = [&](SimulatedCloth& held, double time, double) {
    if (time > 0.33) std::copy_n(free.begin(), kColumns * (kRows - 1), held.inverse_mass.begin());
  };
  simulate(cloth, nothing_near, settings);
  return length(cloth.position[kColumns - 1] - cloth.position[0]) / 80;
}

TEST(Solver, AHeldFoldStaysInClothThatCreases) {
  EXPECT_GT(unbent(0), 0.85);
  EXPECT_LT(unbent(0.03), 0.8);
}

TEST(Solver, ASeamHasTheLengthOfItsShorterSide) {
  Pattern pattern;
  const auto place = [](Vec2 uv) { return Vec3{uv[0], 500 + uv[1], 0}; };
  const Piece wide = add_piece(
      pattern, 11, 3,
      [](float s, float t) {
        return Vec2{100 * s, 20 * t - 20};
      },
      place);
  const Piece band = add_piece(
      pattern, 11, 3,
      [](float s, float t) {
        return Vec2{60 * s, 20 * t};
      },
      place);
  for (int k = 0; k < 11; ++k) sew(pattern, wide.vertex(k, 2), band.vertex(k, 0));
  const SimulatedCloth cloth = make_cloth(pattern, {}, 14);
  const uint32_t a = pattern.particle[band.vertex(3, 0)], b = pattern.particle[band.vertex(4, 0)];
  const auto seam = std::find_if(cloth.stretches.begin(), cloth.stretches.end(),
                                 [&](const Stretch& s) { return std::minmax(s.a, s.b) == std::minmax(a, b); });
  ASSERT_NE(seam, cloth.stretches.end());
  EXPECT_NEAR(seam->rest_mm, 6, 1e-4);
}

TEST(Smoothing, RemovesWavesOfACellAndKeepsThoseOfEight) {
  const auto height = [](float wave_cells) {
    Pattern pattern = sheet(33, 9, 10, 0);
    for (uint32_t i = 0; i < pattern.position_mm.size(); ++i)
      pattern.position_mm[i][1] = std::cos(2 * 3.14159265f * static_cast<float>(i % 33) / wave_cells);
    smooth_cell_waves(pattern, 4);
    return pattern.position_mm[4 * 33 + 16][1];
  };
  EXPECT_LT(std::fabs(height(2)), 0.3f);
  EXPECT_GT(height(8), 0.93f);
}

TEST(Solver, SheetsStayApart) {
  Pattern pattern = sheet(9, 9, 10, 5);
  add_piece(
      pattern, 9, 9,
      [](float s, float t) {
        return Vec2{80 * s, 80 * t};
      },
      [](Vec2 uv) {
        return Vec3{uv[0] - 37, 20, 43 - uv[1]};
      });
  SimulatedCloth cloth = make_cloth(pattern, {}, 14);
  Fall settings = seconds(1.5);
  simulate(cloth, ground, settings);
  for (size_t i = 0; i < 81; ++i) EXPECT_NEAR(cloth.position[i][1], settings.body_gap_mm, 0.5);
  for (size_t i = 81; i < 162; ++i) EXPECT_GT(cloth.position[i][1], settings.body_gap_mm + 2);
}

TEST(Pairs, FindsWhatABruteForceSearchFinds) {
  Pattern pattern = sheet(12, 12, 4, 0);
  for (size_t i = 0; i < pattern.position_mm.size(); ++i) {
    const float phi = 0.5f * static_cast<float>(i % 12);  // rolled up, so that turns lie near each other
    pattern.position_mm[i] = {7 * std::sin(phi), 0.3f * static_cast<float>(i), 7 * std::cos(phi)};
  }
  const SimulatedCloth cloth = make_cloth(pattern, {}, 9);
  std::vector<ParticlePair> pairs;
  find_pairs(cloth, 8, pairs);
  size_t expected = 0;
  for (uint32_t a = 0; a < cloth.position.size(); ++a) {
    for (uint32_t b = a + 1; b < cloth.position.size(); ++b) {
      const auto first = cloth.near.begin() + cloth.near_first[a], last = cloth.near.begin() + cloth.near_first[a + 1];
      const bool near = std::find(first, last, b) != last;
      expected += !near && length(cloth.position[a] - cloth.position[b]) < 8;
    }
  }
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(pairs.size(), expected);
}

TEST(Bodies, DistancesAreExactAtKnownPoints) {
  EXPECT_NEAR(ball({0, 2 * kBallRadius + 7, 0}), 7, 1e-3f);
  EXPECT_NEAR(table({0, kTableHeight + 5, 0}), 5, 1e-3f);
  EXPECT_NEAR(table({kTableRadius + 9, kTableHeight - 14, 0}), 9, 1e-3f);
  EXPECT_LT(dress_form({0, 1100, 0}), 0);
  EXPECT_GT(dress_form({0, 1100, 200}), 0);
  EXPECT_EQ(dress_form({300, 1200, 10}), dress_form({-300, 1200, 10}));
}

}  // namespace
}  // namespace weftlight::drape
