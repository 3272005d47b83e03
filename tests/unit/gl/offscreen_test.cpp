// Which context is made off screen, and that it moves between threads. That a hidden window draws what EGL draws is
// tested on a display (tests/gui/offscreen_test.cpp).

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <thread>

#include "../variable.h"
#include "gl/open_headless.h"

namespace weftlight::gl {
namespace {

HeadlessContext::Opened no_window() { return base::failure(base::ErrorKind::kGraphics, "the screen is dark"); }

std::string said(const HeadlessContext::Opened& opened) {
  EXPECT_FALSE(opened);
  return problem_of(opened);
}

TEST(Offscreen, IsTurnedOffByItsVariable) {
  const Variable way("WEFTLIGHT_OFFSCREEN", "none");
  const auto context = open_headless();
  EXPECT_EQ(said(context), "drawing is turned off (WEFTLIGHT_OFFSCREEN is none)");
  EXPECT_EQ(context.error().kind, base::ErrorKind::kGraphics);
}

TEST(Offscreen, SaysWhatItsVariableTakes) {
  const Variable way("WEFTLIGHT_OFFSCREEN", "glx");
  EXPECT_EQ(said(open_headless()), "WEFTLIGHT_OFFSCREEN is 'glx': write egl, window or none, or leave it unset");
}

TEST(Offscreen, ByAWindowNeedsADisplay) {
  const Variable way("WEFTLIGHT_OFFSCREEN", "window"), x11("DISPLAY", ""), wayland("WAYLAND_DISPLAY", "");
  const auto context = open_headless();
  if (context) GTEST_SKIP() << "windows need no variable here";
  EXPECT_EQ(context.error().kind, base::ErrorKind::kGraphics);
  EXPECT_NE(problem_of(context).find("draw where there is a display"), std::string::npos) << problem_of(context);
}

TEST(Offscreen, AsksForAWindowOnlyWithoutEgl) {
  bool asked = false;
  const auto context = open_headless([&asked] {
    asked = true;
    return no_window();
  });
  EXPECT_NE(asked, context.has_value());
  if (!context) {
    EXPECT_NE(problem_of(context).find("draw where there is a display (the screen is dark)"), std::string::npos)
        << problem_of(context);
  }
  const Variable way("WEFTLIGHT_OFFSCREEN", "window");
  EXPECT_EQ(said(open_headless(no_window)),
            "no hidden window can be opened (the screen is dark): draw where there is a display");
}

TEST(Offscreen, MovesToAnotherThreadAndBack) {
  const auto context = open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << problem_of(context);
  const auto version = [] {
    GLint major = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    return major;
  };
  EXPECT_GE(version(), 3);
  (*context)->release();
  std::thread([&] {
    EXPECT_EQ(problem_of((*context)->make_current()), "");
    EXPECT_GE(version(), 3);
    (*context)->release();
  }).join();
  EXPECT_EQ(problem_of((*context)->make_current()), "");
  EXPECT_GE(version(), 3);
}

}  // namespace
}  // namespace weftlight::gl
