// The simulated drape: computed on its own thread, stopped, restarted, and cached.

#include "session/jobs/draper.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "../comes_true.h"
#include "../scratch_fixture.h"
#include "design/edits.h"
#include "files/design_drape.h"
#include "session/document/document.h"

namespace weftlight::session {

using base::presets_dir;
using design::Design;
using draft::blank_draft;

namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Design> cloth(bool own) {
  Design d;
  d.draft = blank_draft(16, 16, 2, 2);
  d.yarns.resize(1);
  d.scene.mesh = "sphere", d.scene.simulated_drape = own;
  return std::make_shared<const Design>(std::move(d));
}

class DraperTest : public ScratchTest {
 protected:
  void SetUp() override { setenv("XDG_CACHE_HOME", dir_.c_str(), 1); }
  void TearDown() override { unsetenv("XDG_CACHE_HOME"); }
  static void keep(const Design& d, const char* mesh) {
    const std::string path = files::kept_drape_path(d);
    fs::create_directories(fs::path(path).parent_path());
    fs::copy_file(fs::path(presets_dir()) / "meshes" / mesh, path, fs::copy_options::overwrite_existing);
  }
  static void follow_till_it_falls(Draper& draper, const std::shared_ptr<const Design>& design) {
    draper.follow(design);
    EXPECT_TRUE(comes_true([&] { return draper.state().share > 0; }));
  }
};

TEST_F(DraperTest, TheGenericDrapeIsTheDefault) {
  Draper draper([] {});
  draper.follow(cloth(false));
  EXPECT_EQ(draper.state().stage, DrapeStage::kGeneric);
  EXPECT_FALSE(draper.busy());
}

TEST_F(DraperTest, ACachedDrapeIsShownAtOnce) {
  const auto design = cloth(true);
  keep(*design, "sphere_limp.glb");
  Draper draper([] {});
  draper.follow(design);
  ASSERT_TRUE(comes_true([&] { return draper.state().stage == DrapeStage::kSimulated; }));
  const Draper::Update update = draper.take_update();
  EXPECT_TRUE(update.new_mesh);
  EXPECT_EQ(update.message, "") << "nothing was done that is worth a word";
  draper.follow(cloth(false));
  EXPECT_EQ(draper.state().stage, DrapeStage::kGeneric);
}

TEST_F(DraperTest, TheSimulationCanBeStoppedAndRestarted) {
  const auto design = cloth(true);
  Draper draper([] {});
  follow_till_it_falls(draper, design);
  draper.stop();
  EXPECT_EQ(draper.state().stage, DrapeStage::kStopped);
  draper.follow(design);
  EXPECT_EQ(draper.state().stage, DrapeStage::kStopped) << "an edit of something else does not begin it anew";
  EXPECT_FALSE(fs::exists(files::kept_drape_path(*design)));
  draper.again(design);
  EXPECT_TRUE(draper.busy());
}

TEST_F(DraperTest, ADamagedCacheFileIsSimulatedAgain) {
  const auto design = cloth(true);
  keep(*design, "skirt.glb");
  Draper draper([] {});
  follow_till_it_falls(draper, design);
  EXPECT_EQ(draper.state().stage, DrapeStage::kSimulating);
}

TEST_F(DraperTest, ReportsACacheFolderThatCannotBeMade) {
  written("weftlight", "a file in the way");
  Draper draper([] {});
  draper.follow(cloth(true));
  ASSERT_TRUE(comes_true([&] { return draper.state().stage == DrapeStage::kFailed; }));
  EXPECT_NE(draper.state().problem.find("weftlight"), std::string::npos);
  EXPECT_NE(draper.take_update().message, "");
}

TEST(SimulatedDrape, IsOneStepOfUndo) {
  Document document{*cloth(false)};
  document.commit(simulated_drape_edit(true), 0);
  EXPECT_TRUE(document.now().scene.simulated_drape);
  document.undo();
  EXPECT_FALSE(document.now().scene.simulated_drape);
}

}  // namespace
}  // namespace weftlight::session
