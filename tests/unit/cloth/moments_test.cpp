#include "cloth/moments.h"

#include <gtest/gtest.h>

#include <cmath>

#include "drafts.h"

namespace weftlight::cloth {
namespace {

double mean(const Plane<float>& plane) {
  double sum = 0;
  for (float v : plane.at_) sum += static_cast<double>(v);
  return sum / static_cast<double>(plane.at_.size());
}

struct Made {
  Cloth cloth;
  Maps maps;
  std::vector<MomentLevel> levels;
};
Made made(int threads, int width, int height) {
  Made m;
  m.cloth = lay_out(design_of(threads, threads, 0.5f, 0.4f), scattered(threads, threads, 9), Face::kFront,
                    Period::kWholeDraft);
  m.maps = bake(m.cloth, {width, height, 8, 2});
  m.levels = moments(m.cloth, m.maps, width, height);
  return m;
}

TEST(Moments, EveryLevelKeepsTheMeans) {
  const Made m = made(8, 117, 90);  // odd sizes: texels of three
  ASSERT_EQ(m.levels.back().width, 1);
  ASSERT_EQ(m.levels.back().height, 1);
  for (size_t p = 0; p < kMomentPlanes; ++p)
    for (const MomentLevel& level : m.levels) {
      EXPECT_NEAR(mean(level.warp[p]), mean(m.levels[0].warp[p]), 1e-5 + 1e-5 * std::abs(mean(m.levels[0].warp[p])));
      EXPECT_NEAR(mean(level.weft[p]), mean(m.levels[0].weft[p]), 1e-5 + 1e-5 * std::abs(mean(m.levels[0].weft[p])));
    }
}

TEST(Moments, CoverageAndColourAreTheMaps) {
  const Made m = made(8, 128, 128);
  double cover = 0, red = 0;
  for (size_t i = 0; i < m.maps.coverage.at_.size(); ++i) {
    cover += static_cast<double>(m.maps.coverage.at_[i]);
    red += static_cast<double>(m.maps.coverage.at_[i] * m.maps.groove.at_[i] * m.maps.colour.at_[i].r);
  }
  const double n = 128 * 128;
  const MomentLevel& last = m.levels.back();
  EXPECT_NEAR(mean(last.warp[kWeight]) + mean(last.weft[kWeight]), cover / n, 1e-5);
  EXPECT_NEAR(mean(last.warp[kRed]) + mean(last.weft[kRed]), red / n, 1e-5);
}

TEST(Moments, CoarseMapsHaveTheMomentsOfFineOnes) {
  Design d = design_of(64, 64, 0.5f, 0.4f);
  const Cloth c = lay_out(d, scattered(64, 64, 31), Face::kFront, Period::kWholeDraft);
  const auto whole = [&](int size) {
    const Maps maps = bake(c, {size, size, 0, 2});
    return moments(c, maps, size, size).back();
  };
  const MomentLevel coarse = whole(24), fine = whole(64 * 16);
  for (auto side : {&MomentLevel::warp, &MomentLevel::weft}) {
    const Facet a = facet_at(coarse.*side, 0, 0), b = facet_at(fine.*side, 0, 0);
    EXPECT_NEAR(a.weight, b.weight, 0.02f);
    EXPECT_NEAR(a.colour.r, b.colour.r, 0.02f * b.colour.r);
    EXPECT_NEAR(a.slope.x, b.slope.x, 0.02f);
    EXPECT_NEAR(a.slope.y, b.slope.y, 0.02f);
  }
}

TEST(Moments, SpreadLiesAcrossTheThreads) {
  // Ends alone on top: their round sides spread slopes across x, none along y.
  const Cloth c = lay_out(design_of(8, 8, 0.5f, 0.4f), cells_of(8, 8, [](int, int) { return true; }), Face::kFront,
                          Period::kWholeDraft);
  const Maps maps = bake(c, {256, 256, 4, 2});
  const Facet f = facet_at(moments(c, maps, 256, 256).back().warp, 0, 0);
  EXPECT_GT(f.xx, 0.1f);
  EXPECT_LT(f.yy, 1e-3f);
  EXPECT_NEAR(f.slope.x, 0.0f, 1e-3f);
}

TEST(Moments, NothingThereIsZeroNotNan) {
  const Cloth c = lay_out(design_of(2, 2, 0.5f, 0.0f), plain(2, 2), Face::kFront, Period::kWholeDraft);
  const Maps maps = bake(c, {16, 16, 4, 1});
  for (const MomentLevel& level : moments(c, maps, 16, 16)) {
    const Facet f = facet_at(level.warp, 0, 0);
    EXPECT_EQ(f.weight, 0.0f);
    EXPECT_EQ(f.xx, 0.0f);
    EXPECT_EQ(level.horizon[0].at(0, 0), 0);
  }
}

TEST(Moments, HorizonSpreadIsZeroOnTheFinestLevelAndMeanIsKept) {
  const Made m = made(8, 64, 64);
  for (size_t i = 0; i < m.maps.horizon[2].at_.size(); ++i) {
    EXPECT_NEAR(m.levels[0].horizon[2].at_[i], m.maps.coverage.at_[i] > 0 ? m.maps.horizon[2].at_[i] : 0, 1);
    EXPECT_LE(m.levels[0].horizon_spread[2].at_[i], 1);
  }
  EXPECT_GT(m.levels[3].horizon_spread[2].at(0, 0), 5);
}

}  // namespace
}  // namespace weftlight::cloth
