// Uneven threads: their mass varies as the yarn has it, neighbours give way to each other so that the cloth is covered
// as by even threads, and maps, bodies and heights agree.

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
Cloth uneven_cloth(float cv_percent, float thickness_mm, int threads = kThreads, float irregularity = 0) {
  Design d = design_of(threads, threads, 0.5f, thickness_mm);
  d.yarns[0].unevenness = cv_percent, d.yarns[0].irregularity = irregularity;
  return lay_out(d, plain(threads, threads), Face::kFront, Period::kWholeDraft);
}

/// Mean and coefficient of variation of the sections of all ends.
std::pair<double, double> section_spread(const Cloth& cloth) {
  double sum = 0, squares = 0;
  const int n = static_cast<int>(cloth.ends.size());
  for (int e = 0; e < n; ++e) {
    for (int p = 0; p < n; ++p) {
      const glm::vec3 half = section_at(cloth, System::kWarp, e, p);
      const double area = static_cast<double>(4 * half.x * half.y);
      sum += area, squares += area * area;
    }
  }
  const double mean = sum / (n * n);
  return {mean, std::sqrt(std::max(squares / (n * n) - mean * mean, 0.0)) / mean};
}

TEST(Unevenness, MassVariesAsTheYarnSays) {
  const Cloth even = uneven_cloth(0, 0.2f);
  const double area = static_cast<double>(even.ends[0].width_mm * even.ends[0].height_mm);
  for (const float cv : {10.0f, 20.0f, 35.0f}) {
    const auto [mean, spread] = section_spread(uneven_cloth(cv, 0.2f));
    EXPECT_NEAR(spread, 0.01 * static_cast<double>(cv), 0.15 * 0.01 * static_cast<double>(cv)) << cv;
    EXPECT_NEAR(mean / area, 1, 0.05) << cv;
  }
}

TEST(Unevenness, FilamentAndShortRepeatsAreEven) {
  EXPECT_LT(section_spread(uneven_cloth(0, 0.2f)).second, 1e-5);
  // Two threads are 1 mm long: too short for a thick and a thin place.
  EXPECT_LT(section_spread(uneven_cloth(40, 0.2f, 2)).second, 0.02);
}

/// Of the border between an end and the next, seen from either of them.
float border_mm(const Cloth& cloth, int end, int pick, bool from_next) {
  const int n = static_cast<int>(cloth.ends.size()), own = from_next ? (end + 1) % n : end;
  const ThreadBody& t = cloth.ends[static_cast<size_t>(own)];
  const glm::vec3 s = section_at(cloth, System::kWarp, own, pick);
  const float half_room = s.x * room_mm(t) / t.width_mm;
  const float at = t.centre_mm + s.z + (from_next ? -half_room : half_room);
  return from_next && own < end ? at + cloth.width_mm : at;
}

TEST(Unevenness, NeighboursShareOneBorder) {
  const Cloth cloth = uneven_cloth(60, 0.45f, kThreads, 0.1f);
  for (int e = 0; e < kThreads; ++e) {
    for (int p = 0; p < kThreads; ++p) {
      ASSERT_NEAR(border_mm(cloth, e, p, false), border_mm(cloth, e, p, true), 2e-5f) << e << ' ' << p;
      const glm::vec3 s = section_at(cloth, System::kWarp, e, p);
      ASSERT_LE(s.y, tallest_half(cloth, System::kWarp) + 1e-6f);
      ASSERT_LE(s.x + std::abs(s.z), furthest_side(cloth.ends[static_cast<size_t>(e)]) + 1e-6f);
      ASSERT_GT(s.x, 0.15f * 0.5f * cloth.ends[0].width_mm);
    }
  }
}

/// Fraction of the maps that threads cover.
double cover_of(const Cloth& cloth) {
  const Maps maps = bake(cloth, {512, 512, 0});
  double sum = 0;
  for (const float c : maps.coverage.at_) sum += static_cast<double>(c);
  return sum / static_cast<double>(maps.coverage.at_.size());
}

TEST(Unevenness, TheCoverIsThatOfEvenThreads) {
  // Touching threads have no holes beside thin places, and open cloth stays as open.
  for (const float thickness : {0.1f, 0.3f, 0.45f}) {
    const double even = cover_of(uneven_cloth(0, thickness, 48)),
                 own = cover_of(uneven_cloth(35, thickness, 48, 0.12f));
    EXPECT_NEAR(own, even, 0.002) << thickness;
  }
}

TEST(Unevenness, AThreadThatSpreadsGetsThinner) {
  const Cloth even = uneven_cloth(0, 0.45f), cloth = uneven_cloth(0, 0.45f, kThreads, 0.2f);
  const float area = even.ends[0].width_mm * even.ends[0].height_mm, thickness = even.ends[0].diameter_mm;
  for (const ThreadBody& t : cloth.ends) {
    const float factor = t.diameter_mm / thickness;
    if (t.height_mm > 1.49f * t.width_mm) continue;  // as round as a thread gets
    EXPECT_NEAR(t.width_mm * t.height_mm, area * factor * factor, 1e-4f);
  }
}

TEST(Unevenness, ThePeriodHasNoSeam) {
  const Cloth cloth = uneven_cloth(40, 0.2f);
  for (int e = 0; e < kThreads; ++e) {
    for (int p = 0; p < kThreads; ++p) {
      const glm::vec3 here = section_at(cloth, System::kWarp, e, p), next = section_at(cloth, System::kWarp, e, p + 1);
      EXPECT_LT(std::abs(next.y - here.y), 0.25f * cloth.ends[0].height_mm) << e << ' ' << p;
      EXPECT_LT(std::abs(next.z - here.z), 0.1f * cloth.ends[0].spacing_mm) << e << ' ' << p;
    }
  }
}

/// Ends that are wider than their room, over seven picks and under one.
Cloth jammed_satin(int threads) {
  Design d = design_of(threads, threads, 0.5f, 0.6f);
  d.draft.weft.thickness_mm.assign(static_cast<size_t>(threads), 0.3f);
  BitMatrix cells(threads, threads);
  for (int p = 0; p < threads; ++p)
    for (int e = 0; e < threads; ++e) cells.set(p, e, (e * 3 + p) % 8 != 0);
  return lay_out(d, cells, Face::kFront, Period::kWholeDraft);
}

class BodiesAndMaps : public testing::TestWithParam<bool> {};

TEST_P(BodiesAndMaps, AgreeWithUnevenAndWithJammedThreads) {
  const Cloth cloth = GetParam() ? uneven_cloth(40, 0.3f, 48, 0.1f) : jammed_satin(48);
  ThreadScene threads(cloth);
  const auto grid = threads.grid();
  const MapsSize size{1024, 1024, 0};
  const Maps maps = bake(cloth, size);
  int other = 0, compared = 0, threads_apart = 0;
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
      threads_apart +=
          hit.system != maps.system.at(x, y) || static_cast<uint32_t>(hit.strand.thread) != maps.thread.at(x, y);
      apart += static_cast<double>(std::abs(hit.at.z - maps.height_mm.at(x, y)));
      plain_apart += static_cast<double>(crossing.warp.half_height);
    }
  }
  ASSERT_GT(compared, 5000);
  EXPECT_LT(other, compared / 100);
  EXPECT_LT(threads_apart, compared / 50);
  EXPECT_LT(apart / plain_apart, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Unevenness, BodiesAndMaps, testing::Bool());

}  // namespace
}  // namespace weftlight::cloth
