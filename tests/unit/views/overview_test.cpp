#include <gtest/gtest.h>

#include <random>

#include "views/common/overview_image.h"

namespace weftlight::views {

using draft::BitMatrix;

namespace {

struct Cloth {
  BitMatrix cells;
  std::vector<ImU32> warp, weft;
};

Cloth random_cloth(int ends, int picks) {
  Cloth c{BitMatrix(picks, ends), {}, {}};
  std::mt19937 dice(7);
  const auto channel = [&] { return static_cast<int>(dice() % 256); };
  const auto color = [&] { return IM_COL32(channel(), channel(), channel(), 255); };
  for (int i = 0; i < ends; ++i) c.warp.push_back(color());
  for (int i = 0; i < picks; ++i) c.weft.push_back(color());
  for (int p = 0; p < picks; ++p)
    for (int e = 0; e < ends; ++e) c.cells.set(p, e, dice() % 3 == 0);
  return c;
}

/// The mean over the crossings of one pixel, one by one.
ImU32 mean_of(const Cloth& c, bool front, int width, int height, int x, int y) {
  const auto first = [](int p, int pixels, size_t count) { return p * static_cast<int>(count) / pixels; };
  int64_t sum[3] = {}, n = 0;
  for (int p = first(y, height, c.weft.size()); p < first(y + 1, height, c.weft.size()); ++p)
    for (int e = first(x, width, c.warp.size()); e < first(x + 1, width, c.warp.size()); ++e, ++n) {
      const ImU32 color = c.cells.get(p, e) == front ? c.warp[static_cast<size_t>(e)] : c.weft[static_cast<size_t>(p)];
      for (int i = 0; i < 3; ++i) sum[i] += (color >> (8 * i)) & 255;
    }
  ImU32 out = IM_COL32_A_MASK;
  for (int i = 0; i < 3; ++i) out |= static_cast<ImU32>((sum[i] + n / 2) / n) << (8 * i);
  return out;
}

TEST(Overview, EveryPixelIsTheMeanOfAllItsCrossings) {
  const Cloth c = random_cloth(333, 275);
  for (const bool front : {true, false}) {
    OverviewImage overview;
    EXPECT_TRUE(overview.update(c.cells, front, {c.warp, c.weft, {}}, 50, 41));
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 50; ++x)
        ASSERT_EQ(overview.image().pixels[static_cast<size_t>(50 * y + x)], mean_of(c, front, 50, 41, x, y))
            << x << ", " << y;
  }
}

TEST(Overview, AThreadHasItsColourAtTheMiddleOfEachPixel) {
  constexpr int kEnds = 8, kPicks = 12;
  design::Design d;
  d.draft = draft::blank_draft(kEnds, kPicks, 1, 1);
  d.yarns[0].dye.stretches = {{3, draft::Rgb{1, 0, 0}, false}, {3, draft::Rgb{0, 0, 1}, false}};
  d.draft.weft.yarn.assign(kPicks, 1);
  d.yarns.emplace_back();
  BitMatrix cells(kPicks, kEnds);
  for (int p = 0; p < kPicks; ++p)
    for (int e = 0; e < kEnds; ++e) cells.set(p, e, true);
  OverviewImage overview;
  EXPECT_TRUE(overview.update(cells, true, crossing_colors(d), kEnds, kPicks / 3));
  for (int y = 0; y < kPicks / 3; ++y)
    for (int x = 0; x < kEnds; ++x)
      EXPECT_EQ(overview.image().pixels[static_cast<size_t>(y * kEnds + x)],
                y % 2 == 0 ? IM_COL32(255, 0, 0, 255) : IM_COL32(0, 0, 255, 255));
  d.yarns[0].dye.shift = 3;
  EXPECT_TRUE(overview.update(cells, true, crossing_colors(d), kEnds, kPicks / 3)) << "the colours changed";
  EXPECT_EQ(overview.image().pixels[1], IM_COL32(0, 0, 255, 255));
}

TEST(Overview, AnEditComputesOnlyThePixelsThatItChanges) {
  Cloth c = random_cloth(2000, 1500);
  OverviewImage overview;
  overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112);
  EXPECT_EQ(overview.computed(), 150 * 112);
  EXPECT_FALSE(overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112)) << "nothing changed";
  c.cells.set(700, 1000, !c.cells.get(700, 1000));
  EXPECT_TRUE(overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112));
  EXPECT_LE(overview.computed(), 8) << "one word of ends";
  for (int p = 0; p < 1500; ++p) c.cells.set(p, 1999, true);
  overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112);
  EXPECT_LE(overview.computed(), 8 * 112);
  c.warp[600] = IM_COL32(1, 2, 3, 255);
  overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112);
  EXPECT_EQ(overview.computed(), 112) << "one end's column";
  c.weft[900] = IM_COL32(1, 2, 3, 255);
  c.cells.set(3, 3, !c.cells.get(3, 3));
  overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112);
  EXPECT_LE(overview.computed(), 150 + 8) << "one pick's row, and a crossing";
  OverviewImage anew;
  anew.update(c.cells, true, {c.warp, c.weft, {}}, 150, 112);
  EXPECT_EQ(overview.image().pixels, anew.image().pixels);
}

TEST(Overview, SmallDraftsHaveAtMostOnePixelPerCrossing) {
  const Cloth c = random_cloth(20, 3);
  OverviewImage overview;
  overview.update(c.cells, true, {c.warp, c.weft, {}}, 150, 30);
  EXPECT_EQ(overview.image().width, 20);
  EXPECT_EQ(overview.image().height, 3);
}

}  // namespace
}  // namespace weftlight::views
