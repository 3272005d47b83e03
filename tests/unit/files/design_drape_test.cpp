// The simulated drape of a fabric: cached by the parameters of the fabric; broken or foreign files in the cache are
// ignored.

#include "files/design_drape.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "../scratch_fixture.h"
#include "base/whole_files.h"
#include "design/edits.h"
#include "drape/stiffness.h"

namespace weftlight::files {

using base::presets_dir, base::problem_of;
using design::Design;
using draft::blank_draft;
using drape::Mesh;

namespace {

namespace fs = std::filesystem;

Design sheeting() {
  Design d;
  d.draft = blank_draft(16, 16, 2, 2);
  d.yarns.resize(1);
  d.scene.mesh = "sphere";
  d.scene.simulated_drape = true;
  return d;
}

/// Every test has its own cache.
class DesignDrape : public ScratchTest {
 protected:
  void SetUp() override { setenv("XDG_CACHE_HOME", dir_.c_str(), 1); }
  void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
  /// Puts the limp version into the cache as if it had been simulated; it differs from that of the sheeting.
  static void put_into_cache(const Design& d) {
    const std::string path = kept_drape_path(d);
    fs::create_directories(fs::path(path).parent_path());
    fs::copy_file(fs::path(presets_dir()) / "meshes/sphere_limp.glb", path, fs::copy_options::overwrite_existing);
  }
};

TEST_F(DesignDrape, CachedDrapeIsShownIfTheSceneAsks) {
  Design d = sheeting();
  const std::string shipped = drape_key(d);
  EXPECT_FALSE(is_draped(d));
  put_into_cache(d);
  EXPECT_TRUE(is_draped(d));
  EXPECT_NE(drape_key(d), shipped);
  const Mesh limp = load_design_drape(d).value_or(Mesh{});
  EXPECT_EQ(limp.name, "sphere");
  d.scene.simulated_drape = false;
  EXPECT_EQ(drape_key(d), shipped);
  EXPECT_NE(load_design_drape(d).value_or(Mesh{}).position_mm, limp.position_mm);
}

TEST_F(DesignDrape, KeyDependsOnYarnAndSettOnly) {
  Design d = sheeting();
  const std::string kept = kept_drape_path(d);
  Design other = d;
  other.draft.threading.set(0, 1, true);
  EXPECT_EQ(kept_drape_path(other), kept);
  other = d;
  other.yarns[0].diameter_mm *= 2;
  EXPECT_NE(kept_drape_path(other), kept);
  other = d;
  other.scene.mesh = "plane";
  EXPECT_EQ(kept_drape_path(other), "");
}

TEST_F(DesignDrape, BrokenAndForeignFilesAreIgnored) {
  const Design d = sheeting();
  put_into_cache(d);
  const std::string path = kept_drape_path(d);
  fs::resize_file(path, 1000);
  EXPECT_FALSE(is_draped(d));
  EXPECT_TRUE(load_design_drape(d)) << "the shipped one is used";
  fs::copy_file(fs::path(presets_dir()) / "meshes/skirt.glb", path, fs::copy_options::overwrite_existing);
  EXPECT_FALSE(is_draped(d));
  EXPECT_TRUE(load_design_drape(d));
}

TEST_F(DesignDrape, AStoppedSimulationIsNotCached) {
  const Design d = sheeting();
  int asked = 0;
  EXPECT_EQ(problem_of(drape_cloth(d, [&](double) { return ++asked < 3; })), "");
  EXPECT_EQ(asked, 3);
  EXPECT_FALSE(fs::exists(kept_drape_path(d)));
}

TEST_F(DesignDrape, AnErrorOfTheCacheFolderIsReported) {
  written("weftlight", "a file in the way");
  EXPECT_NE(problem_of(drape_cloth(sheeting())).find("weftlight"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::files
