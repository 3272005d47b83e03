#include "design/edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../hand_drafts.h"
#include "design/crossings.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Rgb, draft::ShedControl, draft::System, draft::drawdown, draft::is_consistent,
    draft::kFromYarn, draft::kMaxThreads;

namespace {

Rows cloth(const Design& design) { return text_of(drawdown(design.draft)); }

TEST(Edits, ThreadingMovesTheEndToTheClickedShaft) {
  const Design next = with_threading(straight_twill(4, 4), 1, 3, true);
  EXPECT_EQ(text_of(next.draft.threading)[1], "0001");
  EXPECT_EQ(text_of(with_threading(straight_twill(4, 4), 1, 3, true, false).draft.threading)[1], "0101");
  EXPECT_EQ(text_of(with_threading(straight_twill(4, 4), 1, 1, false).draft.threading)[1], "0000");
}

TEST(Edits, TreadlingMovesThePickToTheClickedTreadle) {
  EXPECT_EQ(text_of(with_treadling(straight_twill(4, 4), 0, 2, true).draft.treadling)[0], "0010");
  EXPECT_EQ(text_of(with_treadling(straight_twill(4, 4), 0, 2, true, false).draft.treadling)[0], "1010");
}

TEST(Edits, ManyThreadsAtOnceEqualOneByOne) {
  const Design d = straight_twill(4, 4);
  const std::vector<int> threads{0, 3, 99, -1};
  Design one_by_one = d;
  for (const int thread : threads) {
    one_by_one = with_thread_thickness(std::move(one_by_one), System::kWarp, thread, 1.5f);
    one_by_one = with_thread_spacing(std::move(one_by_one), System::kWarp, thread, 2);
    one_by_one = with_thread_color(std::move(one_by_one), System::kWarp, thread, 1);
  }
  Design at_once = with_thread_thickness(d, System::kWarp, threads, 1.5f);
  at_once =
      with_thread_color(with_thread_spacing(std::move(at_once), System::kWarp, threads, 2), System::kWarp, threads, 1);
  EXPECT_EQ(at_once, one_by_one);
  EXPECT_EQ(at_once.draft.warp.thickness_mm, (std::vector<float>{1.5f, kFromYarn, kFromYarn, 1.5f}));
  EXPECT_EQ(with_thread_thickness(at_once, System::kWarp, threads, kFromYarn).draft.warp.thickness_mm,
            d.draft.warp.thickness_mm);
  EXPECT_EQ(with_thread_yarn(d, System::kWarp, threads, 7), d) << "there is no such yarn";
}

TEST(Edits, OutOfRangeChangesNothing) {
  const Design d = straight_twill(4, 4);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const int bad : {-1, 4, 1 << 30}) {
    EXPECT_EQ(with_threading(d, bad, 0, true), d);
    EXPECT_EQ(with_threading(d, 0, bad, true), d);
    EXPECT_EQ(with_tieup(d, bad, 0, true), d);
    EXPECT_EQ(with_tieup(d, 0, bad, true), d);
    EXPECT_EQ(with_treadling(d, bad, 0, true), d);
    EXPECT_EQ(with_treadling(d, 0, bad, true), d);
    EXPECT_EQ(with_liftplan(d, bad, 0, true), d);
    EXPECT_EQ(with_liftplan(d, 0, bad, true), d);
    EXPECT_EQ(with_drawdown_cell(d, bad, 0, true), d);
    EXPECT_EQ(with_drawdown_cell(d, 0, bad, true), d);
    EXPECT_EQ(with_thread_color(d, System::kWarp, bad, 0), d);
    EXPECT_EQ(with_thread_color(d, System::kWeft, 0, bad), d);
    EXPECT_EQ(with_thread_yarn(d, System::kWeft, bad, 0), d);
    EXPECT_EQ(with_thread_yarn(d, System::kWeft, 0, bad), d);
    EXPECT_EQ(with_thread_thickness(d, System::kWarp, bad, 1), d);
    EXPECT_EQ(with_thread_spacing(d, System::kWarp, bad, 1), d);
    EXPECT_EQ(with_palette_color(d, bad, Rgb{}), d);
    EXPECT_EQ(with_yarn(d, bad, Yarn{}), d);
  }
  EXPECT_EQ(with_thread_thickness(d, System::kWarp, 0, nan), d);
  EXPECT_EQ(with_thread_spacing(d, System::kWarp, 0, -2), d);
  EXPECT_EQ(with_palette_color(d, 0, Rgb{nan, 0, 0}), d);
  EXPECT_EQ(with_size(d, kMaxThreads, kMaxThreads, 4, 4), d);
}

