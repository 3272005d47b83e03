// The drape simulation by clicks: progress, stop, undo, and the kept result.

#include <filesystem>

#include "files/design_drape.h"
#include "on_display.h"

namespace weftlight::gui {
namespace {

namespace fs = std::filesystem;

class DrapeTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    design_ = design_of(straight_draft());
    design_.scene.mesh = "sphere";
    put(draft_, wif::write_new_wif(design_));
    put(folder_ / "config/weftlight/settings.json", R"({"width": 1280, "height": 800, "toured": true})");
    setenv("XDG_CACHE_HOME", (folder_ / "cache").c_str(), 1);
    kept_ = files::kept_drape_path(design_);
    unsetenv("XDG_CACHE_HOME");
  }
  void press(const Window& w, const std::string& control) const {
    ASSERT_TRUE(comes_true([&] { return w.has(control); })) << control << " is not there";
    display_.click(w.middle_of(control));
  }
  bool is_own(const Window& w) const { return design_of(w.live()).scene.simulated_drape; }

  design::Design design_;
  fs::path kept_;
};

TEST_F(DrapeTest, RunsStopsRestartsAndIsUndone) {
  Window w(display_, folder_, draft_);
  ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Cloth"));
  ASSERT_NO_FATAL_FAILURE(press(w, "scene.simulated_drape:Simulated"));
  ASSERT_TRUE(comes_true([&] { return w.has("drape.progress") && is_own(w); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "drape.stop"));
  ASSERT_TRUE(comes_true([&] { return !w.has("drape.progress") && w.has("drape.again"); }));
  EXPECT_TRUE(is_own(w)) << "the draft still requests it";
  EXPECT_FALSE(fs::exists(kept_));
  ASSERT_NO_FATAL_FAILURE(press(w, "drape.again"));
  ASSERT_TRUE(comes_true([&] { return w.has("drape.progress"); }));
  display_.key("ctrl+z");
  ASSERT_TRUE(comes_true([&] { return !w.has("drape.progress") && !w.has("drape.again") && !is_own(w); }));
  display_.key("ctrl+shift+z");
  ASSERT_TRUE(comes_true([&] { return w.has("drape.progress") && is_own(w); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "scene.simulated_drape:Generic"));
  ASSERT_TRUE(comes_true([&] { return !w.has("drape.progress") && !is_own(w); }));
}

TEST_F(DrapeTest, AKeptSimulationIsUsedWhenTheDraftIsOpened) {
  fs::create_directories(kept_.parent_path());
  fs::copy_file(fs::path(base::presets_dir()) / "meshes/sphere_stiff.glb", kept_);
  const auto before = fs::last_write_time(kept_);
  design_.scene.simulated_drape = true;
  put(draft_, wif::write_new_wif(design_));
  Window w(display_, folder_, draft_);
  ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Cloth"));
  ASSERT_TRUE(comes_true([&] { return w.has("scene.simulated_drape:Simulated"); }));
  ASSERT_TRUE(comes_true([&] { return !w.has("drape.progress"); })) << "it is kept and does not run again";
  EXPECT_FALSE(w.has("drape.again"));
  EXPECT_EQ(fs::last_write_time(kept_), before);
}

}  // namespace
}  // namespace weftlight::gui
