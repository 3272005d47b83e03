#include "design/history.h"

#include <gtest/gtest.h>

namespace weftlight::design {

using draft::blank_draft;

namespace {

Design called(std::string title) {
  Design d;
  d.title = std::move(title);
  return d;
}

TEST(History, UndoAndRedoWalkTheLabels) {
  History h(called("a"));
  EXPECT_FALSE(h.can_undo());
  EXPECT_EQ(h.undo_label(), "");
  h.commit(called("b"), "to b");
  h.commit(called("c"), "to c");
  EXPECT_EQ(h.undo_label(), "to c");
  h.undo();
  EXPECT_EQ(h.now().title, "b");
  EXPECT_EQ(h.redo_label(), "to c");
  h.undo();
  h.undo();
  EXPECT_EQ(h.now().title, "a");
  h.redo();
  h.redo();
  h.redo();
  EXPECT_EQ(h.now().title, "c");
}

TEST(History, ANewStepDropsTheRedoSteps) {
  History h(called("a"));
  h.commit(called("b"), "to b");
  h.undo();
  h.commit(called("c"), "to c");
  EXPECT_FALSE(h.can_redo());
  h.undo();
  EXPECT_EQ(h.now().title, "a");
}

TEST(History, EqualDesignMakesNoStep) {
  History h(called("a"));
  h.commit(called("b"), "to b");
  h.undo();
  h.commit(called("a"), "nothing");
  EXPECT_FALSE(h.can_undo());
  EXPECT_TRUE(h.can_redo());
}

TEST(History, OneDragIsOneStep) {
  History h(called("a"));
  h.commit(called("b"), "paint", 7);
  h.commit(called("c"), "paint", 7);
  h.commit(called("d"), "paint", 8);
  EXPECT_EQ(h.now().title, "d");
  h.undo();
  EXPECT_EQ(h.now().title, "c");
  h.undo();
  EXPECT_EQ(h.now().title, "a");
  EXPECT_FALSE(h.can_undo());
}

TEST(History, ADragThatRevertsItselfLeavesNoStep) {
  History h(called("a"));
  h.commit(called("b"), "paint", 7);
  h.commit(called("a"), "paint", 7);
  EXPECT_FALSE(h.can_undo());
  EXPECT_TRUE(h.is_saved());
  h.commit(called("c"), "paint", 7);
  h.undo();
  EXPECT_EQ(h.now().title, "a");
}

TEST(History, GoesToAnyStepAndKeepsLaterSteps) {
  History h(called("a"));
  h.commit(called("b"), "to b");
  h.mark_saved();
  h.commit(called("c"), "to c");
  ASSERT_EQ(h.steps(), 3u);
  EXPECT_EQ(h.label(0), "");
  EXPECT_EQ(h.label(2), "to c");
  EXPECT_EQ(h.position(), 2u);
  h.go_to(0);
  EXPECT_EQ(h.now().title, "a");
  EXPECT_EQ(h.redo_label(), "to b");
  EXPECT_EQ(h.steps(), 3u);
  h.go_to(1);
  EXPECT_TRUE(h.is_saved());
  EXPECT_TRUE(h.is_saved(1));
  EXPECT_FALSE(h.is_saved(2));
  h.go_to(99);
  EXPECT_EQ(h.now().title, "c") << "clamped to the last step";
  h.go_to(1);
  h.commit(called("d"), "to d");
  EXPECT_EQ(h.steps(), 3u) << "a new step drops the later ones";
}

TEST(History, SavedMarkIsAPosition) {
  History h(called("a"));
  EXPECT_TRUE(h.is_saved());
  h.commit(called("b"), "to b");
  EXPECT_FALSE(h.is_saved());
  h.mark_saved();
  EXPECT_TRUE(h.is_saved());
  h.undo();
  EXPECT_FALSE(h.is_saved());
  h.redo();
  EXPECT_TRUE(h.is_saved());
  h.undo();
  h.commit(called("c"), "to c");
  EXPECT_FALSE(h.is_saved());
}

TEST(History, SavingWithinADragDoesNotMarkItsEnd) {
  History h(called("a"));
  h.commit(called("b"), "paint", 7);
  h.mark_saved();
  h.commit(called("c"), "paint", 7);
  EXPECT_FALSE(h.is_saved());
}

TEST(History, MarkedUnsavedNoStepIsSaved) {
  History h(called("a"));
  h.commit(called("b"), "to b");
  h.mark_unsaved();
  EXPECT_FALSE(h.is_saved());
  h.undo();
  EXPECT_FALSE(h.is_saved());
  h.mark_saved();
  EXPECT_TRUE(h.is_saved());
}

TEST(History, MemoryIsBoundedByDroppingTheOldest) {
  Design big;
  big.draft = blank_draft(10, 20000, 4096, 10);  // a liftplan of about 10 MB
  History h(big);
  for (int i = 0; i < 40; ++i) {
    big.title = std::to_string(i);
    h.commit(big, "step");  // a difference in more than cells: both designs are kept
  }
  int undone = 0;
  for (; h.can_undo(); ++undone) h.undo();
  EXPECT_GE(undone, 10);
  EXPECT_LE(undone, 26);
  EXPECT_EQ(h.now().title, std::to_string(39 - undone));
  EXPECT_EQ(h.label(0), "");
  while (h.can_redo()) h.redo();
  EXPECT_EQ(h.now().title, "39");
}

/// A draft of a towel, 400 by 600 threads, liftplan and all.
Design towel() {
  Design d;
  d.draft = blank_draft(400, 600, 16, 16);
  return d;
}

/// Strokes as a weaver makes them: cells of all grids, colours and yarns of threads, now and then something else.
void stroke(Design& d, unsigned k) {
  draft::Draft& t = d.draft;
  const int end = static_cast<int>(k * 7919u % static_cast<unsigned>(t.ends())),
            pick = static_cast<int>(k * 104729u % 600u);
  const int shaft = static_cast<int>(k / 5u % 16u);
  const auto paint = [](draft::BitMatrix& grid, int row, int col) { grid.set(row, col, !grid.get(row, col)); };
  switch (k % 6) {
    case 0:
      return paint(t.threading, end, shaft);
    case 1:
      return paint(t.treadling, pick, shaft);
    case 2:
      return paint(t.tieup, pick % 16, shaft);
    case 3:
      t.warp.color[static_cast<size_t>(end)] ^= 1;
      return;
    case 4:
      t.weft.thickness_mm[static_cast<size_t>(pick)] = 0.1f + 0.01f * static_cast<float>(k % 9);
      return;
    default:
      for (int p = pick; p < std::min(pick + 20, 600); ++p) paint(t.liftplan, p, shaft);
  }
}

TEST(History, EveryStrokeComesBack) {
  Design d = towel();
  History h(d);
  std::vector<Design> all{d};
  for (unsigned k = 0; k < 200; ++k) {
    stroke(d, k);
    if (k % 17 == 16) d.title = std::to_string(k);
    if (k % 41 == 40) d.draft.warp.resize(d.draft.ends() - 1), d.draft.threading.resize(d.draft.ends(), 16);
    h.commit(d, "stroke", 1 + k / 3);  // three edits a step
    if (k % 3 == 0) all.push_back(d);
    else all.back() = d;
  }
  ASSERT_EQ(h.steps(), all.size());
  for (const size_t step : {size_t{0}, all.size() - 1, size_t{30}, size_t{31}, size_t{7}, size_t{60}}) {
    h.go_to(step);
    EXPECT_TRUE(h.now() == all[step]) << step;
  }
  h.go_to(all.size() - 1);
  for (size_t step = all.size() - 1; h.can_undo(); h.undo(), --step) EXPECT_TRUE(h.now() == all[step]) << step;
}

// 100,000 strokes at 300 MB would be 3,000 bytes each.
TEST(History, StrokesTakeFewBytes) {
  constexpr unsigned kStrokes = 3000;
  Design d = towel();
  History h(d);
  for (unsigned k = 0; k < kStrokes; ++k) {
    stroke(d, k);
    h.commit(d, "stroke");
  }
  EXPECT_LT(h.kept_bytes(), kStrokes * 600u);
  EXPECT_EQ(h.steps(), kStrokes + 1);
}

TEST(History, AStepOfSeveralEditsHasTheNameOfTheLast) {
  History h(called("a"));
  h.commit(called("b"), "Weave: Twill", 7);
  h.commit(called("c"), "Weave: Tartan", 7);
  EXPECT_EQ(h.steps(), 2u);
  EXPECT_EQ(h.undo_label(), "Weave: Tartan");
}

TEST(History, ThePlaceAtTheLoomIsNoStep) {
  History h(called("a"));
  const auto weave_to = [&h](int pick) {
    Design d = h.now();
    d.loom.next_pick = pick;
    h.commit(d, "weave");
  };
  h.commit(called("b"), "to b");
  h.mark_saved();
  weave_to(3);
  EXPECT_EQ(h.steps(), 2u);
  EXPECT_FALSE(h.is_saved()) << "the file has another place";
  h.undo();
  EXPECT_EQ(h.now().title, "a");
  EXPECT_EQ(h.now().loom.next_pick, 3);
  weave_to(5);
  h.redo();
  EXPECT_EQ(h.now().title, "b");
  EXPECT_EQ(h.now().loom.next_pick, 5);
  EXPECT_FALSE(h.is_saved());
  weave_to(0);
  EXPECT_TRUE(h.is_saved()) << "as the file has it";
  weave_to(7);
  Design moved = called("c");
  h.commit(moved, "to c");
  EXPECT_EQ(h.now().loom.next_pick, 7) << "edits leave the place";
  h.commit(called("d"), "drag", 9);
  weave_to(8);
  h.commit(called("e"), "drag", 9);
  h.undo();
  EXPECT_EQ(h.now().title, "c") << "one drag is one step, though a pick was woven during it";
  EXPECT_EQ(h.now().loom.next_pick, 8);
}

TEST(History, StrokesBetweenPicksTakeFewBytes) {
  Design d;
  d.draft = blank_draft(64, 64, 8, 8);
  History h(d);
  const size_t first = h.kept_bytes();
  for (int k = 0; k < 50; ++k) {
    Design next = h.now();
    next.loom.next_pick = k;
    h.commit(next, "weave");
    next.draft.threading.set(k, 1, true);
    h.commit(next, "paint");
  }
  EXPECT_EQ(h.steps(), 51u);
  EXPECT_LT(h.kept_bytes() - first, 50u * 1000);
  h.go_to(0);
  EXPECT_EQ(h.now().draft, d.draft);
  EXPECT_EQ(h.now().loom.next_pick, 49);
}

}  // namespace
}  // namespace weftlight::design
