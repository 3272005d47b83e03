// The finished picture is reproducible except for its noise, also after one for which there was no memory.

#include "app/picture_maker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "../scarce_memory.h"
#include "../straight_draft.h"
#include "app/drawn_picture.h"
#include "base/caught.h"
#include "gl/open_headless.h"

namespace weftlight::app {

using base::problem_of;
using design::Design;
using session::Compare;

namespace {

/// While other threads bake or compile. A turn without a pause would take a processor from them.
void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

/// Passes until it rests, and the bytes then.
std::vector<uint32_t> at_rest(PictureMaker& maker, const PictureRequest& request, double& now_s) {
  const auto busy = [&] { return maker.busy() || maker.can_refine() || maker.next_s(now_s) >= 0; };
  do {
    maker.poll();
    maker.draw(request, false, now_s += 0.5);
    if (maker.busy()) pause();
  } while (busy());
  int width = 0, height = 0;
  std::vector<uint32_t> pixels;
  maker.read(width, height, pixels);
  return pixels;
}

/// Root mean square over the bytes, of 1.
double apart(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    for (int shift = 0; shift < 24; shift += 8) {
      const double d = (static_cast<int>(a[i] >> shift & 255) - static_cast<int>(b[i] >> shift & 255)) / 255.0;
      sum += d * d;
    }
  }
  return std::sqrt(sum / (3.0 * static_cast<double>(a.size())));
}

TEST(PictureMakerTest, TheFinishedPictureIsReproducible) {
  const auto context = gl::open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << problem_of(context);
  Design design = straight_draft(8);
  design.scene.mesh = "plane";
  gl::Pipeline pipeline;
  constexpr double kAsLongAsItTakes = 1e9;  // ms: otherwise a busy machine takes fewer samples
  PictureMaker maker(pipeline, kAsLongAsItTakes);
  maker.submit(std::make_shared<const Design>(design));
  PictureRequest request{design.scene, design.look, 128, 96, false, Compare::kOff, 0};
  request.scene.view_distance = 0.1f;
  double now_s = 0;
  const std::vector<uint32_t> first = at_rest(maker, request, now_s);
  EXPECT_FALSE(maker.stats().first_of_program) << "the time of the compiler was taken for that of a pass";
  ASSERT_GT(maker.stats().method_weights[0], 0.9f) << "of threads";
  const auto after_another = [&] {
    request.show_methods = true;
    at_rest(maker, request, now_s);
    request.show_methods = false;
    return at_rest(maker, request, now_s);
  };
  const std::vector<uint32_t> again = after_another();
  ASSERT_EQ(first.size(), again.size());
  // Bit by bit on a quiet machine; up to 0.038 on a busy one, where the same samples fall into passes of 2 to 8.
  EXPECT_LT(apart(first, again), 0.04);
}

TEST(PictureMakerTest, ACoarserPictureIsReplacedOnceTheShadersAreCompiled) {
  const auto context = gl::open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << problem_of(context);
  Design design = straight_draft(8);
  design.scene.mesh = "plane";
  gl::Pipeline pipeline;
  PictureMaker maker(pipeline, 1e9);
  maker.hold_programs(true);
  maker.submit(std::make_shared<const Design>(design));
  PictureRequest request{design.scene, design.look, 128, 96, false, Compare::kOff, 0};
  request.scene.view_distance = 0.1f;
  double now_s = 0;
  while (!maker.stats().compiling || pipeline.busy()) {
    maker.poll();
    maker.draw(request, false, now_s += 0.5);
    pause();
  }
  maker.poll();
  EXPECT_TRUE(maker.busy()) << "nobody is told that a better picture comes";
  EXPECT_FALSE(maker.can_refine());
  EXPECT_GT(maker.next_s(now_s), 0.01) << "the coarse picture is drawn again without a pause";
  maker.hold_programs(false);
  at_rest(maker, request, now_s);
  EXPECT_FALSE(maker.stats().compiling);
  EXPECT_FALSE(maker.busy());
  EXPECT_GT(maker.stats().method_weights[0], 0.9f) << "of threads";
}

TEST(PictureMakerTest, WhereverMemoryEndsTheNextPictureIsWhole) {
  const auto context = gl::open_headless();
  if (!context) GTEST_SKIP() << "no graphics: " << problem_of(context);
  gl::Pipeline pipeline;
  PictureMaker maker(pipeline, 1);
  Design design = straight_draft(4);
  design.scene.mesh = "plane";
  const auto cloth = std::make_shared<const Design>(design);
  PictureRequest request{design.scene, design.look, 32, 24, false, Compare::kOff, 0};
  request.scene.view_distance = 0.1f;
  double now_s = 0;
  // While a cloth is handed to the driver.
  maker.submit(cloth);
  const base::Result<void> handed_over = base::caught([&] {
    do {
      pause();
      const NthFails fails(1);
      maker.poll();
    } while (maker.busy());
  });
  EXPECT_FALSE(handed_over);
  maker.submit(cloth);
  const std::vector<uint32_t> whole = at_rest(maker, request, now_s);
  EXPECT_EQ(maker.problem(), "");
  // While it draws, what the driver has compiled before: it may not do without memory.
  PictureRequest another = request;
  another.show_methods = true;
  const auto draw_another = [&] {
    maker.draw(another, false, now_s += 0.5);
    drawn_picture(maker, another, true);
  };
  draw_another();
  at_rest(maker, request, now_s);
  int failures = 0;
  for (int n = 1; n <= 500; n += 1 + n / 3) {
    {
      const NthFails fails(n);
      failures += base::caught(draw_another) ? 0 : 1;
    }
    const std::vector<uint32_t> next = at_rest(maker, request, now_s);
    EXPECT_EQ(maker.problem(), "") << n;
    ASSERT_EQ(next.size(), whole.size()) << n;
    EXPECT_LT(apart(next, whole), 0.06) << n << ": another picture";
  }
  EXPECT_GT(failures, 5);
}

}  // namespace
}  // namespace weftlight::app
