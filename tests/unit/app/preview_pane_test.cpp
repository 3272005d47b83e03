// The drawing thread: an exception is shown in place of the picture, and the next picture is drawn.

#include "app/preview_pane.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <thread>

#include "../comes_true.h"
#include "../scarce_memory.h"
#include "../straight_draft.h"
#include "../variable.h"
#include "gl/open_headless.h"

namespace weftlight::app {

using design::Design;

namespace {

bool asks_for_window() {
  bool asked = false;
  gl::open_headless([&asked] {
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

TEST(PreviewPaneTest, WhereverMemoryEndsBesideTheWindowTheNextPictureComes) {
  PreviewPane pane([] {});
  const std::string no_size = "Weaving the cloth\xE2\x80\xA6";
  const auto is_made = [&] {
    pane.poll();
    return !pane.picture().busy && pane.picture().problem == no_size;
  };
  PictureRequest request;
  pane.submit(std::make_shared<const Design>(straight_draft(8)));
  pane.ask(request, false);
  ASSERT_TRUE(comes_true([&] { return is_made() || pane.picture().problem != no_size; }));
  if (pane.picture().problem != no_size) GTEST_SKIP() << "no graphics: " << pane.picture().problem;
  int failures = 0;
  for (int n = 1; n <= 500; n += 1 + n / 8) {
    const NthFailsElsewhere fails(n);
    pane.submit(std::make_shared<const Design>(straight_draft(n % 2 == 0 ? 4 : 6)));
    request.budget_ms = static_cast<float>(n);
    pane.ask(request, false);
    ASSERT_TRUE(comes_true([&] { return is_made() || NthFailsElsewhere::failed(); })) << n;
    failures += NthFailsElsewhere::failed() ? 1 : 0;
  }
  pane.submit(std::make_shared<const Design>(straight_draft(8)));
  EXPECT_TRUE(comes_true(is_made)) << pane.picture().problem;
  EXPECT_GT(failures, 10);
}

/// What the driver says of a context: those in `lost` were dropped.
struct Driver {
  static inline std::mutex mutex;
  static inline std::set<EGLContext> seen, lost;
  static inline bool drops_all = false;

  static GLenum status() {
    const std::lock_guard lock(mutex);
    const EGLContext here = eglGetCurrentContext();
    seen.insert(here);
    if (drops_all) lost.insert(here);
    return lost.contains(here) ? GL_GUILTY_CONTEXT_RESET : GL_NO_ERROR;
  }
  static size_t contexts() {
    const std::lock_guard lock(mutex);
    return seen.size();
  }
};

class LostContext : public ::testing::Test {
 protected:
  LostContext() { epoxy_glGetGraphicsResetStatus = Driver::status; }
  ~LostContext() override { epoxy_glGetGraphicsResetStatus = before_; }
  /// A pane that has drawn in a context.
  void begin(PreviewPane& pane) {
    pane.submit(std::make_shared<const Design>(straight_draft(8)));
    ASSERT_TRUE(comes_true([&] { return pane.poll() || Driver::contexts() > 0; }));
    if (pane.picture().problem.find("cannot be shown") != std::string::npos)
      GTEST_SKIP() << "no graphics: " << pane.picture().problem;
  }
  decltype(epoxy_glGetGraphicsResetStatus) before_ = epoxy_glGetGraphicsResetStatus;
};

TEST_F(LostContext, IsMadeAnew) {
  Driver::seen.clear(), Driver::lost.clear(), Driver::drops_all = false;
  PreviewPane pane([] {});
  begin(pane);
  if (IsSkipped()) return;
  // Every request looks at the context, so one that is dropped now is noticed.
  PictureRequest request;
  const auto asks_until = [&](size_t contexts) {
    return comes_true([&] {
      request.budget_ms += 1;
      pane.ask(request, false);
      return Driver::contexts() >= contexts;
    });
  };
  ASSERT_TRUE(asks_until(1));
  {
    const std::lock_guard lock(Driver::mutex);
    Driver::lost = Driver::seen;
    Driver::seen.clear();
  }
  EXPECT_TRUE(comes_true([&] {
    request.budget_ms += 1;
    pane.ask(request, false);
    const std::lock_guard lock(Driver::mutex);
    return std::ranges::any_of(Driver::seen, [](EGLContext one) { return !Driver::lost.contains(one); });
  })) << "no other context was made";
  EXPECT_TRUE(comes_true([&] { return pane.poll() && pane.picture().problem == "Weaving the cloth\xE2\x80\xA6"; }))
      << pane.picture().problem;
}

TEST_F(LostContext, WithoutEndTheWindowGoesOnAndSaysSo) {
  Driver::seen.clear(), Driver::lost.clear(), Driver::drops_all = true;
  PreviewPane pane([] {});
  begin(pane);
  if (IsSkipped()) return;
  PictureRequest request;
  EXPECT_TRUE(comes_true([&] {
    request.budget_ms += 1;
    pane.ask(request, false);
    pane.poll();
    return pane.picture().problem.find("keeps resetting") != std::string::npos;
  })) << pane.picture().problem;
}

}  // namespace
}  // namespace weftlight::app
