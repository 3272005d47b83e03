// Crossings painted on the drawdown.

#include "design/crossings.h"

#include <gtest/gtest.h>

#include <random>

#include "../hand_drafts.h"
#include "design/edits.h"
#include "design/loom.h"
#include "design/selection_edits.h"
#include "draft/drawdown.h"

namespace weftlight::design {

using draft::BitGrid, draft::BitMatrix, draft::Selection, draft::ShedControl, draft::Write, draft::blank_draft,
    draft::drawdown, draft::whole_grid;

namespace {

Design liftplan_design(std::mt19937& random, bool rising) {
  Design d;
  d.draft = blank_draft(23, 9, 5, 1);
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.rising = rising;
  for (int e = 0; e < 23; ++e) d.draft.threading.set(e, static_cast<int>(random() % 5), true);
  for (int p = 0; p < 9; ++p)
    for (int s = 0; s < 5; ++s) d.draft.liftplan.set(p, s, random() % 2 == 0);
  return d;
}

TEST(Crossings, ABlockEqualsItsCellsPaintedInOrder) {
  std::mt19937 random(3);
  for (const bool rising : {true, false}) {
    const Design before = liftplan_design(random, rising);
    const Selection s{BitGrid::kDrawdown, 4, 20, 2, 8};
    BitMatrix block(s.rows(), s.columns());
    for (int r = 0; r < block.rows(); ++r)
      for (int c = 0; c < block.cols(); ++c) block.set(r, c, random() % 2 == 0);
    Design one_by_one = before;
    for (int p = s.b0; p < s.b1; ++p)
      for (int e = s.a0; e < s.a1; ++e)
        one_by_one = with_drawdown_cell(std::move(one_by_one), e, p, block.get(p - s.b0, e - s.a0));
    const Design at_once = painted_crossings(before, s, s.a0, s.b0, block, Write::kInside).value_or(before);
    EXPECT_EQ(drawdown(at_once.draft), drawdown(one_by_one.draft)) << rising;
  }
}

/// The block over the whole drawdown.
BitMatrix written(BitMatrix cells, const Selection& s, const BitMatrix& block, Write write) {
  for (int p = s.b0; p < s.b1; ++p)
    for (int e = s.a0; e < s.a1; ++e) {
      const bool on = block.get(p - s.b0, e - s.a0);
      if (write == Write::kInside || on) cells.set(p, e, on && write != Write::kErase);
    }
  return cells;
}

TEST(Crossings, APaintedBlockIsFactoredAsTheWholeDrawdownIs) {
  std::mt19937 random(8);
  for (int round = 0; round < 600; ++round) {
    Design before;
    before.draft = random_draft(random, 40, 30, 6, 7);
    before.loom.leading = Leading::kDrawdown;
    if (random() % 4 == 0) before.loom.shafts = before.loom.treadles = 8;
    const int end = static_cast<int>(random() % 40), pick = static_cast<int>(random() % 30);
    const Selection s = clipped({BitGrid::kDrawdown, end, end + 1 + static_cast<int>(random() % 9), pick,
                                 pick + 1 + static_cast<int>(random() % 9)},
                                before.draft);
    BitMatrix block(s.rows(), s.columns());
    fill_randomly(block, random, 0.4);
    for (const Write write : {Write::kInside, Write::kAdd, Write::kErase}) {
      const base::Result<Design> painted = painted_crossings(before, s, s.a0, s.b0, block, write);
      const BitMatrix cells = drawdown(before.draft), wanted = written(cells, s, block, write);
      if (wanted == cells) {
        ASSERT_EQ(painted->draft, before.draft) << round;
        continue;
      }
      const base::Result<Draft> whole = with_drawdown(before.draft, wanted, loom_size(before));
      ASSERT_EQ(painted.has_value(), whole.has_value()) << round;
      if (!whole) {
        ASSERT_EQ(painted.error().text, whole.error().text) << round;
        continue;
      }
      ASSERT_EQ(painted->draft, *whole) << round;
      ASSERT_EQ(drawdown(painted->draft), wanted) << round;
    }
  }
}

TEST(Crossings, InvertingAllGivesTheOtherFace) {
  std::mt19937 random(4);
  const Design before = liftplan_design(random, true);
  const Design after = with_inverted(before, whole_grid(before.draft, BitGrid::kDrawdown));
  EXPECT_EQ(drawdown(after.draft), inverted(drawdown(before.draft)));
  EXPECT_EQ(with_inverted(after, whole_grid(after.draft, BitGrid::kDrawdown)).draft, before.draft);
}

}  // namespace
}  // namespace weftlight::design
