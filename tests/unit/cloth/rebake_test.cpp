#include <gtest/gtest.h>

#include <functional>

#include "cloth/texel_cover.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::BitMatrix, draft::Face;

namespace {

Cloth whole(const Design& d, const BitMatrix& cells) { return lay_out(d, cells, Face::kFront, Period::kWholeDraft); }

/// Rebakes the maps of `before` for `after`: the result is right, and nothing changed outside the rectangles.
void expect_rebaked(Maps& maps, const Cloth& before, const Cloth& after, const MapsSize& size) {
  const Maps was = maps;
  const std::vector<TexelRect> touched = rebake(maps, before, after);
  EXPECT_EQ(difference(maps, bake(after, size)), "");
  Plane<uint8_t> inside(size.width, size.height);
  for (const TexelRect& r : touched) {
    ASSERT_TRUE(r.x0 >= 0 && r.y0 >= 0 && r.x1 <= size.width && r.y1 <= size.height);
    for (int y = r.y0; y < r.y1; ++y)
      for (int x = r.x0; x < r.x1; ++x) ASSERT_EQ(inside.at(x, y)++, 0) << "rectangles overlap";
  }
  for (size_t i = 0; i < inside.at_.size(); ++i) {
    if (inside.at_[i]) continue;
    ASSERT_EQ(was.height_mm.at_[i], maps.height_mm.at_[i]);
    ASSERT_EQ(was.occlusion.at_[i], maps.occlusion.at_[i]);
    for (size_t k = 0; k < maps.horizon.size(); ++k) ASSERT_EQ(was.horizon[k].at_[i], maps.horizon[k].at_[i]);
  }
}

struct RebakeCase {
  int ends, picks, width, height, azimuths;
};
class Rebake : public testing::TestWithParam<RebakeCase> {};

/// Flips the cells that `chosen` names, one change after the other, in several weaves.
void change_all(const RebakeCase& p, const std::vector<std::function<bool(int, int)>>& changes) {
  const Design d = design_of(p.ends, p.picks, 0.5f, 0.45f);
  const MapsSize size{p.width, p.height, p.azimuths, 2};
  for (BitMatrix cells : {scattered(p.ends, p.picks, 77), satin(p.ends, p.picks), plain(p.ends, p.picks)}) {
    Cloth cloth = whole(d, cells);
    Maps maps = bake(cloth, size);
    for (const auto& chosen : changes) {
      for (int y = 0; y < p.picks; ++y)
        for (int x = 0; x < p.ends; ++x)
          if (chosen(x, y)) cells.set(y, x, !cells.get(y, x));
      const Cloth after = whole(d, cells);
      expect_rebaked(maps, cloth, after, size);
      cloth = after;
    }
  }
}

TEST_P(Rebake, OneCellEqualsBakeBitForBit) {
  const RebakeCase p = GetParam();
  change_all(p, {[](int e, int y) { return e == 0 && y == 0; },
                 [&](int e, int y) { return e == p.ends - 1 && y == p.picks - 1; },
                 [&](int e, int y) { return e / 2 == p.ends / 4 && y == p.picks / 3; }});
}

TEST_P(Rebake, ScatteredCellsEqualBakeBitForBit) {
  const RebakeCase p = GetParam();
  change_all(p, {[&](int e, int y) { return e == p.ends / 2 && y % 4 == 1; },   // a threading cell
                 [&](int e, int y) { return e % 8 == 3 && y == p.picks / 2; },  // a liftplan cell
                 [](int e, int y) { return e % 8 == 3 && y % 8 == 5; }});       // a tie-up cell
}

TEST(Rebake, UnevenThreadsEqualBakeBitForBit) {
  Design d = design_of(40, 30, 0.5f, 0.45f);
  d.yarns[0].unevenness = 40, d.yarns[0].irregularity = 0.15f;
  const MapsSize size{320, 240, 8, 2};
  BitMatrix cells = satin(40, 30);
  Cloth cloth = whole(d, cells);
  Maps maps = bake(cloth, size);
  // Threads at the edges of the period reach over them.
  for (const auto& [end, pick] : {std::pair{0, 0}, {39, 29}, {20, 13}}) {
    cells.set(pick, end, !cells.get(pick, end));
    const Cloth after = whole(d, cells);
    expect_rebaked(maps, cloth, after, size);
    cloth = after;
  }
}

TEST(Rebake, ThreadsThatWashingMovesEqualBakeBitForBit) {
  Design d = design_of(48, 36, 0.5f, 0.25f);
  d.yarns[0].unevenness = 20;
  const MapsSize size{384, 288, 8, 2};
  BitMatrix cells = cells_of(48, 36, [](int e, int p) {
    const bool group = (e / 3 + p / 3) % 2 == 0;
    return p % 3 == 1 ? group : group == (e % 3 != 1);
  });
  Cloth cloth = whole(d, cells);
  ASSERT_FALSE(cloth.warp_aside_mm.empty());
  Maps maps = bake(cloth, size);
  for (const auto& [end, pick] : {std::pair{0, 0}, {47, 35}, {20, 13}, {24, 18}}) {
    cells.set(pick, end, !cells.get(pick, end));
    const Cloth after = whole(d, cells);
    expect_rebaked(maps, cloth, after, size);
    cloth = after;
  }
}

TEST(Rebake, WithoutTheOldMapsTheTouchedTexelsAreTheSame) {
  for (const float thickness : {0.45f, 0.25f}) {  // straight, and moved by washing
    const Design d = design_of(60, 40, 0.5f, thickness);
    const MapsSize size{300, 200, 8, 2};
    BitMatrix cells = scattered(60, 40, 5);
    Cloth cloth = whole(d, cells);
    Maps all = bake(cloth, size);
    for (const auto& [end, pick] : {std::pair{0, 0}, {59, 39}, {20, 13}}) {
      cells.set(pick, end, !cells.get(pick, end));
      const Cloth after = whole(d, cells);
      Maps windows;
      const std::vector<TexelRect> touched = bake_changed(windows, cloth, after, size);
      Plane<uint8_t> inside(size.width, size.height);
      for (const TexelRect& r : touched) {
        EXPECT_TRUE(r.x0 % 2 == 0 && r.y0 % 2 == 0 && r.x1 % 2 == 0 && r.y1 % 2 == 0);
        for (int y = r.y0; y < r.y1; ++y)
          for (int x = r.x0; x < r.x1; ++x) inside.at(x, y) = 1;
      }
      for (const TexelRect& r : rebake(all, cloth, after))
        for (int y = r.y0; y < r.y1; ++y)
          for (int x = r.x0; x < r.x1; ++x) ASSERT_EQ(inside.at(x, y), 1);
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          if (inside.at(x, y) == 0) continue;
          ASSERT_EQ(windows.height_mm.at(x, y), all.height_mm.at(x, y));
          ASSERT_EQ(windows.occlusion.at(x, y), all.occlusion.at(x, y));
          ASSERT_EQ(windows.thread.at(x, y), all.thread.at(x, y));
          for (size_t k = 0; k < all.horizon.size(); ++k)
            ASSERT_EQ(windows.horizon[k].at(x, y), all.horizon[k].at(x, y));
        }
      }
      cloth = after;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, Rebake,
                         testing::Values(RebakeCase{32, 24, 320, 240, 16}, RebakeCase{120, 200, 190, 300, 12},
                                         RebakeCase{1, 1, 32, 32, 8}, RebakeCase{3, 2, 200, 100, 16},
                                         RebakeCase{300, 20, 128, 128, 16}, RebakeCase{40, 40, 400, 400, 0}));

TEST(Rebake, NothingChangedTouchesNothing) {
  const Cloth c = whole(design_of(6, 6, 0.5f, 0.45f), plain(6, 6));
  Maps maps = bake(c, {60, 60, 8, 1});
  EXPECT_TRUE(rebake(maps, c, c).empty());
}

TEST(Cover, HoldsEveryBitWithoutOverlap) {
  uint32_t seed = 5;
  const auto random = [&](uint32_t n) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % n;
  };
  for (int round = 0; round < 200; ++round) {
    BitMatrix mask(1 + static_cast<int>(random(40)), 1 + static_cast<int>(random(200)));
    for (uint32_t i = 0, n = random(9); i < n; ++i) {
      const int from = static_cast<int>(random(static_cast<uint32_t>(mask.cols())));
      const int y = static_cast<int>(random(static_cast<uint32_t>(mask.rows())));
      for (int r = y; r < std::min(mask.rows(), y + 5); ++r)
        set_run(mask.row(r), from, std::min(mask.cols(), from + 70));
    }
    BitMatrix held(mask.rows(), mask.cols());
    for (const TexelRect& r : cover(mask, 20)) {
      for (int y = r.y0; y < r.y1; ++y)
        for (int x = r.x0; x < r.x1; ++x) {
          ASSERT_FALSE(held.get(y, x));
          held.set(y, x, true);
        }
    }
    for (int y = 0; y < mask.rows(); ++y)
      for (int x = 0; x < mask.cols(); ++x) ASSERT_TRUE(held.get(y, x) || !mask.get(y, x));
  }
}

TEST(Cover, KeepsFarRunsApartAndJoinsNearOnes) {
  BitMatrix mask(50, 300);
  for (int y = 10; y < 20; ++y) set_run(mask.row(y), 3, 5), set_run(mask.row(y), 200, 299);
  set_run(mask.row(30), 0, 100), set_run(mask.row(30), 110, 300);
  EXPECT_EQ(cover(mask, 40).size(), 3u);
}

}  // namespace
}  // namespace weftlight::cloth
