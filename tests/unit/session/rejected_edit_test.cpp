// An edit that the loom cannot weave is kept as a whole gesture, and the closest weave is offered.

#include "session/document/rejected_edit.h"

#include <gtest/gtest.h>

#include "../scratch.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "session/editing/paint.h"
#include "session/editing/shapes.h"
#include "session/session.h"

namespace weftlight::session {

using design::Design, design::Leading, design::with_drawdown_cell, design::with_size;
using draft::BitMatrix, draft::blank_draft, draft::drawdown, draft::kMaxShafts;

namespace {

/// A straight draw on four shafts that is all the loom has, its drawdown painted.
Design small_loom(int shafts = 4) {
  Design d;
  d.draft = blank_draft(12, 12, shafts, shafts);
  for (int i = 0; i < 12; ++i) {
    d.draft.threading.set(i, i % shafts, true);
    d.draft.treadling.set(i, i % shafts, true);
  }
  for (int i = 0; i < shafts; ++i)
    for (int k = 0; k < shafts / 2; ++k) d.draft.tieup.set(i, (i + k) % shafts, true);
  d.loom.leading = Leading::kDrawdown;
  d.loom.shafts = d.loom.treadles = shafts;
  return d;
}

class RejectedEditTest : public testing::Test {
 protected:
  const Design& now() const { return session_.active().document.now(); }
  const std::optional<RejectedEdit>& rejected_edit() const { return session_.active().view.rejected_edit; }
  Edit line(Cell from, Cell to, bool on) const { return paint_edit(GridId::kDrawdown, from, to, on, true); }

  Scratch scratch_{"refusal"};
  Session session_{scratch_ / "recovery", Document(small_loom())};
};

TEST_F(RejectedEditTest, AnAcceptedEditIsNotRejected) {
  session_.commit({"Size", [](Design d) { return with_size(std::move(d), 12, 12, 4, 4); }}, 1);
  EXPECT_FALSE(rejected_edit());
  EXPECT_TRUE(session_.commit(paint_edit(GridId::kThreading, {0, 0}, {0, 3}, true, true), 2));
  EXPECT_FALSE(rejected_edit());
}

TEST_F(RejectedEditTest, TheWholeGestureIsRequested) {
  const Design before = now();
  const BitMatrix cells = drawdown(before.draft);
  EXPECT_FALSE(session_.commit(line({0, 2}, {4, 2}, true), 7)) << "the loom has no fifth treadle";
  ASSERT_TRUE(rejected_edit());
  EXPECT_FALSE(session_.commit(line({5, 2}, {8, 2}, true), 7));
  BitMatrix wanted = cells;
  for (int end = 0; end <= 8; ++end) wanted.set(2, end, true);
  EXPECT_EQ(drawdown(rejected_edit()->requested->draft), wanted);
  EXPECT_EQ(now(), before) << "of a stroke that is refused nothing is drawn";
  EXPECT_FALSE(session_.commit(line({0, 3}, {0, 3}, !cells.get(3, 0)), 8)) << "another gesture, another request";
  wanted = cells;
  wanted.set(3, 0, !cells.get(3, 0));
  EXPECT_EQ(drawdown(rejected_edit()->requested->draft), wanted);
}

TEST_F(RejectedEditTest, TheNextEditOrUndoClearsIt) {
  ASSERT_TRUE(session_.commit({"Title",
                               [](Design d) {
                                 d.title = "A";
                                 return d;
                               }},
                              1));
  session_.commit(line({0, 2}, {4, 2}, true), 2);
  ASSERT_TRUE(rejected_edit());
  ASSERT_TRUE(session_.commit({"Title",
                               [](Design d) {
                                 d.title = "B";
                                 return d;
                               }},
                              3));
  EXPECT_FALSE(rejected_edit());
  session_.commit(line({0, 2}, {4, 2}, true), 4);
  ASSERT_TRUE(rejected_edit());
  ASSERT_TRUE(session_.undo());
  EXPECT_FALSE(rejected_edit());
}

TEST_F(RejectedEditTest, ShapesAndFillsAreRejectedAsAWhole) {
  DocumentView view;
  view.drawing.shape = ActiveShape{Tool::kFilledRectangle, GridId::kDrawdown, {0, 0}, {4, 2}, true};
  const MaybeEdit edit = finish_shape(view, now());
  ASSERT_TRUE(edit);
  EXPECT_FALSE(session_.commit(*edit, 3));
  EXPECT_EQ(view.select.notice, "") << "the loom refuses it, not the threading";
  ASSERT_TRUE(rejected_edit());
  const BitMatrix wanted = drawdown(rejected_edit()->requested->draft);
  for (int pick = 0; pick <= 2; ++pick)
    for (int end = 0; end <= 4; ++end) EXPECT_TRUE(wanted.get(pick, end));
}

TEST_F(RejectedEditTest, TheClosestWeaveFitsTheLoomAndCountsWrongCrossings) {
  // A plain weave, which two shafts weave, with three crossings turned over.
  Design requested = now();
  requested.loom.shafts = requested.loom.treadles = kMaxShafts;
  for (int pick = 0; pick < 12; ++pick)
    for (int end = 0; end < 12; ++end) {
      const bool odd = (end == 3 && pick == 6) || (end == 7 && pick == 0) || (end == 8 && pick == 9);
      requested = with_drawdown_cell(requested, end, pick, ((end + pick) % 2 == 0) != odd);
    }
  const auto closest = closest_weave_to(now(), requested);
  ASSERT_TRUE(closest);
  EXPECT_NE(closest->why, "");
  EXPECT_FALSE(closest->is_there);
  EXPECT_LE(closest->design->draft.shafts, 4);
  EXPECT_LE(closest->design->draft.treadles, 4);
  const BitMatrix shown = drawdown(closest->design->draft), wanted = drawdown(requested.draft);
  int64_t wrong = 0;
  for (int pick = 0; pick < 12; ++pick)
    for (int end = 0; end < 12; ++end) {
      EXPECT_EQ(closest->differing.get(pick, end), shown.get(pick, end) != wanted.get(pick, end));
      wrong += shown.get(pick, end) != wanted.get(pick, end);
    }
  EXPECT_EQ(closest->wrong, wrong);
  EXPECT_GT(wrong, 0);
  EXPECT_LE(wrong, 3) << "the plain weave itself is nearer";
  EXPECT_FALSE(closest->places.empty());
}

TEST_F(RejectedEditTest, WithoutACloserWeaveTheDraftStays) {
  session_.commit(line({0, 2}, {0, 2}, !drawdown(now().draft).get(2, 0)), 2);
  ASSERT_TRUE(rejected_edit());
  const auto closest = closest_weave_to(now(), *rejected_edit()->requested);
  ASSERT_TRUE(closest);
  EXPECT_TRUE(closest->is_there);
  EXPECT_EQ(*closest->design, now());
  EXPECT_EQ(closest->wrong, 1);
}

TEST_F(RejectedEditTest, ALargerLoomWeavesTheWholeRequest) {
  session_.commit(line({0, 2}, {4, 2}, true), 2);
  ASSERT_TRUE(rejected_edit());
  const BitMatrix wanted = drawdown(rejected_edit()->requested->draft);
  const Edit edit = larger_loom_edit(*rejected_edit());
  EXPECT_TRUE(session_.commit(edit, 3));
  EXPECT_EQ(drawdown(now().draft), wanted);
  EXPECT_GE(now().loom.shafts, now().draft.shafts);
  EXPECT_GE(now().loom.treadles, now().draft.treadles);
  EXPECT_FALSE(rejected_edit());
}

}  // namespace
}  // namespace weftlight::session
