#include "design/turned.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "../hand_drafts.h"
#include "base/result.h"
#include "design/edits.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::drawdown, draft::is_consistent;

namespace {

/// Three ends on shafts 1, 2, 1 and four picks; the lifts have no symmetry.
Design small() {
  Design d;
  d.draft = treadled({"10", "01", "10"}, {"10", "11", "00"}, {"100", "010", "001", "100"});
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  d.draft.warp.color = {0, 1, 2};
  d.draft.weft.color = {1, 2, 0, 0};
  d.draft.warp.thickness_mm = {1, 2, 3};
  d.draft.weft.spacing_mm = {1, 2, 3, 4};
  d.yarns.resize(2);
  d.draft.weft.yarn = {0, 1, 1, 0};
  return d;
}

/// The cloth turned clockwise, end 1 at the right and pick 1 at the top: end 1 becomes the last pick. What was warp on
/// top is weft on top.
BitMatrix turned_cloth(const Draft& d) {
  const BitMatrix cells = slow_drawdown(d);
  BitMatrix out(d.ends(), d.picks());
  for (int p = 0; p < d.picks(); ++p)
    for (int e = 0; e < d.ends(); ++e) out.set(d.ends() - 1 - e, p, !cells.get(p, e));
  return out;
}

void fill_open_threads(Draft& d) {
  for (BitMatrix* grid : {&d.threading, &d.treadling, &d.liftplan})
    for (int row = 0; row < grid->rows(); ++row)
      if (grid->first(row) < 0) grid->set(row, row % grid->cols(), true);
  for (int t = 0; t < d.treadles; ++t) d.tieup.set(t, t % d.shafts, true);
}

TEST(Turned, ThreadingAndTreadlingChangePlaces) {
  const Design before = small();
  ASSERT_EQ(text_of(drawdown(before.draft)), (Rows{"101", "111", "000", "101"}));
  const Design d = *turned(before);
  EXPECT_EQ(text_of(d.draft.threading), (Rows{"100", "010", "001", "100"}));
  EXPECT_EQ(text_of(d.draft.treadling), (Rows{"10", "01", "10"}));
  EXPECT_EQ(text_of(d.draft.tieup), (Rows{"001", "101"})) << "transposed, and each mark reversed";
  EXPECT_EQ(text_of(drawdown(d.draft)), (Rows{"0010", "1011", "0010"}));
  EXPECT_TRUE(d.draft.rising);
}

TEST(Turned, TheColoursThatAreSeenAreTheSameTurned) {
  const Design before = small(), after = *turned(before);
  const BitMatrix was = drawdown(before.draft), is = drawdown(after.draft);
  const auto seen = [](const Draft& d, const BitMatrix& cells, int end, int pick) {
    return cells.get(pick, end) ? d.warp.color[static_cast<size_t>(end)] : d.weft.color[static_cast<size_t>(pick)];
  };
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 3; ++e)
      EXPECT_EQ(seen(after.draft, is, p, 2 - e), seen(before.draft, was, e, p)) << "end " << e << " pick " << p;
  EXPECT_EQ(after.draft.weft.thickness_mm, (std::vector<float>{3, 2, 1}));
  EXPECT_EQ(after.draft.warp.spacing_mm, (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(after.draft.warp.yarn, (std::vector<int>{0, 1, 1, 0}));
}

TEST(Turned, TwiceIsUpsideDownAndFourTimesTheSameDraft) {
  for (const bool rising : {true, false}) {
    Design before = small();
    before.draft.rising = rising;
    Design d = *turned(before);
    EXPECT_EQ(drawdown(d.draft), turned_cloth(before.draft));
    d = *turned(d);
    EXPECT_EQ(text_of(d.draft.threading), (Rows{"10", "01", "10"}));
    EXPECT_EQ(text_of(d.draft.tieup), text_of(before.draft.tieup));
    EXPECT_EQ(text_of(d.draft.treadling), (Rows{"100", "001", "010", "100"}));
    EXPECT_EQ(d.draft.warp.color, (std::vector<int>{2, 1, 0}));
    EXPECT_EQ(*turned(*turned(d)), before);
  }
}

TEST(Turned, LiftplansAndSeveralShaftsOrTreadlesGiveTheSameCloth) {
  std::mt19937 random(11);
  for (int i = 0; i < 60; ++i) {
    Design before;
    before.draft = random_draft(random, 9, 13, 5, 6);
    fill_open_threads(before.draft);
    const Design d = *turned(before);
    ASSERT_TRUE(is_consistent(d.draft));
    EXPECT_EQ(d.draft.shed_control, before.draft.shed_control);
    EXPECT_EQ(d.draft.rising, before.draft.rising);
    EXPECT_EQ(drawdown(d.draft), turned_cloth(before.draft)) << "draft " << i;
  }
}

TEST(Turned, WhatHangsOnNothingStays) {
  Design before = small();
  before.draft.threading.set(1, 1, false);
  before.draft.treadling.set(3, 0, false);
  const Design d = *turned(before);
  EXPECT_LT(d.draft.threading.first(3), 0);
  EXPECT_LT(d.draft.treadling.first(1), 0);
  EXPECT_EQ(*turned(*turned(*turned(d))), before);
}

TEST(Turned, TreadlesThatNoPickUsesTakeNoShaftOfTheLoom) {
  Design before = straight_twill(8, 8);
  before.draft.treadles = 6;
  before.draft.tieup.resize(6, 4);
  before.draft.treadling.resize(8, 6);
  before.loom.shafts = 4;
  const Design d = *turned(before);
  EXPECT_EQ(d.draft.shafts, 4);
  EXPECT_EQ(drawdown(d.draft), turned_cloth(before.draft));
}

TEST(Turned, ALoomThatIsTooSmallIsNamedWithWhatHelps) {
  Design d = straight_twill(6, 6);
  d.draft = treadled({"10", "01"}, {"10", "01", "11"}, {"100", "010", "001"});
  d.loom.shafts = 2;
  EXPECT_EQ(problem_of(turned(d)), "this needs 3 shafts, but the loom has 2; enter a larger loom first");
  d.draft = treadled({"100", "010", "001"}, {"100", "011"}, {"10", "01", "10"});
  d.loom = {};
  d.loom.shafts = 3, d.loom.treadles = 2;
  d.draft.tieup = matrix_of({"100", "010"});
  EXPECT_EQ(problem_of(turned(d)),
            "this needs 3 treadles, but the loom has 2; use the liftplan first, or enter a larger loom");
  EXPECT_EQ(drawdown(turned(to_liftplan(d))->draft), turned_cloth(d.draft));
}

TEST(Turned, ThePlanTurnsAndWhatBelongsToTheOldThreadsGoes) {
  Design before = small();
  before.plan.width_mm = 500, before.plan.length_mm = 2000;
  before.plan.warp_take_up = 0.1f, before.plan.weft_take_up = 0.2f;
  before.plan.warp_shrinkage = 0.3f, before.plan.weft_shrinkage = 0.4f;
  before.plan.ends_per_cm = 8, before.plan.picks_per_cm = 6;
  before.plan.reed = {40, false};
  before.weaves = {{"plain", {}, 0, 3, 0, 4}};
  before.loom.next_pick = 3;
  before.loom.shafts = 12;
  const Design d = *turned(before);
  EXPECT_EQ(d.plan.width_mm, 2000);
  EXPECT_EQ(d.plan.length_mm, 500);
  EXPECT_EQ(d.plan.warp_take_up, 0.2f);
  EXPECT_EQ(d.plan.weft_shrinkage, 0.3f);
  EXPECT_EQ(d.plan.ends_per_cm, 6);
  EXPECT_EQ(d.plan.reed, Reed{});
  EXPECT_TRUE(d.weaves.empty());
  EXPECT_EQ(d.loom.next_pick, 0);
  EXPECT_EQ(d.loom.shafts, 12);
}

}  // namespace
}  // namespace weftlight::design