TEST(Edits, LiftplanPaintKeepsTheRestOfTheCloth) {
  const Design next = with_liftplan(straight_twill(4, 4), 2, 0, true);
  EXPECT_EQ(next.draft.shed_control, ShedControl::kLiftplan);
  EXPECT_EQ(cloth(next), (Rows{"1100", "0110", "1011", "1001"}));
}

TEST(Edits, DrawdownPaintMovesEveryEndOfTheShaft) {
  Design d;
  d.draft = treadled({"10", "01", "10", "00"}, {"10", "01"}, {"10", "01"});
  const Design up = with_drawdown_cell(d, 0, 1, true);
  EXPECT_EQ(cloth(up), (Rows{"1010", "1110"}));
  EXPECT_EQ(cloth(with_drawdown_cell(up, 2, 1, false)), cloth(d));
  EXPECT_EQ(with_drawdown_cell(d, 0, 0, true), d) << "already up";
  EXPECT_EQ(with_drawdown_cell(d, 3, 0, true), d) << "an end on no shaft cannot be lifted";
}

TEST(Edits, DrawdownPaintWorksForEveryShed) {
  std::mt19937 random(17);
  for (int round = 0; round < 300; ++round) {
    Design d;
    d.draft = random_draft(random, 12, 9, 5, 4);
    const int end = static_cast<int>(random() % 12), pick = static_cast<int>(random() % 9);
    const bool up = random() % 2 == 0;
    const Design next = with_drawdown_cell(d, end, pick, up);
    ASSERT_TRUE(is_consistent(next));
    if (d.draft.threading.first(end) < 0) continue;
    const BitMatrix was = drawdown(d.draft), is = drawdown(next.draft);
    ASSERT_EQ(is.get(pick, end), up);
    for (int p = 0; p < 9; ++p) {
      if (p == pick) continue;
      ASSERT_TRUE(std::equal(was.row(p).begin(), was.row(p).end(), is.row(p).begin()));
    }
  }
}

TEST(Edits, SizeKeepsTheClothAndContinuesTheStripes) {
  Design d = straight_twill(4, 4);
  d.draft.palette.push_back({1, 0, 0});
  d.draft.warp.color = {0, 2, 0, 2};
  const Design more = with_size(d, 7, 6, 5, 5);
  ASSERT_TRUE(is_consistent(more));
  EXPECT_EQ(more.draft.warp.color, (std::vector<int>{0, 2, 0, 2, 0, 2, 0}));
  EXPECT_EQ(more.draft.weft.color, (std::vector<int>(6, 1)));
  EXPECT_EQ(cloth(more), (Rows{"1100000", "0110000", "0011000", "1001000", "0000000", "0000000"}));
  EXPECT_EQ(cloth(with_size(more, 4, 4, 4, 4)), cloth(d));
  const Design least = with_size(d, -5, 0, 0, 0);
  ASSERT_TRUE(is_consistent(least));
  EXPECT_EQ(cloth(least), (Rows{"1"}));
}

