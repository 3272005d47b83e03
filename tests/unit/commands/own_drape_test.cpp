// A draft hung by its own yarns to the end: in a picture, and as a mesh. The cushion falls the soonest.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>

#include "files/design_drape.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

namespace fs = std::filesystem;

class OwnDrape : public ScratchFolder {
 protected:
  void SetUp() override { setenv("XDG_CACHE_HOME", path("cache").c_str(), 1); }
  void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
  const std::string draft_ = fixture_path("twill.wif");
};

/// The farthest that a vertex of one lies from its own of the other, mm.
float farthest(const Mesh& a, const Mesh& b) {
  float most = 0;
  for (size_t i = 0; i < std::min(a.position_mm.size(), b.position_mm.size()); ++i)
    most = std::max(most, glm::distance(a.position_mm[i], b.position_mm[i]));
  return most;
}

TEST_F(OwnDrape, is_drawn_kept_and_written) {
  const std::vector<std::string> line{"render", draft_,  "--mesh",    "cushion", "--own-drape", "-o", path("a.png"),
                                      "--size", "48x32", "--samples", "1"};
  const Ran drawn = run(line);
  if (drawn.code == kNoGraphics) GTEST_SKIP() << drawn.said;
  ASSERT_EQ(drawn.code, kDone) << drawn.said;
  EXPECT_EQ(drawn.said.find("warning"), std::string::npos) << drawn.said;
  Design design = open_design(draft_).design;
  design.scene.mesh = "cushion", design.scene.simulated_drape = true;
  ASSERT_TRUE(is_draped(design)) << "it is kept for the next picture";

  const Ran written = run({"drape", draft_, "-o", path("own.glb"), "--mesh", "cushion"});
  ASSERT_EQ(written.code, kDone) << written.said;
  EXPECT_NE(written.out.find("own.glb"), std::string::npos) << written.out;
  EXPECT_TRUE(fs::exists(path("own_body.glb")));
  const ReadMesh own = read_mesh(path("own.glb")), shipped = load_drape("cushion");
  ASSERT_TRUE(own.mesh) << own.error;
  EXPECT_EQ(own.mesh->index, shipped.mesh->index);
  EXPECT_LT(farthest(*load_design_drape(design).mesh, *own.mesh), 0.01f) << "the one that is drawn";
  EXPECT_GT(farthest(*own.mesh, *shipped.mesh), 2) << "not as its kind hangs";
  for (const glm::vec3& place : own.mesh->position_mm) ASSERT_GT(place.y, -0.5f);
}

TEST_F(OwnDrape, is_simulated_and_written_whole_where_none_is_kept) {
  const Ran written = run({"drape", draft_, "-o", path("own.glb"), "--mesh", "cushion"});
  ASSERT_EQ(written.code, kDone) << written.said;
  const ReadMesh own = read_mesh(path("own.glb")), shipped = load_drape("cushion"),
                 body = read_mesh(path("own_body.glb"));
  ASSERT_TRUE(own.mesh) << own.error;
  ASSERT_TRUE(body.mesh) << body.error;
  EXPECT_EQ(own.mesh->index, shipped.mesh->index);
  EXPECT_GT(farthest(*own.mesh, *shipped.mesh), 2) << "not as its kind hangs";
  EXPECT_EQ(files(), (std::set<std::string>{"own.glb", "own_body.glb"})) << "nothing was left";
}

TEST_F(OwnDrape, is_not_simulated_for_a_place_that_cannot_be_written) {
  const Ran ran = run({"drape", draft_, "-o", path("none/own.glb"), "--mesh", "cushion"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("none"), std::string::npos) << ran.said;
  EXPECT_FALSE(fs::exists(path("none")));
}

}  // namespace
}  // namespace weftlight::commands
