// The form under a drape: it fills the cloth, never shows through, and sends light on to it.

#include "render_data/ambient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <string>

#include "files/files.h"
#include "paths.h"
#include "reference/mesh_scene.h"

namespace weftlight::render_data {
namespace {

using drape::Vec3;
using reference::MeshHit, reference::MeshScene;

Mesh shipped(const std::string& name) {
  auto read = files::load_drape(WEFTLIGHT_SOURCE_DIR "/presets/meshes/" + name + ".glb");
  EXPECT_TRUE(read);
  if (!read) return {};
  read->name = name;
  return std::move(*read);
}

Mesh skirt() { return shipped("skirt"); }

TEST(Ambient, TheWaistbandIsFilledAndItsInsideIsLit) {
  const PreparedMesh prepared = prepare_mesh(skirt(), SkyRays::kFew);
  const auto form = MeshScene::build(prepared.body);
  ASSERT_TRUE(form);
  const auto& at = prepared.mesh.position_mm;
  float top = -1e9f;
  for (const auto& p : at) top = std::max(top, p[1]);
  int edge = 0, wide = 0;
  double lit = 0;
  for (size_t v = 0; v < at.size(); ++v) {
    if (at[v][1] < top - 4) continue;
    MeshHit hit;
    const bool filled = (*form)->intersect(at[v], -glm::vec3(prepared.mesh.normal[v]), 0, hit) && hit.t < 5;
    ++edge, wide += !filled;
    lit += static_cast<double>(prepared.sky[v].back);
  }
  ASSERT_GT(edge, 50);
  EXPECT_LT(wide, edge / 10) << "one looks down between the form and the cloth";
  EXPECT_GT(lit / edge, 0.05) << "the form sends no light to the inside of the waistband";
}

TEST(Ambient, TheFormStaysUnderTheCloth) {
  const Mesh cloth = skirt();
  const Mesh form = form_under("skirt", cloth);
  const auto scene = MeshScene::build(cloth);
  ASSERT_TRUE(scene);
  int through = 0;
  for (size_t v = 0; v < form.position_mm.size(); ++v) {
    // Cloth that the form has passed lies just below its surface.
    MeshHit hit;
    const glm::vec3 inwards = -glm::vec3(form.normal[v]);
    through += (*scene)->intersect(form.position_mm[v], inwards, 0, hit) && hit.t < 3;
  }
  EXPECT_EQ(through, 0);
}

// Sheer cloth shows the outline of the form, where a step between neighbours is a tooth.
TEST(Ambient, TheFormHasNoStepsWhereTheClothLeavesIt) {
  const Mesh cloth = skirt(), form = form_under("skirt", cloth), whole = drape::body_mesh("skirt");
  ASSERT_EQ(form.position_mm.size(), whole.position_mm.size());
  const float waist = scene::bounds_of(cloth).high.y - 50;  // above, the form fills the waistband
  const auto moved = [&](size_t v) { return glm::dot(form.position_mm[v] - whole.position_mm[v], whole.normal[v]); };
  float step = 0;
  for (size_t t = 0; t < whole.index.size(); ++t) {
    const size_t a = whole.index[t], b = whole.index[t % 3 == 2 ? t - 2 : t + 1];
    if (std::max(whole.position_mm[a].y, whole.position_mm[b].y) > waist) continue;
    step = std::max(step, std::abs(moved(a) - moved(b)));
  }
  EXPECT_LT(step, 1) << "millimetres";  // 7 when each vertex was moved for itself
}

// Each side of a seam was averaged with its own neighbours only: a straight line of light along the edge of a cushion.
TEST(Ambient, SeamsAreNoLinesOfLight) {
  const PreparedMesh prepared = prepare_mesh(shipped("cushion"), SkyRays::kFew);
  const Mesh& mesh = prepared.mesh;
  std::map<Vec3, size_t, drape::PositionOrder> first;
  int seam = 0;
  float step = 0;
  for (size_t v = 0; v < mesh.position_mm.size(); ++v) {
    const auto [at, added] = first.emplace(mesh.position_mm[v], v);
    if (added || mesh.normal[at->second] != mesh.normal[v]) continue;
    ++seam;
    step = std::max(step, std::abs(prepared.sky[at->second].front - prepared.sky[v].front));
    step = std::max(step, std::abs(prepared.sky[at->second].back - prepared.sky[v].back));
  }
  ASSERT_GT(seam, 50);
  EXPECT_EQ(step, 0);
}

// Of few triangles it had wavy highlights, as at the waist of the stand.
TEST(Ambient, TheFormHasTheNormalsOfItsWholeMesh) {
  const PreparedMesh prepared = prepare_mesh(skirt(), SkyRays::kFew);
  Mesh drawn = prepared.body;
  drawn.index = prepared.body_fine;
  const auto scene = MeshScene::build(drawn);
  ASSERT_TRUE(scene);
  size_t found = 0;
  double degrees = 0;
  for (size_t v = 0; v < drawn.position_mm.size(); ++v) {
    const glm::vec3 normal = drawn.normal[v];
    MeshHit hit;
    if (!(*scene)->intersect(drawn.position_mm[v] + 2.0f * normal, -normal, 0, hit) || hit.t > 4) continue;
    ++found, degrees += static_cast<double>(glm::degrees(std::acos(std::min(glm::dot(hit.normal, normal), 1.0f))));
  }
  ASSERT_GT(found, drawn.position_mm.size() * 9 / 10);
  EXPECT_LT(degrees / static_cast<double>(found),
            1.8);  // 2.6 with an eighth of the triangles, 1.1 with three times as many
}

// Made thinner by more than they are thick, they turned inside out and left bright chips over the heading.
TEST(Ambient, TheRingsOfACurtainStayRound) {
  const Mesh form = form_under("curtain", shipped("curtain")), whole = drape::body_mesh("curtain");
  ASSERT_EQ(form.position_mm.size(), whole.position_mm.size());
  float moved = 0;
  for (size_t v = 0; v < whole.position_mm.size(); ++v)
    moved = std::max(moved, glm::distance(form.position_mm[v], whole.position_mm[v]));
  EXPECT_LT(moved, 1e-3f) << "millimetres";
}

}  // namespace
}  // namespace weftlight::render_data