TEST(Edits, ASizeTellsWhatItLoses) {
  Draft d = straight_twill(12, 6).draft;  // four shafts, four treadles, two of them on each
  EXPECT_EQ(lost_by_size(d, 12, 6, 4, 4), SizeLoss{});
  EXPECT_EQ(lost_by_size(d, 20, 9, 8, 8), SizeLoss{});
  EXPECT_EQ(lost_by_size(d, 12, 6, 3, 4), (SizeLoss{3, 0, 2}));
  EXPECT_EQ(lost_by_size(d, 12, 6, 4, 2), (SizeLoss{0, 2, 4})) << "picks 3 and 4";
  EXPECT_EQ(lost_by_size(d, 3, 2, 3, 2), (SizeLoss{0, 0, 4})) << "threads that are cut off are not lost";
  d = to_liftplan(straight_twill(12, 6)).draft;
  EXPECT_EQ(lost_by_size(d, 12, 6, 3, 1), (SizeLoss{3, 2, 0})) << "treadles do nothing here";
}

TEST(Edits, SizeOfAnEmptyDesign) {
  const Design d = with_size(Design{}, 3, 2, 2, 2);
  EXPECT_TRUE(is_consistent(d));
  EXPECT_EQ(d.draft.weft.color, (std::vector<int>{1, 1}));
}

TEST(Edits, YarnsStayInTheirRanges) {
  Yarn wild;
  wild.diameter_mm = 1e9f;
  wild.plies = -4;
  wild.lobes.ior = std::numeric_limits<float>::quiet_NaN();
  wild.lobes.along_width = -std::numeric_limits<float>::infinity();
  const Yarn yarn = with_yarn(Design{}, 0, wild).yarns[0];
  EXPECT_EQ(yarn.diameter_mm, 50);
  EXPECT_EQ(yarn.plies, 1);
  EXPECT_EQ(yarn.lobes.ior, Lobes{}.ior);
  EXPECT_EQ(yarn.lobes.along_width, 0);
  EXPECT_EQ(clamped(Yarn{}), Yarn{});
}

TEST(ShedControl, EitherWayKeepsTheDrawdown) {
  std::mt19937 random(23);
  for (int round = 0; round < 200; ++round) {
    Design d;
    d.draft = random_draft(random, 30, 40, 6, 7);
    const BitMatrix cells = drawdown(d.draft);
    const Design lifted = to_liftplan(d), by_treadles = to_treadling(d);
    ASSERT_TRUE(is_consistent(lifted) && is_consistent(by_treadles));
    ASSERT_EQ(drawdown(lifted.draft), cells);
    ASSERT_EQ(drawdown(by_treadles.draft), cells);
    ASSERT_EQ(drawdown(to_treadling(lifted).draft), cells);
    ASSERT_EQ(by_treadles.draft.shed_control, ShedControl::kTreadling);
  }
}

TEST(ShedControl, TreadlesAreTheFewestInOrderOfUse) {
  Design d;
  d.draft = treadled({"100", "010", "001"}, {"000"}, {"0", "0", "0", "0", "0"});
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.liftplan = matrix_of({"011", "100", "000", "011", "100"});
  const Design next = to_treadling(d);
  EXPECT_EQ(text_of(next.draft.tieup), (Rows{"011", "100"}));
  EXPECT_EQ(text_of(next.draft.treadling), (Rows{"10", "01", "00", "10", "01"}));
  EXPECT_EQ(to_treadling(next), next);
}

TEST(Consistency, FindsBrokenInvariants) {
  EXPECT_TRUE(is_consistent(Design{}));
  EXPECT_TRUE(is_consistent(straight_twill(4, 4)));
  Design d = straight_twill(4, 4);
  d.draft.warp.color[0] = 2;
  EXPECT_FALSE(is_consistent(d));
  d = straight_twill(4, 4);
  d.draft.weft.yarn[0] = 1;
  EXPECT_FALSE(is_consistent(d));
  d = straight_twill(4, 4);
  d.draft.liftplan = BitMatrix(1, 1);
  EXPECT_FALSE(is_consistent(d.draft));
  d = straight_twill(4, 4);
  d.draft.weft.spacing_mm.pop_back();
  EXPECT_FALSE(is_consistent(d.draft));
}

}  // namespace
}  // namespace weftlight::design
