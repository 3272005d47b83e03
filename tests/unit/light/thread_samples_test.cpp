// Surface samples: together they make up the visible cloth.

#include "light/thread_samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cloth/maps.h"
#include "cloth/thread_scene.h"
#include "light/measure_response.h"
#include "plain_cloth.h"

namespace weftlight::light {

using cloth::Cloth, cloth::Period, cloth::ThreadScene, cloth::bake, cloth::lay_out;
using design::Design, design::Yarn;
using draft::Draft, draft::Face, draft::ShedControl, draft::Threads, draft::blank_draft, draft::drawdown;

namespace {

constexpr float kSpacing = 2;

Cloth plain(int threads, float thickness_mm) {
  Yarn yarn;
  yarn.plies = 1;
  return plain_cloth(threads, kSpacing, thickness_mm, yarn);
}

/// Plain weave of ends that are wider than their room, so that their sections are nearly square.
Cloth jammed() {
  Cloth cloth = plain(8, 1);
  for (cloth::ThreadBody& end : cloth.ends) end.width_mm = kSpacing, end.height_mm = 1.2f, end.squareness = 0.75f;
  return cloth;
}

/// Coverage of each system along a view.
std::array<float, 2> covers(const ThreadSamples& threads, size_t view) {
  const glm::vec3 v = response_views()[view];
  std::array<float, 2> sum{};
  for (const ThreadSample& p : threads.samples)
    sum[static_cast<size_t>(p.system)] += p.area * std::max(glm::dot(p.side, v), 0.0f) * p.open[view] / v.z;
  return sum;
}

constexpr size_t kFromAbove = static_cast<size_t>((kResponseElevations - 1) * kViewAzimuths);

/// The same by rays from the eye.
std::array<float, 2> hits(const Cloth& cloth, size_t view) {
  ThreadScene scene(cloth);
  constexpr int kSide = 96, kCells = 48;
  std::array<float, 2> coverage{};
  for (int i = 0; i < kSide * kSide; ++i) {
    const glm::vec2 at = (glm::vec2(i % kSide, i / kSide) + 0.5f) / static_cast<float>(kSide) *
                         glm::vec2(cloth.width_mm, cloth.depth_mm);
    const auto hit = scene.first_thread(scene.grid(), at, response_views()[view], kCells);
    if (hit.system >= 0) coverage[static_cast<size_t>(hit.system)] += 1.0f / (kSide * kSide);
  }
  return coverage;
}

/// Two blocks side by side: 3/1 twill, where the warp shows, and 1/3.
Cloth damask() {
  constexpr int kBlock = 24;
  Design design;
  design.draft = blank_draft(2 * kBlock, 8, 8, 8);
  Draft& d = design.draft;
  d.shed_control = ShedControl::kLiftplan;
  for (int e = 0; e < 2 * kBlock; ++e) d.threading.set(e, e % 4 + (e < kBlock ? 0 : 4), true);
  for (int p = 0; p < 8; ++p) {
    for (int s = 0; s < 4; ++s) d.liftplan.set(p, s, (p + s) % 4 != 0), d.liftplan.set(p, 4 + s, (p + s) % 4 == 0);
  }
  for (Threads* system : {&d.warp, &d.weft}) {
    std::fill(system->spacing_mm.begin(), system->spacing_mm.end(), 0.5f);
    std::fill(system->thickness_mm.begin(), system->thickness_mm.end(), 0.45f);
  }
  return lay_out(design, drawdown(d), Face::kFront, Period::kWholeDraft);
}

// The contrast of blocks grows with the slant of the view: the fewer threads of each are hidden between the others.
TEST(ThreadSamples, WhatIsSeenRisesWithTheCoverAround) {
  const Cloth cloth = damask();
  const std::vector<float> rise = measure_response(cloth, bake(cloth, {192, 32}), 1 << 14).visible_rise;
  ThreadScene scene(cloth);
  for (const size_t view :
       {kFromAbove, static_cast<size_t>(3 * kViewAzimuths + 3), static_cast<size_t>(2 * kViewAzimuths + 5)}) {
    std::array<std::array<float, 2>, 2> hits{};  // [block][system]
    constexpr int kSide = 128, kCells = 48;
    for (int i = 0; i < kSide * kSide; ++i) {
      const size_t block = i % 2 ? 1 : 0;
      // The middle third of a block, where the tent that measures the coverage around does not reach the other block.
      const float along = (static_cast<float>(i / 2 % kSide) + 0.5f) / kSide;
      const glm::vec2 at{cloth.width_mm * (0.5f * static_cast<float>(block) + (1 + along) / 6),
                         cloth.depth_mm * (static_cast<float>(i / kSide) + 0.5f) / kSide};
      const auto hit = scene.first_thread(scene.grid(), at, response_views()[view], kCells);
      if (hit.system >= 0) hits[block][static_cast<size_t>(hit.system)] += 1;
    }
    const auto warp = [&](size_t block) { return hits[block][0] / (hits[block][0] + hits[block][1]); };
    EXPECT_NEAR(rise[view] / (2 * (warp(0) - warp(1))), 1, 0.15) << response_views()[view].z;
  }
}

TEST(ThreadSamples, FromAboveTheyAreTheCover) {
  const Cloth cloth = plain(8, 0.4f);
  const float width = cloth.ends[0].width_mm / kSpacing;
  const std::array<float, 2> seen = covers(thread_samples(cloth, 1 << 14), kFromAbove);
  EXPECT_NEAR(seen[0] + seen[1], 1 - (1 - width) * (1 - width), 0.01);
}

class FromEverySide : public testing::TestWithParam<bool> {};

TEST_P(FromEverySide, TheyAreWhatRaysMeet) {
  const Cloth cloth = GetParam() ? jammed() : plain(8, 1);
  const ThreadSamples threads = thread_samples(cloth, 1 << 15);
  for (size_t view = 0; view <= kFromAbove; ++view) {
    if (response_views()[view].z < 0.1f) continue;  // lower views see few samples, with much weight each
    const std::array<float, 2> seen = covers(threads, view), met = hits(cloth, view);
    for (size_t s = 0; s < 2; ++s) EXPECT_NEAR(seen[s], met[s], 0.04) << "view " << view << ", system " << s;
  }
}

INSTANTIATE_TEST_SUITE_P(ThreadSamples, FromEverySide, testing::Bool());

TEST(ThreadSamples, WindowsOfALargeClothAnswerAsTheWhole) {
  const ThreadSamples few = thread_samples(plain(8, 1), 1 << 13), many = thread_samples(plain(520, 1), 1 << 13);
  EXPECT_NEAR(static_cast<double>(many.top.size()) / static_cast<double>(few.top.size()), 1, 0.02);
  for (const size_t view : {kFromAbove, kFromAbove / 2, kFromAbove / 2 + kViewAzimuths / 4}) {
    for (size_t s = 0; s < 2; ++s) EXPECT_NEAR(covers(many, view)[s], covers(few, view)[s], 0.03) << "view " << view;
  }
}

TEST(ThreadSamples, NoThreadsNoSamples) { EXPECT_TRUE(thread_samples({}, 100).samples.empty()); }

}  // namespace
}  // namespace weftlight::light
