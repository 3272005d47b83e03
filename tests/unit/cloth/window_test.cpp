#include <gtest/gtest.h>

#include "drafts.h"

namespace weftlight::cloth {

using draft::Face;

namespace {

/// The texels of a window, which may wrap, of whole maps.
Maps cut(const Maps& m, const TexelRect& r) {
  const int w = r.x1 - r.x0, h = r.y1 - r.y0;
  const auto of = [&](const auto& plane) {
    auto out = plane;
    out.width = w, out.height = h;
    out.at_.resize(static_cast<size_t>(w) * static_cast<size_t>(h));
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x)
        out.at(x, y) = plane.at(((r.x0 + x) % plane.width + plane.width) % plane.width,
                                ((r.y0 + y) % plane.height + plane.height) % plane.height);
    return out;
  };
  Maps out = m;
  out.height_mm = of(m.height_mm), out.coverage = of(m.coverage), out.colour = of(m.colour);
  out.groove = of(m.groove), out.slope = of(m.slope), out.tangent = of(m.tangent);
  out.system = of(m.system), out.thread = of(m.thread), out.occlusion = of(m.occlusion);
  for (auto& plane : out.horizon) plane = of(plane);
  return out;
}

TEST(BakeWindow, HasTheBitsOfTheWholeAlsoAcrossTheEdges) {
  const Cloth c = lay_out(design_of(60, 44, 0.5f, 0.45f), scattered(60, 44, 77), Face::kFront, Period::kWholeDraft);
  for (const MapsSize& size : {MapsSize{900, 700, 16, 2}, MapsSize{900, 300, 12, 2}, MapsSize{90, 61, 8, 1}}) {
    const Maps all = bake(c, size);
    const int w = size.width, h = size.height;
    const TexelRect windows[] = {{w / 2, h / 2, w / 2 + 50, h / 2 + 30},
                                 {-20, -30, 40, 10},
                                 {w - 10, 5, w + 30, 6},
                                 {-3 * w - 7, 2 * h - 9, -3 * w + 11, 2 * h + 9},
                                 {0, 0, 1, 1},
                                 {7, 5, w + 7, h + 5},
                                 {0, 10, w, 20}};
    for (const TexelRect& r : windows)
      EXPECT_EQ(difference(bake(c, size, r), cut(all, r)), "") << w << "x" << h << " from " << r.x0 << ", " << r.y0;
  }
}

TEST(BakeWindow, IsAtMostOnePeriodAndAtLeastATexel) {
  const Cloth c = lay_out(design_of(4, 4, 0.5f, 0.45f), plain(4, 4), Face::kFront, Period::kWholeDraft);
  const Maps most = bake(c, {64, 32, 4, 1}, {-1000, -1000, 1000, 1000});
  EXPECT_EQ(most.height_mm.width, 64);
  EXPECT_EQ(most.height_mm.height, 32);
  EXPECT_FLOAT_EQ(most.width_mm, c.width_mm);
  const Maps least = bake(c, {64, 32, 4, 1}, {5, 5, 2, 2});
  EXPECT_EQ(least.height_mm.width, 1);
  EXPECT_FLOAT_EQ(least.depth_mm, c.depth_mm / 32);
  EXPECT_EQ(bake(Cloth{}, {64, 32, 4, 1}, {0, 0, 8, 8}).horizon.front().height, 8);
}

TEST(BakeHorizons, AreThoseOfTheWholeBake) {
  const Cloth c = lay_out(design_of(6, 4, 0.5f, 0.45f), plain(6, 4), Face::kFront, Period::kWholeDraft);
  const MapsSize size{96, 64, 8, 2};
  const Maps all = bake(c, size), sky = bake_horizons(c, size);
  ASSERT_EQ(sky.horizon.size(), 8u);
  for (size_t k = 0; k < 8; ++k) EXPECT_EQ(sky.horizon[k].at_, all.horizon[k].at_);
  EXPECT_EQ(sky.occlusion.at_, all.occlusion.at_);
  EXPECT_EQ(sky.width_mm, all.width_mm);
  EXPECT_TRUE(sky.colour.at_.empty());
  EXPECT_EQ(bake_horizons(Cloth{}, size).horizon.front().height, 64);
}

TEST(BakeWindow, OfALargeDraftCostsOnlyItself) {
  // 20,000 x 40,000 texels as a whole.
  const int ends = 1250, picks = 2500;
  const Cloth c =
      lay_out(design_of(ends, picks, 0.5f, 0.45f), scattered(ends, picks, 9), Face::kFront, Period::kWholeDraft);
  const MapsSize whole{ends * 16, picks * 16, 8, 2};
  const Maps m = bake(c, whole, window_around(c, whole, 0.5f * c.width_mm, 0.5f * c.depth_mm, 64, 64));
  EXPECT_EQ(m.height_mm.width, 64);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e)
      EXPECT_EQ(m.system.at(16 * e + 8, 16 * p + 8), c.up.get(picks / 2 - 2 + p, ends / 2 - 2 + e) ? 0 : 1);
}

}  // namespace
}  // namespace weftlight::cloth
