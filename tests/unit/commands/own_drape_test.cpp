// The drape of a draft, simulated completely, in a picture and as a mesh. The cushion is the fastest.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>

#include "commands/open_design.h"
#include "files/design_drape.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::problem_of;
using design::Design;
using drape::Mesh;
using files::is_draped, files::load_design_drape, files::load_drape, files::read_mesh;

namespace {

namespace fs = std::filesystem;

class OwnDrape : public ScratchFolder {
 protected:
  void SetUp() override { setenv("XDG_CACHE_HOME", path("cache").c_str(), 1); }
  void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
  const std::string draft_ = fixture_path("twill.wif");
};

/// The largest distance between corresponding vertices, mm.
float farthest(const Mesh& a, const Mesh& b) {
  float most = 0;
  for (size_t i = 0; i < std::min(a.position_mm.size(), b.position_mm.size()); ++i)
    most = std::max(most, glm::distance(a.position_mm[i], b.position_mm[i]));
  return most;
}

TEST_F(OwnDrape, is_drawn_cached_and_written) {
  const std::vector<std::string> line{"render", draft_,        "--mesh", "cushion", "--simulate-drape",
                                      "-o",     path("a.png"), "--size", "48x32",   "--samples",
                                      "1"};
  const Ran drawn = run(line);
  if (drawn.code == kNoGraphics) GTEST_SKIP() << drawn.said;
  ASSERT_EQ(drawn.code, kDone) << drawn.said;
  EXPECT_EQ(drawn.said.find("warning"), std::string::npos) << drawn.said;
  Design design = open_design(draft_).design;
  design.scene.mesh = "cushion", design.scene.simulated_drape = true;
  ASSERT_TRUE(is_draped(design)) << "it is cached for the next picture";

  const Ran written = run({"drape", draft_, "-o", path("own.glb"), "--mesh", "cushion"});
  ASSERT_EQ(written.code, kDone) << written.said;
  EXPECT_NE(written.out.find("own.glb"), std::string::npos) << written.out;
  EXPECT_TRUE(fs::exists(path("own_body.glb")));
  const base::Result<Mesh> own = read_mesh(path("own.glb")), shipped = load_drape("cushion");
  ASSERT_TRUE(own) << problem_of(own);
  EXPECT_EQ(own->index, shipped->index);
  EXPECT_LT(farthest(*load_design_drape(design), *own), 0.01f) << "the one that is drawn";
  EXPECT_GT(farthest(*own, *shipped), 2) << "it is not the generic drape";
  for (const glm::vec3& p : own->position_mm) ASSERT_GT(p.y, -0.5f);
}

TEST_F(OwnDrape, options_keep_their_earlier_names) {
  for (const char* option : {"--simulate-drape", "--own-drape"})
    EXPECT_EQ(run({"render", draft_, option, "-o", path("none/a.png")}).code, kNotWritten) << option;
  for (const char* option : {"--stiffness", "--hang"})
    EXPECT_EQ(run({"drape", "plane", option, "stiff", "-o", path("none/a.glb")}).code, kNotWritten) << option;
  const std::string help = run({"render", "--help"}).out + run({"drape", "--help"}).out;
  EXPECT_NE(help.find("--stiffness"), std::string::npos);
  EXPECT_EQ(help.find("--hang"), std::string::npos);
  EXPECT_EQ(help.find("--own-drape"), std::string::npos);
}

TEST_F(OwnDrape, is_simulated_and_written_if_none_is_cached) {
  const Ran written = run({"drape", draft_, "-o", path("own.glb"), "--mesh", "cushion"});
  ASSERT_EQ(written.code, kDone) << written.said;
  const base::Result<Mesh> own = read_mesh(path("own.glb")), shipped = load_drape("cushion"),
                           body = read_mesh(path("own_body.glb"));
  ASSERT_TRUE(own) << problem_of(own);
  ASSERT_TRUE(body) << problem_of(body);
  EXPECT_EQ(own->index, shipped->index);
  EXPECT_GT(farthest(*own, *shipped), 2) << "it is not the generic drape";
  EXPECT_EQ(files(), (std::set<std::string>{"own.glb", "own_body.glb"})) << "no temporary files remain";
}

TEST_F(OwnDrape, is_not_simulated_if_the_output_cannot_be_written) {
  const Ran ran = run({"drape", draft_, "-o", path("none/own.glb"), "--mesh", "cushion"});
  EXPECT_EQ(ran.code, kNotWritten);
  EXPECT_NE(ran.said.find("none"), std::string::npos) << ran.said;
  EXPECT_FALSE(fs::exists(path("none")));
}

}  // namespace
}  // namespace weftlight::commands
