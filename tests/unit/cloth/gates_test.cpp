// Geometry where methods fail: many threads, long floats, one thread, none. Each gate also runs a method that fails
// there.

#include <gtest/gtest.h>

#include <cmath>

#include "../centre_height.h"
#include "../figures.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::Face, draft::System;

namespace {

constexpr float kSpacing = 0.5f;  // mm
constexpr int kTexels = 16;       // across a thread

/// One thread of another colour in an all-warp or all-weft face of `count` threads of its system.
Design marked(int count, System system, int marker) {
  const bool warp = system == System::kWarp;
  Design d = design_of(warp ? count : 2, warp ? 2 : count, kSpacing, 0.45f);
  d.draft.palette.push_back({0.9f, 0.05f, 0.05f});
  d.draft.threads(system).color[static_cast<size_t>(marker)] = 2;
  return d;
}

/// The maps around thread `at` of the system, 3 threads wide.
Maps around(const Design& d, System system, int at) {
  const bool warp = system == System::kWarp;
  const Cloth cloth = lay_out(d, cells_of(d.draft.ends(), d.draft.picks(), [&](int, int) { return warp; }),
                              Face::kFront, Period::kWholeDraft);
  const MapsSize whole{d.draft.ends() * kTexels, d.draft.picks() * kTexels, 0, 2};
  const float along = (static_cast<float>(at) + 0.5f) * kSpacing;
  return bake(cloth, whole,
              window_around(cloth, whole, warp ? along : kSpacing, warp ? kSpacing : along, 3 * kTexels, 3 * kTexels));
}

/// Red over green and blue in the middle of a window.
double redness(const Maps& m) {
  const Linear& c = m.colour.at(3 * kTexels / 2, 3 * kTexels / 2);
  return static_cast<double>(c.r / (c.g + c.b + 1e-6f));
}

TEST(ClothGate, ThreadsPastEachWidthOfANumberKeepTheirColour) {
  for (const auto& [count, past, bits] :
       {std::array{200, 127, 7}, std::array{400, 255, 8}, std::array{66000, 65535, 16}}) {
    for (const System system : {System::kWarp, System::kWeft}) {
      const int marker = past + 40;
      const Design d = marked(count, system, marker);
      const Maps here = around(d, system, marker);
      const int narrow = marker & past;  // index after truncation to so many bits
      const double ours = redness(here), fails = redness(around(d, system, narrow));
      figure("redness of a red thread past " + std::to_string(past), fails, ours);
      EXPECT_EQ(here.thread.at(3 * kTexels / 2, 3 * kTexels / 2), static_cast<uint32_t>(marker)) << bits << " bits";
      EXPECT_GT(ours, 4);
      // Its neighbours are not it.
      EXPECT_LT(redness(around(d, system, marker - 1)), 1.5);
      EXPECT_LT(redness(around(d, system, marker + 1)), 1.5);
    }
  }
}

float highest(const Cloth& cloth, System system) {
  float most = 0;
  const float length = system == System::kWarp ? cloth.depth_mm : cloth.width_mm;
  for (int i = 0; i < 4000; ++i)
    most = std::max(most, centre_height_mm(cloth, system, 0, length * static_cast<float>(i) / 4000));
  return most;
}

TEST(ClothGate, FloatsAsLongAsTheClothRiseNoFurther) {
  constexpr int kThreads = 600;
  // End 0 floats over all picks but one; its neighbours are plain.
  const auto cells = cells_of(8, kThreads, [](int e, int p) { return e == 0 ? p != 0 : (e + p) % 2 == 0; });
  const Cloth cloth = lay_out(design_of(8, kThreads, kSpacing, 0.45f), cells, Face::kFront, Period::kWholeDraft);
  const Cloth woven = lay_out(design_of(8, 8, kSpacing, 0.45f), plain(8, 8), Face::kFront, Period::kWholeDraft);
  const float ours = highest(cloth, System::kWarp), one = highest(woven, System::kWarp);
  // A height that grows with the float without a bound.
  const float unbounded = one * (kThreads - 1);
  const float body = cloth.ends[0].height_mm + cloth.picks[0].height_mm;
  figure("height in mm of a float over 599 picks", static_cast<double>(unbounded), static_cast<double>(ours));
  EXPECT_GE(ours, one);
  EXPECT_LT(ours, body);
}

/// Mean coverage, and whether all maps are finite.
double checked_cover(const Maps& m) {
  double sum = 0;
  for (size_t i = 0; i < m.coverage.at_.size(); ++i) {
    const float c = m.coverage.at_[i];
    EXPECT_TRUE(c >= 0 && c <= 1);
    EXPECT_TRUE(std::isfinite(m.height_mm.at_[i]) && std::isfinite(m.slope.at_[i].x) &&
                std::isfinite(m.colour.at_[i].r));
    sum += static_cast<double>(c);
  }
  return sum / static_cast<double>(m.coverage.at_.size());
}

TEST(ClothGate, ThreadsOfNoAndOfEnormousThicknessCoverAShare) {
  for (const float thickness : {0.0f, 1e-4f, 0.2f, 100.0f, 1e9f}) {
    const Design d = design_of(4, 4, kSpacing, thickness);
    const double ours =
        checked_cover(bake(lay_out(d, plain(4, 4), Face::kFront, Period::kWholeDraft), {128, 128, 8, 2}));
    // Peirce's cover of two systems with the threads' free width: k + k' - k k'.
    const double k = static_cast<double>(thickness / kSpacing), naive = 2 * k - k * k;
    figure("cover with threads of " + text(thickness) + " mm", naive, ours);
    if (thickness > 1) {
      EXPECT_GT(ours, 0.9);
    } else {
      EXPECT_NEAR(ours, naive, 0.05);
    }
  }
}

TEST(ClothGate, OneThreadAndOneSidedFacesAreCloth) {
  for (const auto& [ends, picks, up] :
       {std::array{1, 1, 1}, std::array{1, 1, 0}, std::array{6, 5, 1}, std::array{6, 5, 0}, std::array{1, 300, 1}}) {
    const auto cells = cells_of(ends, picks, [&, warp = up](int, int) { return warp == 1; });
    const Cloth cloth = lay_out(design_of(ends, picks, kSpacing, 0.45f), cells, Face::kFront, Period::kWholeDraft);
    EXPECT_GT(checked_cover(bake(cloth, {64, 64, 8, 2})), 0.8) << ends << " x " << picks;
    // The seed paper's mean float, crossings over runs; such a face has no runs.
    int runs = 0;
    for (int p = 0; p < picks; ++p) runs += cells.get(p, 0) != cells.get((p + 1) % picks, 0);
    figure("mean float of " + std::to_string(ends) + " x " + std::to_string(picks),
           static_cast<double>(static_cast<float>(ends * picks) / static_cast<float>(runs)), 1);
  }
}

}  // namespace
}  // namespace weftlight::cloth
