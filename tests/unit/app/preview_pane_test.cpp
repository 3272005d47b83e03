// The drawing thread: an exception is shown in place of the picture, and the next picture is drawn.

#include "app/preview_pane.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>
#include <thread>

#include "../straight_draft.h"
#include "../variable.h"

namespace weftlight::app {

using design::Design;

namespace {

template <class Holds>
bool comes_true(const Holds& holds) {
  for (int i = 0; i < 6000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(5)))
    if (holds()) return true;
  return false;
}

bool asks_for_window() {
  bool asked = false;
  gl::HeadlessContext::create([&asked] {
    asked = true;
    return base::failure(base::ErrorKind::kGraphics, "not now");
  });
  return asked;
}

TEST(PreviewPaneTest, AHiddenWindowIsOpenedByTheWindowsThread) {
  const Variable way("WEFTLIGHT_OFFSCREEN", "window"), x11("DISPLAY", ""), wayland("WAYLAND_DISPLAY", "");
  std::atomic<int> wakes{0};
  PreviewPane pane([&] { ++wakes; });
  pane.submit(std::make_shared<const Design>(straight_draft(8)));
  ASSERT_TRUE(comes_true([&] { return wakes == 1; })) << "this thread is not asked";
  ASSERT_TRUE(comes_true([&] { return pane.poll(); }));
  const std::string problem = pane.picture().problem;
  if (problem.find("cannot be shown") == std::string::npos) GTEST_SKIP() << "windows need no variable here";
  EXPECT_NE(problem.find("draw where there is a display"), std::string::npos) << problem;
}

TEST(PreviewPaneTest, DoesNotWaitForAHiddenWindowWhenItIsLeft) {
  const Variable way("WEFTLIGHT_OFFSCREEN", "window");
  std::atomic<int> wakes{0};
  PreviewPane pane([&] { ++wakes; });
  pane.submit(std::make_shared<const Design>(straight_draft(8)));
  ASSERT_TRUE(comes_true([&] { return wakes == 1; }));
}

TEST(PreviewPaneTest, AnExceptionIsShownAndTheThreadContinues) {
  // Without EGL the first wake asks this thread for a hidden window.
  const int asking = asks_for_window() ? 1 : 0;
  std::atomic<int> wakes{-asking};
  PreviewPane pane([&] {
    const int now = wakes++;
    if (now == 0) throw std::bad_alloc();
    if (now == 2) throw std::runtime_error("the line broke");
  });
  // Nothing here needs the window's context: no picture is asked for that has a size.
  const auto says = [&](const std::string& words) {
    return comes_true([&] { return pane.poll() && pane.picture().problem.find(words) != std::string::npos; });
  };
  pane.submit(std::make_shared<const Design>(straight_draft(8)));
  ASSERT_TRUE(says("cannot be shown"));
  if (pane.picture().problem.find("not enough memory") == std::string::npos)
    GTEST_SKIP() << "no graphics: " << pane.picture().problem;
  pane.ask({}, false);
  EXPECT_TRUE(says("the line broke"));
  EXPECT_TRUE(comes_true([&] { return pane.poll() && pane.picture().problem == "Weaving the cloth\xE2\x80\xA6"; }))
      << pane.picture().problem;
}

}  // namespace
}  // namespace weftlight::app
