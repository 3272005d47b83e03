// The relief of washing, and the cloth before it.

#include "cloth/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "drafts.h"
#include "weaves/weaves.h"

namespace weftlight::cloth {

using draft::Face, draft::drawdown;

namespace {

constexpr int kCell = 8;  // threads of a waffle on five shafts

Cloth cloth_of(const Design& design, Face face = Face::kFront) {
  return lay_out(design, drawdown(design.draft), face, Period::kWholeDraft);
}

/// A cell is 4 mm wide.
Design waffle() {
  Design d = weaves::waffle(5, {4 * kCell, 4 * kCell});
  d.draft.warp.spacing_mm.assign(static_cast<size_t>(d.draft.ends()), 0.5f);
  d.draft.weft.spacing_mm.assign(static_cast<size_t>(d.draft.picks()), 0.5f);
  d.plan.warp_shrinkage = d.plan.weft_shrinkage = 0.2f;
  return d;
}

/// Floats of the crossing's own thread on the face and of the one behind, added up as a weaver counts them.
int float_on_face(const BitMatrix& up, int pick, int end) {
  const bool is = up.get(pick, end);
  int n = 1;
  for (const int way : {-1, 1}) {
    for (int k = 1; k < kCell; ++k) {
      const int p = is ? (pick + way * k + up.rows()) % up.rows() : pick;
      const int e = is ? end : (end + way * k + up.cols()) % up.cols();
      if (up.get(p, e) != is) break;
      ++n;
    }
  }
  return n;
}

TEST(Relief, TwillsSatinsBasketsAndPlainWeaveStayFlat) {
  const Design d = design_of(16, 16, 0.5f, 0.3f);
  for (const BitMatrix& cells : {plain(16, 16), twill(16, 16), satin(16, 16),
                                 cells_of(16, 16, [](int e, int p) { return (e / 2 + p) % 2 == 0; }),
                                 cells_of(16, 16, [](int e, int p) { return (e / 2 + p / 2) % 2 == 0; })})
    EXPECT_TRUE(lay_out(d, cells, Face::kFront, Period::kWholeDraft).warp_level_mm.empty());
}

TEST(Relief, AWaffleHasFramesOfFloatsAroundSunkenSquares) {
  const Cloth cloth = cloth_of(waffle());
  ASSERT_FALSE(cloth.warp_level_mm.empty());
  EXPECT_EQ(cloth.warp_level_mm, cloth.weft_level_mm);
  const auto [low, high] = std::ranges::minmax_element(cloth.warp_level_mm);
  const auto at = [&](auto it) {
    const int i = static_cast<int>(it - cloth.warp_level_mm.begin());
    return std::pair{i / cloth.up.cols(), i % cloth.up.cols()};
  };
  const auto [high_pick, high_end] = at(high);
  int longest = 0, longest_near = 0;
  for (int p = 0; p < cloth.up.rows(); ++p)
    for (int e = 0; e < cloth.up.cols(); ++e) longest = std::max(longest, float_on_face(cloth.up, p, e));
  for (int p = -1; p <= 1; ++p)
    for (int e = -1; e <= 1; ++e)
      longest_near =
          std::max(longest_near, float_on_face(cloth.up, (high_pick + p + 32) % 32, (high_end + e + 32) % 32));
  EXPECT_GE(longest, kCell - 1);
  EXPECT_GE(longest_near, longest - 2);
  // A cell of 4 mm is a millimetre deep, or somewhat more.
  EXPECT_GT(*high - *low, 0.9f);
  EXPECT_LT(*high - *low, 1.6f);
  // Half a cell from a ridge lies a valley, and the back has its own where the front has ridges.
  const auto level = [&](int p, int e) { return cloth.warp_level_mm[static_cast<size_t>((p % 32) * 32 + e % 32)]; };
  EXPECT_LT(level(high_pick + kCell / 2, high_end + kCell / 2), 0.5f * *low);
  const Cloth back = cloth_of(waffle(), Face::kBack);
  for (size_t i = 0; i < back.warp_level_mm.size(); ++i) EXPECT_EQ(back.warp_level_mm[i], -cloth.warp_level_mm[i]);
}

TEST(Relief, AChangedCellMovesOnlyItsNeighbours) {
  const Cloth before = cloth_of(waffle());
  Cloth after = before;
  constexpr int kPick = 13, kEnd = 10;
  after.up.set(kPick, kEnd, !after.up.get(kPick, kEnd));
  const std::vector<float> is = washed_relief(after, 1, 0.2f), was = washed_relief(before, 1, 0.2f);
  int moved = 0;
  for (int p = 0; p < after.up.rows(); ++p) {
    for (int e = 0; e < after.up.cols(); ++e) {
      const size_t i = static_cast<size_t>(p * after.up.cols() + e);
      if (is[i] == was[i]) continue;
      ++moved;
      EXPECT_LE(std::max(std::abs(p - kPick), std::abs(e - kEnd)), kReliefReach);
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(Washed, OffTheLoomAClothIsLargerThinnerAndFlat) {
  Design d = waffle();
  const Cloth washed = cloth_of(d);
  d.finish.washed = 0;
  const Cloth loom = cloth_of(d);
  EXPECT_TRUE(loom.warp_level_mm.empty());
  EXPECT_NEAR(loom.width_mm, washed.width_mm / 0.8f, 1e-4f);
  EXPECT_NEAR(loom.depth_mm, washed.depth_mm / 0.8f, 1e-4f);
  EXPECT_LT(loom.ends[0].diameter_mm, washed.ends[0].diameter_mm);
  EXPECT_GT(loom.ends[0].diameter_mm, 0.9f * washed.ends[0].diameter_mm);
  d.finish.washed = 0.5f;
  const Cloth half = cloth_of(d);
  EXPECT_NEAR(half.width_mm, washed.width_mm / 0.9f, 1e-4f);
  EXPECT_NEAR(*std::ranges::max_element(half.warp_level_mm),
              0.5f / 0.9f * *std::ranges::max_element(washed.warp_level_mm), 1e-4f);
}

TEST(Washed, TheSettOfTheDraftIsTheFinishedOneAlsoWhereTheYarnGivesIt) {
  Design d = waffle();
  d.draft.warp.spacing_mm.assign(static_cast<size_t>(d.draft.ends()), draft::kFromYarn);
  const Cloth washed = cloth_of(d);
  d.plan.weft_shrinkage = 0.1f, d.finish.washed = 0;
  EXPECT_NEAR(cloth_of(d).width_mm, washed.width_mm / 0.9f, 1e-4f);
}

}  // namespace
}  // namespace weftlight::cloth
