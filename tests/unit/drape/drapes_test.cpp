// The shipped drapes: quick simulations, and the fully simulated meshes in presets.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "drape/bodies.h"
#include "drape/garments.h"
#include "drape/mesh.h"
#include "drape/stiffness.h"
#include "files/files.h"

namespace weftlight::drape {

using base::presets_dir, base::problem_of;

using drape::Mesh;
using files::read_mesh;
namespace {

constexpr float kQuick = 0.01f;

Mesh shipped(const std::string& name) {
  const base::Result<Mesh> read = read_mesh(presets_dir() + "/meshes/" + name + ".glb");
  EXPECT_TRUE(read) << problem_of(read);
  return read.value_or(Mesh{});
}

class EachDrape : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, EachDrape, testing::ValuesIn(drape_names()), [](const auto& p) { return p.param; });

TEST_P(EachDrape, IsTheSameBitForBitTwice) {
  const Mesh one = simulate_drape(GetParam(), kQuick), two = simulate_drape(GetParam(), kQuick);
  EXPECT_EQ(one.position_mm, two.position_mm);
  EXPECT_EQ(one.normal, two.normal);
  EXPECT_EQ(one.tangent, two.tangent);
}

TEST_P(EachDrape, ShippedMeshHasTheTopologyAndPatternOfItsSimulation) {
  const Mesh quick = simulate_drape(GetParam(), kQuick), mesh = shipped(GetParam());
  EXPECT_EQ(mesh.index, quick.index);
  ASSERT_EQ(mesh.uv_mm.size(), quick.uv_mm.size());
  for (size_t i = 0; i < mesh.uv_mm.size(); ++i) {
    EXPECT_NEAR(mesh.uv_mm[i][0], quick.uv_mm[i][0], 1e-3f);
    EXPECT_NEAR(mesh.uv_mm[i][1], quick.uv_mm[i][1], 1e-3f);
  }
}

TEST_P(EachDrape, FramesAreUnitAndAgreeWithTheTriangles) {
  const Mesh mesh = shipped(GetParam());
  for (size_t i = 0; i < mesh.position_mm.size(); ++i) {
    ASSERT_NEAR(dot(mesh.normal[i], mesh.normal[i]), 1, 1e-3f);
    ASSERT_NEAR(dot(mesh.tangent[i], mesh.tangent[i]), 1, 1e-3f);
    ASSERT_NEAR(dot(mesh.tangent[i], mesh.normal[i]), 0, 1e-3f);
  }
  size_t turned = 0;
  for (size_t t = 0; t < mesh.index.size(); t += 3) {
    const Vec3 a = mesh.position_mm[mesh.index[t]], b = mesh.position_mm[mesh.index[t + 1]],
               c = mesh.position_mm[mesh.index[t + 2]];
    const Vec3 e = b - a, f = c - a, n = glm::cross(e, f);
    turned += dot(n, mesh.normal[mesh.index[t]]) <= 0;
  }
  EXPECT_LE(turned, mesh.index.size() / 3 / 200);  // only in the sharpest creases
}

/// Relative stretch of the edges along warp or weft, sorted.
std::vector<float> thread_stretch(const Mesh& mesh) {
  std::vector<float> stretch;
  for (size_t t = 0; t < mesh.index.size(); ++t) {
    const uint32_t a = mesh.index[t], b = mesh.index[t % 3 == 2 ? t - 2 : t + 1];
    const float du = mesh.uv_mm[b][0] - mesh.uv_mm[a][0], dv = mesh.uv_mm[b][1] - mesh.uv_mm[a][1];
    const float flat = std::hypot(du, dv);
    if (std::min(std::fabs(du), std::fabs(dv)) > 0.05f * flat) continue;
    stretch.push_back(distance(mesh.position_mm[a], mesh.position_mm[b]) / flat - 1);
  }
  std::sort(stretch.begin(), stretch.end());
  return stretch;
}

TEST_P(EachDrape, PatternLengthsAreClothLengths) {
  const std::vector<float> stretch = thread_stretch(shipped(GetParam()));
  ASSERT_FALSE(stretch.empty());
  EXPECT_NEAR(stretch[stretch.size() / 2], 0, 0.01f);
  // Tops: up to two percent of the threads are shorter in creases and gathers, or longer in bands that carry weight.
  const bool is_top = GetParam() == "tunic" || GetParam() == "shirt";
  EXPECT_GT(stretch[stretch.size() / 50], is_top ? -0.13f : -0.05f);
  EXPECT_LT(stretch[stretch.size() * 49 / 50], is_top ? 0.06f : 0.05f);
}

/// Number of vertices inside the body; `lowered`: how far the mesh was lowered.
template <class Body>
int inside(const Mesh& mesh, Body body, float lowered) {
  return static_cast<int>(std::count_if(mesh.position_mm.begin(), mesh.position_mm.end(), [&](Vec3 p) {
    return body(Vec3{p[0], p[1] + lowered, p[2]}) < -0.5f;
  }));
}

// A slit between them would be black.
TEST(Drapes, TheFormFillsTheSkirtAtItsWaist) {
  const Mesh skirt = shipped("skirt");
  float top = 0;
  for (const Vec3 p : skirt.position_mm) top = std::max(top, p[1] + kSkirtLowered);
  EXPECT_NEAR(top, kWaistHeight, 1);
  int on_the_waist = 0;
  for (const Vec3 p : skirt.position_mm) {
    const Vec3 in_room{p[0], p[1] + kSkirtLowered, p[2]};
    if (in_room[1] < top - 0.5f) continue;
    ++on_the_waist;
    EXPECT_LT(taped_skirt_form(in_room), 1);
  }
  EXPECT_GT(on_the_waist, 40);
}

constexpr std::array<const char*, 6> kTops{"tunic", "tunic_limp", "tunic_stiff", "shirt", "shirt_limp", "shirt_stiff"};

TEST(Drapes, NoVertexIsInsideItsBodyOrTheGround) {
  EXPECT_EQ(inside(shipped("sphere"), ball, 0), 0);
  EXPECT_EQ(inside(shipped("tablecloth"), table, 0), 0);
  for (const char* name : {"skirt", "skirt_limp", "skirt_stiff"})
    EXPECT_EQ(inside(shipped(name), taped_skirt_form, kSkirtLowered), 0) << name;
  const auto arms_down = [arm = lowered_arm(1)](Vec3 p) { return form_with(arm, p); };
  for (const char* name : kTops) EXPECT_EQ(inside(shipped(name), arms_down, kTunicLowered), 0) << name;
  for (const char* name : {"scarf", "scarf_limp", "scarf_stiff"})
    EXPECT_EQ(inside(shipped(name), dress_form, kTunicLowered), 0) << name;
  for (const char* name : {"cushion", "cushion_limp", "cushion_stiff"})
    EXPECT_EQ(inside(shipped(name), board, 0), 0) << name;
  for (const std::string& name : drape_names()) EXPECT_EQ(inside(shipped(name), ground, 0), 0) << name;
}

TEST(Drapes, PiecesHaveTheirRealSize) {
  const std::map<std::string, Vec2> sizes{
      {"plane", {300, 200}}, {"sphere", {600, 600}}, {"tablecloth", {1400, 1400}}, {"curtain", {1400, 1800}}};
  for (const auto& [name, size] : sizes) {
    const Mesh mesh = simulate_drape(name, kQuick);
    EXPECT_EQ(mesh.uv_mm.front(), (Vec2{0, 0})) << name;
    EXPECT_EQ(mesh.uv_mm.back(), (Vec2{-size[0], -size[1]})) << name;
  }
}

/// Number of loops formed by the border edges of the welded surface.
int open_loops(const Mesh& mesh) {
  const PositionOrder before;
  const auto edge_before = [&](const std::pair<Vec3, Vec3>& a, const std::pair<Vec3, Vec3>& b) {
    return before(a.first, b.first) || (a.first == b.first && before(a.second, b.second));
  };
  std::map<std::pair<Vec3, Vec3>, int, decltype(edge_before)> edges(edge_before);
  for (size_t t = 0; t < mesh.index.size(); ++t) {
    Vec3 a = mesh.position_mm[mesh.index[t]], b = mesh.position_mm[mesh.index[t % 3 == 2 ? t - 2 : t + 1]];
    if (before(b, a)) std::swap(a, b);
    ++edges[{a, b}];
  }
  std::map<Vec3, std::vector<Vec3>, PositionOrder> border;
  for (const auto& [edge, count] : edges) {
    EXPECT_LE(count, 2);
    if (count == 1) {
      border[edge.first].push_back(edge.second);
      border[edge.second].push_back(edge.first);
    }
  }
  int loops = 0;
  while (!border.empty()) {
    ++loops;
    std::vector<Vec3> open{border.begin()->first};
    while (!open.empty()) {
      const auto at = border.find(open.back());
      open.pop_back();
      if (at == border.end()) continue;
      EXPECT_EQ(at->second.size(), 2u);
      open.insert(open.end(), at->second.begin(), at->second.end());
      border.erase(at);
    }
  }
  return loops;
}

TEST(Drapes, GarmentsAreClosedAtTheirSeams) {
  EXPECT_EQ(open_loops(shipped("skirt")), 2);                                 // waist and hem
  constexpr int kTunicButtons = 3 + 2, kTunicLayers = 6;                      // placket, band, two cuffs, two hems
  EXPECT_EQ(open_loops(shipped("tunic")), 4 + kTunicButtons + kTunicLayers);  // neck, hem and two cuffs
  constexpr int kButtons = 7 + 1 + 2, kLayers = 6;                  // placket, pocket, yoke, collar, two cuffs
  EXPECT_EQ(open_loops(shipped("shirt")), 4 + kButtons + kLayers);  // hem, two cuffs, collar
  EXPECT_EQ(open_loops(shipped("scarf")), 1);
  EXPECT_EQ(open_loops(shipped("cushion")), 0);
}

/// Whether the segment from p to q passes through a triangle.
bool pierces(Vec3 p, Vec3 q, Vec3 a, Vec3 b, Vec3 c) {
  const auto volume = [](Vec3 o, Vec3 x, Vec3 y, Vec3 z) { return dot(glm::cross(x - o, y - o), z - o); };
  if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) return false;
  const float u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

/// Fraction of the first `triangles` that are pierced by an edge of another of them without a common vertex.
double pierced(const Mesh& mesh, size_t triangles) {
  constexpr float kCell_mm = 16;
  std::map<std::array<int, 3>, std::vector<size_t>> cells;  // by their middle; no edge is longer than a cell
  const auto corner = [&](size_t t, size_t k) { return mesh.position_mm[mesh.index[3 * t + k % 3]]; };
  const auto cell_of = [&](size_t t) {
    const Vec3 middle = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / (3 * kCell_mm);
    return std::array{static_cast<int>(std::floor(middle.x)), static_cast<int>(std::floor(middle.y)),
                      static_cast<int>(std::floor(middle.z))};
  };
  for (size_t t = 0; t < triangles; ++t) cells[cell_of(t)].push_back(t);
  const auto touch = [&](size_t s, size_t t) {
    for (size_t i = 0; i < 9; ++i)
      if (corner(s, i / 3) == corner(t, i % 3)) return true;
    return false;
  };
  size_t found = 0;
  for (size_t t = 0; t < triangles; ++t) {
    const std::array<int, 3> at = cell_of(t);
    bool is = false;
    for (int k = 0; k < 27 && !is; ++k) {
      const auto near = cells.find({at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1});
      if (near == cells.end()) continue;
      for (const size_t s : near->second) {
        for (size_t e = 0; e < 3 && !is; ++e)
          is = pierces(corner(s, e), corner(s, e + 1), corner(t, 0), corner(t, 1), corner(t, 2)) && !touch(s, t);
      }
    }
    found += is;
  }
  return static_cast<double>(found) / static_cast<double>(triangles);
}

// A flap of limp cloth came out through the fold beside it.
TEST(Drapes, ClothDoesNotPierceItself) {
  for (const char* drape : {"sphere", "tablecloth", "curtain", "skirt", "scarf", "cushion"}) {
    for (const DrapeStiffness stiffness : kDrapeStiffnesses) {
      const std::string name = drape_file(drape, stiffness);
      const Mesh mesh = shipped(name);
      // The corners of a cushion are narrower than the cells of its cloth.
      EXPECT_LE(pierced(mesh, mesh.index.size() / 3), name.starts_with("cushion") ? 0.0005 : 0) << name;
    }
  }
}

TEST(Drapes, TopsHardlyIntersectThemselves) {
  for (const char* name : kTops) {
    const Drape top = std::string(name).starts_with("tunic") ? tunic() : weftlight::drape::shirt();
    const Mesh mesh = shipped(name);
    const size_t cloth = top.pattern.index.size() / 3;  // second layers follow
    EXPECT_LT(cloth, mesh.index.size() / 3);
    const double share = pierced(mesh, cloth);
    RecordProperty(name, std::to_string(share));
    EXPECT_LE(share, 0.002) << name;
  }
}

TEST(Drapes, ThreadsOfTopsKeepTheirLength) {
  for (const char* name : kTops) {
    const std::vector<float> stretch = thread_stretch(shipped(name));
    EXPECT_NEAR(stretch[stretch.size() / 2], 0, 0.01f) << name;
    EXPECT_LT(stretch[stretch.size() * 49 / 50], 0.06f) << name;
  }
}

// It stood round the neck like a hood.
TEST(Drapes, AScarfLiesOnTheShoulders) {
  constexpr float kShoulders = 1400, kTopOfNeck = 1520;
  for (const DrapeStiffness stiffness : kDrapeStiffnesses) {
    const Mesh mesh = shipped(drape_file("scarf", stiffness));
    float top = 0;
    for (const Vec3 p : mesh.position_mm) top = std::max(top, p.y + kTunicLowered);
    EXPECT_GT(top, kShoulders) << drape_file("scarf", stiffness);
    EXPECT_LT(top, kTopOfNeck) << drape_file("scarf", stiffness);
  }
}

// The neck had pits, and the wrists were facets, where vertices stood far aside of their cells.
TEST(Drapes, TheFormIsSmooth) {
  for (const auto& [name, arm] : {std::pair{"tunic", lowered_arm(1)}, {"scarf", weftlight::drape::arm()}}) {
    const Mesh body = body_mesh(name);
    int rough = 0;
    for (size_t i = 0; i < body.position_mm.size(); ++i) {
      const Vec3 p = body.position_mm[i] + Vec3{0, kTunicLowered, 0};
      if (std::abs(form_with(arm, p)) > 0.5f) continue;  // the stand
      Vec3 slope;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 step{};
        step[axis] = 0.5f;
        slope[axis] = form_with(arm, p + step) - form_with(arm, p - step);
      }
      rough += dot(body.normal[i], normalize(slope)) < 0.97f;
    }
    EXPECT_LE(rough, 10) << name;  // the tunic's had 53
  }
}

