#include <gtest/gtest.h>

#include "drafts.h"

namespace weftlight {
namespace {

using namespace test;

Cloth whole(const Design& d, const BitMatrix& cells) { return lay_out(d, cells, Face::kFront, Period::kWholeDraft); }

struct RebakeCase {
  int ends, picks, width, height, azimuths;
};
class Rebake : public testing::TestWithParam<RebakeCase> {};

TEST_P(Rebake, EqualsBakeBitForBitAndStaysInItsRectangles) {
  const RebakeCase p = GetParam();
  const Design d = design_of(p.ends, p.picks, 0.5f, 0.45f);
  BitMatrix cells = scattered(p.ends, p.picks, 77);
  const MapsSize size{p.width, p.height, p.azimuths, 2};
  Maps maps = bake(whole(d, cells), size);
  const CellRect rects[] = {{0, 1, 0, 1}, {p.ends - 1, p.ends, p.picks - 1, p.picks},
                            {p.ends / 2, p.ends / 2 + 2, p.picks / 3, p.picks / 3 + 1}};
  for (const CellRect& dirty : rects) {
    for (int y = dirty.pick0; y < dirty.pick1; ++y)
      for (int x = dirty.end0; x < dirty.end1; ++x) cells.set(y, x, !cells.get(y, x));
    const Maps before = maps;
    const Cloth after = whole(d, cells);
    const std::vector<TexelRect> touched = rebake(maps, after, dirty);
    EXPECT_EQ(difference(maps, bake(after, size)), "");
    std::vector<bool> inside(maps.height_mm.at_.size());
    for (const TexelRect& r : touched) {
      ASSERT_TRUE(r.x0 >= 0 && r.y0 >= 0 && r.x1 <= p.width && r.y1 <= p.height);
      for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) inside[static_cast<size_t>(y * p.width + x)] = true;
    }
    for (size_t i = 0; i < inside.size(); ++i)
      if (!inside[i]) {
        ASSERT_EQ(before.height_mm.at_[i], maps.height_mm.at_[i]);
        for (size_t k = 0; k < maps.horizon.size(); ++k) ASSERT_EQ(before.horizon[k].at_[i], maps.horizon[k].at_[i]);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Rebake,
                         testing::Values(RebakeCase{64, 48, 640, 480, 16}, RebakeCase{120, 200, 190, 300, 12},
                                         RebakeCase{1, 1, 32, 32, 8}, RebakeCase{3, 2, 200, 100, 16},
                                         RebakeCase{300, 20, 128, 128, 16}, RebakeCase{40, 40, 400, 400, 0}));

}  // namespace
}  // namespace weftlight
