// Without EGL a hidden window draws: the same picture by `render`, and the cloth in the window.

#include <sys/wait.h>

#include <cmath>
#include <cstdlib>

#include "on_display.h"

namespace weftlight::gui {
namespace {

namespace fs = std::filesystem;

// RMS of 1. How many passes a picture has goes by the clock: the same draft is up to 0.08 apart on a busy machine,
// another one 0.14.
constexpr double kSameCloth = 0.11;

class Offscreen : public OnDisplay {
 protected:
  void SetUp() override {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "a library put before the sanitizer's cannot be loaded";
#endif
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    put(draft_, straight_draft(4));  // an edit of one end is seen
    put(folder_ / "config/weftlight/settings.json", R"({"width": 1280, "height": 800, "toured": true})");
  }

  /// The exit code of a picture drawn with these variables.
  int render(const std::string& variables, const fs::path& out) const {
    const std::string command = "env LIBGL_ALWAYS_SOFTWARE=1 " + variables + " '" WEFTLIGHT_BINARY "' render '" +
                                draft_.string() + "' -o '" + out.string() + "' --method yarn --size 160x120 2>'" +
                                (folder_ / "said").string() + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string said() const { return bytes_of(folder_ / "said"); }

  std::string on_screen() const { return "DISPLAY=" + display_.name() + " WAYLAND_DISPLAY="; }

  static inline const std::string kNoEgl = std::string("LD_PRELOAD=") + WEFTLIGHT_NO_EGL;
};

TEST_F(Offscreen, AHiddenWindowDrawsThePictureOfEgl) {
  const fs::path by_egl = folder_ / "egl.png", by_window = folder_ / "window.png", unwanted = folder_ / "none.png";
  ASSERT_EQ(render(on_screen() + " WEFTLIGHT_OFFSCREEN=egl", by_egl), 0) << said();
  ASSERT_EQ(render(on_screen() + " WEFTLIGHT_OFFSCREEN= '" + kNoEgl + "'", by_window), 0) << said();
  EXPECT_EQ(bytes_of(by_egl), bytes_of(by_window));
  EXPECT_EQ(render("DISPLAY= WAYLAND_DISPLAY= WEFTLIGHT_OFFSCREEN= '" + kNoEgl + "'", unwanted), 4);
  EXPECT_NE(said().find("draw where there is a display"), std::string::npos) << said();
  EXPECT_FALSE(fs::exists(unwanted));
}

TEST_F(Offscreen, TheWindowShowsItsClothWithoutEgl) {
  std::string by_egl;
  {
    Window w(display_, folder_, draft_, {"WEFTLIGHT_OFFSCREEN=egl"});
    by_egl = still_picture(w);
    display_.key("ctrl+q");
    ASSERT_EQ(w.process().wait(), 0);
  }
  Window w(display_, folder_, draft_, {kNoEgl});
  EXPECT_LT(apart(still_picture(w), by_egl), kSameCloth);
  const std::string before = w.live();
  ASSERT_NO_FATAL_FAILURE(paint(w));
  EXPECT_TRUE(comes_true([&] { return apart(still_picture(w), by_egl) > kSameCloth; }))
      << "the cloth does not follow the draft";
  EXPECT_NE(w.live(), before);
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == before; }));
  EXPECT_TRUE(comes_true([&] { return apart(still_picture(w), by_egl) < kSameCloth; }))
      << "the cloth does not follow the undo";
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
}

}  // namespace
}  // namespace weftlight::gui
