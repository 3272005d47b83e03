// The preview in the window's own context: its pictures come by poll() alone, a pass at a time.

#include "app/preview_slices.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "../comes_true.h"
#include "../straight_draft.h"
#include "gl/open_headless.h"

namespace weftlight::app {

namespace {

/// Gives turns until it holds; false if it never does.
template <class Holds>
bool comes_true(PreviewSlices& pane, const Holds& holds) {
  return weftlight::comes_true([&] {
    pane.poll();
    return holds(pane.picture());
  });
}

size_t colors(unsigned texture, int width, int height) {
  std::vector<uint32_t> pixels(static_cast<size_t>(width) * static_cast<size_t>(height));
  glBindTexture(GL_TEXTURE_2D, texture);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return std::set<uint32_t>(pixels.begin(), pixels.end()).size();
}

TEST(PreviewSlicesTest, DrawsInTheContextThatIsThere) {
  const auto context = gl::open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << context.error().text;
  PreviewSlices pane([] {});
  EXPECT_FALSE(pane.poll()) << "nothing was submitted";
  pane.submit(std::make_shared<const design::Design>(straight_draft(8)), {1, false});
  EXPECT_FALSE(pane.poll()) << "nothing was asked for: the window is seen first";
  PictureRequest request;
  request.width = 96, request.height = 64;
  pane.ask(request, false);
  ASSERT_TRUE(comes_true(pane, [](const PreviewPicture& p) { return p.texture != 0 && !p.busy && !p.refining; }))
      << pane.picture().problem;
  EXPECT_GT(colors(pane.picture().texture, 96, 64), 50u);
  // At rest a turn costs nothing.
  ASSERT_TRUE(comes_true(pane, [&](const PreviewPicture&) { return !pane.poll(); }));
  // Another document's picture is not shown for this one.
  pane.submit(std::make_shared<const design::Design>(straight_draft(6)), {2, false});
  EXPECT_EQ(pane.picture().texture, 0u);
  EXPECT_TRUE(comes_true(pane, [](const PreviewPicture& p) { return p.texture != 0 && !p.busy; }));
}

/// What the driver says when it is asked so many times more.
struct Driver {
  static inline int resets = 0;
  static GLenum status() { return resets > 0 && resets-- > 0 ? GL_GUILTY_CONTEXT_RESET : GL_NO_ERROR; }
  Driver() { epoxy_glGetGraphicsResetStatus = status; }
  ~Driver() { epoxy_glGetGraphicsResetStatus = before_; }
  decltype(epoxy_glGetGraphicsResetStatus) before_ = epoxy_glGetGraphicsResetStatus;
};

/// A pane that has drawn a picture, and the driver under it.
class LostContextOfSlices : public ::testing::Test {
 protected:
  void SetUp() override {
    context_ = gl::open_headless();
    if (!context_) GTEST_SKIP() << "no graphics: " << context_.error().text;
    PictureRequest request;
    request.width = 96, request.height = 64;
    pane_.emplace([] {});
    pane_->submit(std::make_shared<const design::Design>(straight_draft(8)), {1, false});
    pane_->ask(request, false);
    ASSERT_TRUE(is_drawn()) << pane_->picture().problem;
  }
  bool is_drawn() {
    return comes_true(*pane_, [](const PreviewPicture& p) { return p.texture != 0 && !p.busy; });
  }
  gl::HeadlessContext::Opened context_;
  std::optional<PreviewSlices> pane_;
  Driver driver_;
};

TEST_F(LostContextOfSlices, ThatIsBackIsDrawnInAnew) {
  Driver::resets = 1;
  // Nothing else is asked for.
  ASSERT_TRUE(comes_true(*pane_, [](const PreviewPicture& p) { return p.busy; })) << "nothing is computed again";
  ASSERT_TRUE(is_drawn()) << pane_->picture().problem;
  EXPECT_GT(colors(pane_->picture().texture, 96, 64), 50u);
}

TEST_F(LostContextOfSlices, AgainAndAgainIsLeftAtThat) {
  Driver::resets = 4;
  ASSERT_TRUE(comes_true(*pane_, [](const PreviewPicture& p) {
    return p.problem.find("keeps resetting") != std::string::npos;
  })) << pane_->picture().problem;
  EXPECT_FALSE(pane_->poll());
}

}  // namespace
}  // namespace weftlight::app
