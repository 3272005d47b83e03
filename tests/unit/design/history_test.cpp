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
    h.commit(big, "step");
  }
  int undone = 0;
  for (; h.can_undo(); ++undone) h.undo();
  EXPECT_GE(undone, 10);
  EXPECT_LE(undone, 26);
  EXPECT_EQ(h.now().title, std::to_string(39 - undone));
}

}  // namespace
}  // namespace weftlight::design