TEST(Drapes, BodiesAreClosedAndFaceOutwards) {
  for (const std::string& name : drape_names()) {
    const Mesh body = body_mesh(name);
    double six_volumes = 0;
    for (size_t t = 0; t < body.index.size(); t += 3) {
      const Vec3 a = body.position_mm[body.index[t]], b = body.position_mm[body.index[t + 1]],
                 c = body.position_mm[body.index[t + 2]];
      const Vec3 n = glm::cross(a, b);
      six_volumes += static_cast<double>(dot(n, c));
    }
    EXPECT_EQ(six_volumes > 0, name != "plane") << name;
  }
}

TEST(Drapes, TheCurtainRodIsRound) {
  const Mesh body = body_mesh("curtain");
  for (size_t i = 0; i < body.position_mm.size(); ++i) {
    const Vec3 p = body.position_mm[i], aside(0, p.y - kRodHeight, p.z);
    if (std::abs(glm::length(aside) - kRodRadius) > 0.01f || std::abs(p.x) > kRodHalfLength - 1) continue;
    EXPECT_GT(glm::dot(body.normal[i], glm::normalize(aside)), 0.99f) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Drapes, LimpAndStiffDrapesHaveTheSamePattern) {
  for (const std::string& name : drape_names()) {
    for (const DrapeStiffness stiffness : {DrapeStiffness::kLimp, DrapeStiffness::kStiff}) {
      if (name == "plane") continue;
      const Mesh mesh = shipped(drape_file(name, stiffness)), medium = shipped(name);
      EXPECT_EQ(mesh.index, medium.index) << drape_file(name, stiffness);
      EXPECT_EQ(mesh.uv_mm.size(), medium.uv_mm.size());
      EXPECT_EQ(inside(mesh, ground, 0), 0) << drape_file(name, stiffness);
    }
  }
}

TEST(Drapes, StifferClothHasALargerDrapeCoefficient) {
  // Cusick's drape coefficient on round supports.
  const auto covers = [](const char* name, double support_mm, double side_mm) {
    std::array<double, 3> out{};
    for (const DrapeStiffness stiffness : kDrapeStiffnesses)
      out[static_cast<size_t>(stiffness)] =
          drape_coefficient(shipped(drape_file(name, stiffness)), support_mm, side_mm * side_mm);
    return out;
  };
  for (const auto& [limp, medium, stiff] : {covers("tablecloth", 450, 1400), covers("sphere", 150, 600)}) {
    EXPECT_GT(medium, 1.1 * limp);
    EXPECT_GT(stiff, 1.1 * medium);
  }
}

TEST(Drapes, TheBendingLengthSelectsTheStiffness) {
  EXPECT_EQ(drape_stiffness_of(12), DrapeStiffness::kLimp);
  EXPECT_EQ(drape_stiffness_of(19), DrapeStiffness::kMedium);
  EXPECT_EQ(drape_stiffness_of(30), DrapeStiffness::kStiff);
  EXPECT_EQ(drape_stiffness_of(0), DrapeStiffness::kMedium) << "not known";
  EXPECT_EQ(drape_file("skirt", DrapeStiffness::kMedium), "skirt");
  EXPECT_EQ(drape_file("skirt", DrapeStiffness::kStiff), "skirt_stiff");
  EXPECT_EQ(drape_file("plane", DrapeStiffness::kStiff), "plane");
}

TEST(Drapes, ACushionIsFilled) {
  for (const DrapeStiffness stiffness : kDrapeStiffnesses) {
    const Mesh mesh = shipped(drape_file("cushion", stiffness));
    double six_volumes = 0;
    for (size_t t = 0; t < mesh.index.size(); t += 3)
      six_volumes +=
          static_cast<double>(dot(glm::cross(mesh.position_mm[mesh.index[t]], mesh.position_mm[mesh.index[t + 1]]),
                                  mesh.position_mm[mesh.index[t + 2]]));
    EXPECT_NEAR(six_volumes / 6 / (420.0 * 420 * 420), 0.16, 0.02);
  }
}

// A limp one slid off its board and stood on the ground.
TEST(Drapes, ACushionLiesOnItsBoard) {
  for (const DrapeStiffness stiffness : kDrapeStiffnesses) {
    const Mesh mesh = shipped(drape_file("cushion", stiffness));
    Vec3 sum{};
    for (const Vec3 p : mesh.position_mm) sum += lean_back(p - Vec3{0, kBoardHeight, 0}, -kBoardLean);
    const Vec3 middle = sum / static_cast<float>(mesh.position_mm.size());
    EXPECT_NEAR(middle.x, 0, 40) << drape_file("cushion", stiffness);
    EXPECT_NEAR(middle.z, 0, 100) << drape_file("cushion", stiffness);
    EXPECT_GT(middle.y, 20) << drape_file("cushion", stiffness);
    EXPECT_LT(middle.y, 120) << drape_file("cushion", stiffness);
  }
}

TEST(Drapes, ParametersInterpolateTheShippedStiffnesses) {
  const DrapeParameters shirting = drape_parameters(19.2, 0.33);
  EXPECT_EQ(shirting.bending_half_mm, 38);
  EXPECT_EQ(drape_file("skirt", shirting), "skirt_19.0mm_0.35mm_v3");
  EXPECT_EQ(drape_parameters(19.1, 0.34), shirting) << "the difference is too small to see";
  EXPECT_EQ(drape_parameters(0, 0), drape_parameters(19, 0.5)) << "not known";
  EXPECT_EQ(drape_parameters(1e9, 1e9).bending_half_mm, 120);
  EXPECT_EQ(drape_parameters(std::nan(""), std::nan("")), drape_parameters(19, 0.5));
  // The shipped tablecloths have bending lengths of 12, 19 and 30 mm.
  Fabric limp, stiff;
  Fall thin, thick;
  apply_parameters(limp, thin, drape_parameters(12, 0.2));
  apply_parameters(stiff, thick, drape_parameters(30, 1.2));
  EXPECT_NEAR(std::cbrt(limp.bending_n_m / (limp.kg_per_m2 * 9.81)), 0.012, 1e-4);
  EXPECT_NEAR(std::cbrt(stiff.bending_n_m / (stiff.kg_per_m2 * 9.81)), 0.030, 1e-4);
  EXPECT_GT(stiff.bias_n_per_m, 4 * limp.bias_n_per_m);
  EXPECT_NEAR(thick.cloth_gap_mm - thin.cloth_gap_mm, 1.0, 1e-6);
}

TEST(Drapes, AStoppedSimulationIsEmpty) {
  int asked = 0;
  EXPECT_TRUE(simulate_drape(
                  "sphere", drape_parameters(15, 0.4), [&](double) { return ++asked < 3; }, kQuick)
                  .index.empty());
  EXPECT_EQ(asked, 3);
  EXPECT_FALSE(simulate_drape("sphere", drape_parameters(15, 0.4), {}, kQuick).index.empty());
  EXPECT_TRUE(simulate_drape("plane", drape_parameters(15, 0.4)).index.empty());
}

TEST(Drapes, AFlatDiscHasTheCoefficientOfItsArea) {
  Mesh square;
  square.position_mm = {{-300, 0, -300}, {300, 0, -300}, {300, 0, 300}, {-300, 0, 300}};
  square.index = {0, 2, 1, 0, 3, 2};
  EXPECT_NEAR(drape_coefficient(square, 150, 360'000), 1, 0.02);
  EXPECT_NEAR(drape_coefficient(square, 150, 720'000), (360'000 - 70'686) / (720'000 - 70'686.0), 0.02);
}

TEST(Drapes, AnUnknownNameIsEmpty) {
  EXPECT_TRUE(simulate_drape("tent").position_mm.empty());
  EXPECT_TRUE(body_mesh("tent").position_mm.empty());
}

}  // namespace
}  // namespace weftlight::drape
