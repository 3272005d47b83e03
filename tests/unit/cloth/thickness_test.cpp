// Thickness along a thread: unevenness as the yarn has it, within the thread's spacing, the same in maps, bodies and
// heights.

#include "cloth/thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloth/thread_scene.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::Face, draft::System;

namespace {

constexpr int kThreads = 160;

/// Plain weave 0.5 mm apart.
Cloth uneven(float cv_percent, float thickness_mm, int threads = kThreads) {
  Design d = design_of(threads, threads, 0.5f, thickness_mm);
  d.yarns[0].unevenness = cv_percent;
  return lay_out(d, plain(threads, threads), Face::kFront, Period::kWholeDraft);
}

/// Mean and coefficient of variation of the sections of all ends.
std::pair<double, double> section_spread(const Cloth& cloth) {
  double sum = 0, squares = 0;
  const int n = static_cast<int>(cloth.ends.size());
  for (int e = 0; e < n; ++e) {
    for (int p = 0; p < n; ++p) {
      const glm::vec2 half = half_section(cloth, System::kWarp, e, p);
      const double area = static_cast<double>(4 * half.x * half.y);
      sum += area, squares += area * area;
    }
  }
  const double mean = sum / (n * n);
  return {mean, std::sqrt(std::max(squares / (n * n) - mean * mean, 0.0)) / mean};
}

TEST(Unevenness, MassVariesAsTheYarnSays) {
  const Cloth even = uneven(0, 0.2f);
  const double area = static_cast<double>(even.ends[0].width_mm * even.ends[0].height_mm);
  for (const float cv : {10.0f, 20.0f, 35.0f}) {
    const auto [mean, spread] = section_spread(uneven(cv, 0.2f));
    EXPECT_NEAR(spread, 0.01 * static_cast<double>(cv), 0.15 * 0.01 * static_cast<double>(cv)) << cv;
    EXPECT_NEAR(mean / area, 1, 0.05) << cv;
  }
}

TEST(Unevenness, FilamentAndShortRepeatsAreEven) {
  EXPECT_LT(section_spread(uneven(0, 0.2f)).second, 1e-5);
  // Two threads are 1 mm long: too short for a thick and a thin place.
  EXPECT_LT(section_spread(uneven(40, 0.2f, 2)).second, 0.02);
}

TEST(Unevenness, AThreadKeepsToItsRoom) {
  const Cloth cloth = uneven(60, 0.45f);
  float widest = 0, tallest = 0;
  for (int e = 0; e < kThreads; ++e) {
    for (int p = 0; p < kThreads; ++p) {
      const glm::vec2 half = half_section(cloth, System::kWarp, e, p);
      widest = std::max(widest, half.x), tallest = std::max(tallest, half.y);
    }
  }
  EXPECT_LE(widest, 0.25f + 1e-6f);
  EXPECT_GT(tallest, 0.6f * cloth.ends[0].height_mm);
  EXPECT_LE(tallest, tallest_half(cloth, System::kWarp) + 1e-6f);
}

TEST(Unevenness, ThePeriodHasNoSeam) {
  const Cloth cloth = uneven(40, 0.2f);
  for (int e = 0; e < kThreads; ++e) {
    for (int p = 0; p < kThreads; ++p) {
      const float here = half_section(cloth, System::kWarp, e, p).y,
                  next = half_section(cloth, System::kWarp, e, p + 1).y;
      EXPECT_LT(std::abs(next - here), 0.25f * cloth.ends[0].height_mm) << e << ' ' << p;
    }
  }
}

TEST(Unevenness, BodiesAndMapsAndHeightsAgree) {
  const Cloth cloth = uneven(40, 0.3f, 48);
  ThreadScene threads(cloth);
  const auto grid = threads.grid();
  const MapsSize size{1024, 1024, 0};
  const Maps maps = bake(cloth, size);
  int other = 0, compared = 0;
  double apart = 0, plain_apart = 0;
  for (int y = 3; y < size.height; y += 7) {
    for (int x = 3; x < size.width; x += 7) {
      const glm::vec2 at{(static_cast<float>(x) + 0.5f) * cloth.width_mm / 1024,
                         (static_cast<float>(y) + 0.5f) * cloth.depth_mm / 1024};
      const auto crossing = threads.crossing_near(grid, at);
      const auto hit = threads.first_thread(grid, at, {0, 0, 1}, 0);
      if (maps.coverage.at(x, y) < 0.999f) continue;
      if (hit.system < 0) {
        ++other;
        continue;
      }
      ++compared;
      apart += static_cast<double>(std::abs(hit.at.z - maps.height_mm.at(x, y)));
      plain_apart += static_cast<double>(crossing.warp.half_height);
    }
  }
  ASSERT_GT(compared, 5000);
  EXPECT_LT(other, compared / 100);
  EXPECT_LT(apart / plain_apart, 0.04);
}

}  // namespace
}  // namespace weftlight::cloth
