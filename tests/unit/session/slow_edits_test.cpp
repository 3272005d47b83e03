// What is computed beside the window changes a draft only if it is still the one that it was computed for.

#include "session/slow_edits.h"

#include <memory>
#include <new>
#include <semaphore>

#include "../scratch_fixture.h"
#include "design/edits.h"
#include "session/editing/paint.h"

namespace weftlight::session {

using design::Design, design::Leading;
using draft::blank_draft;

namespace {

/// A straight draw on four shafts that is all the loom has, its drawdown painted.
Design small_loom() {
  Design d;
  d.draft = blank_draft(12, 12, 4, 4);
  for (int i = 0; i < 12; ++i) {
    d.draft.threading.set(i, i % 4, true);
    d.draft.treadling.set(i, i % 4, true);
  }
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < 2; ++k) d.draft.tieup.set(i, (i + k) % 4, true);
  d.loom.leading = Leading::kDrawdown;
  d.loom.shafts = d.loom.treadles = 4;
  return d;
}

Edit titled(const std::string& title) {
  return {"Title", [title](Design d) {
            d.title = title;
            return d;
          }};
}

SlowEdit slow(const std::string& author) {
  return {"Author", "Asking the author",
          [author](Design d, const base::TaskProgress&) {
            d.author = author;
            return d;
          },
          "It is the author already."};
}

class SlowEditsTest : public ScratchTest {
 protected:
  /// What is started now waits until proceed().
  void hold_up() {
    base::Task task;
    task.work = [this](const base::RunningTask&) { gate_.acquire(); };
    task.kind = "gate";
    runner_.start(std::move(task));
  }
  SlowEdits::Outcome proceed() {
    gate_.release();
    runner_.wait();
    runner_.take();
    return edits_.take_outcome();
  }
  const Document& document() { return session_.active().document; }
  std::optional<RejectedEdit>& rejected() { return session_.active().view.rejected_edit; }
  /// Paints more warp floats in pick 3 than the loom can weave.
  void paint_too_much(uint64_t stroke, int last = 4) {
    Edit edit = paint_edit(GridId::kDrawdown, {0, 2}, {last, 2}, true, true);
    EXPECT_FALSE(session_.commit(edit, stroke));
    ASSERT_TRUE(rejected());
  }

  std::binary_semaphore gate_{0};
  base::TaskRunner runner_;
  Session session_{path("recovery"), Document(small_loom())};
  SlowEdits edits_{session_, runner_};
};

TEST_F(SlowEditsTest, AnEditIsOneStepOfUndo) {
  const Design before = document().now();
  session_.commit(titled("a"), 7);
  hold_up();
  edits_.start(slow("Anni"));
  EXPECT_EQ(runner_.shown().size(), 1u);
  EXPECT_EQ(runner_.shown()[0].name, "Asking the author");
  EXPECT_TRUE(runner_.shown()[0].can_stop);
  EXPECT_TRUE(proceed().edited);
  EXPECT_EQ(document().now().author, "Anni");
  session_.undo();
  EXPECT_EQ(document().now().title, "a");
  session_.undo();
  EXPECT_EQ(document().now(), before);
}

TEST_F(SlowEditsTest, WhatWasPaintedMeanwhileWins) {
  hold_up();
  edits_.start(slow("Anni"));
  session_.commit(titled("painted"), 7);
  const Design painted = document().now();
  const SlowEdits::Outcome outcome = proceed();
  EXPECT_FALSE(outcome.edited);
  EXPECT_NE(outcome.said.find("changed meanwhile"), std::string::npos) << outcome.said;
  EXPECT_EQ(document().now(), painted);
}

TEST_F(SlowEditsTest, WhatAgreesWithTheDraftAsItIsNowIsAppliedToIt) {
  SlowEdit edit = slow("Anni");
  edit.onto = [](Design now, const Design& before, const Design& made) -> std::optional<Design> {
    if (now.author != before.author) return std::nullopt;
    now.author = made.author;
    return now;
  };
  hold_up();
  edits_.start(edit);
  session_.commit(titled("painted"), 7);
  EXPECT_TRUE(proceed().edited);
  EXPECT_EQ(document().now().title, "painted");
  EXPECT_EQ(document().now().author, "Anni");
  session_.undo();
  EXPECT_EQ(document().now().author, "");
  EXPECT_EQ(document().now().title, "painted");
  hold_up();
  edits_.start(edit);
  session_.commit({"Author",
                   [](Design d) {
                     d.author = "Gunta";
                     return d;
                   }},
                  8);
  const SlowEdits::Outcome outcome = proceed();
  EXPECT_NE(outcome.said.find("changed meanwhile"), std::string::npos) << outcome.said;
  EXPECT_EQ(document().now().author, "Gunta");
}

TEST_F(SlowEditsTest, AProblemIsSaid) {
  SlowEdit edit = slow("Anni");
  edit.apply = [](Design, const base::TaskProgress&) -> base::Result<Design> {
    return base::failure(base::ErrorKind::kInput, "nobody knows");
  };
  hold_up();
  edits_.start(edit);
  EXPECT_EQ(proceed().said, "Author: nobody knows");
  EXPECT_EQ(document().now().author, "");
}

TEST_F(SlowEditsTest, AnUndoneEditMeanwhileIsNoChange) {
  hold_up();
  edits_.start(slow("Anni"));
  session_.commit(titled("painted"), 7);
  session_.undo();
  EXPECT_TRUE(proceed().edited);
  EXPECT_EQ(document().now().author, "Anni");
}

TEST_F(SlowEditsTest, AnEditBelongsToItsDocument) {
  const uint64_t first = session_.add(Document(small_loom()), Origin::kOwn).id;
  const uint64_t second = session_.add(Document(small_loom()), Origin::kOwn).id;
  session_.show(first);
  hold_up();
  edits_.start(slow("Anni"));
  session_.show(second);
  EXPECT_FALSE(proceed().edited) << "not the one that is shown";
  EXPECT_EQ(document().now().author, "");
  EXPECT_EQ(session_.active().id, second);
  EXPECT_EQ(session_.find(first)->document.now().author, "Anni");
  hold_up();
  edits_.start(slow("Gunta"));
  session_.close(second, [] { return Document(small_loom()); });
  EXPECT_EQ(proceed().said, "") << "it has been closed";
}

TEST_F(SlowEditsTest, CancelledItChangesNothing) {
  hold_up();
  edits_.start(slow("Anni"));
  edits_.cancel(runner_.shown()[0].kind);
  const SlowEdits::Outcome outcome = proceed();
  EXPECT_FALSE(outcome.edited);
  EXPECT_EQ(document().now().author, "");
}

TEST_F(SlowEditsTest, WhatItLacksIsSaid) {
  session_.commit({"Author",
                   [](Design d) {
                     d.author = "Anni";
                     return d;
                   }},
                  0);
  hold_up();
  edits_.start(slow("Anni"));
  EXPECT_EQ(proceed().said, "It is the author already.");
  hold_up();
  SlowEdit large = slow("Gunta");
  large.apply = [](const Design&, const base::TaskProgress&) -> Design { throw std::bad_alloc(); };
  edits_.start(large);
  const std::string said = proceed().said;
  EXPECT_NE(said.find("not enough memory"), std::string::npos) << said;
}

TEST_F(SlowEditsTest, TheClosestWeaveIsFoundOnce) {
  hold_up();
  paint_too_much(7);
  for (int frame = 0; frame < 3; ++frame) edits_.find_closest_weave();
  EXPECT_EQ(runner_.shown().size(), 1u);
  EXPECT_FALSE(rejected()->closest) << "the window did not wait";
  proceed();
  ASSERT_TRUE(rejected() && rejected()->closest);
  edits_.find_closest_weave();
  EXPECT_FALSE(runner_.busy());
}

TEST_F(SlowEditsTest, TheNextGestureHasItsOwnClosestWeave) {
  hold_up();
  paint_too_much(7);
  edits_.find_closest_weave();
  paint_too_much(8, 8);
  const auto requested = rejected()->requested;
  proceed();
  EXPECT_FALSE(rejected()->closest) << "that was of the gesture before";
  edits_.find_closest_weave();
  runner_.wait();
  runner_.take();
  ASSERT_TRUE(rejected()->closest);
  EXPECT_EQ(rejected()->requested, requested);
}

TEST_F(SlowEditsTest, ADismissedSearchEnds) {
  hold_up();
  paint_too_much(7);
  edits_.find_closest_weave();
  rejected().reset();
  edits_.find_closest_weave();
  EXPECT_TRUE(runner_.shown().empty());
  paint_too_much(8);
  edits_.find_closest_weave();
  edits_.cancel(runner_.shown()[0].kind);
  EXPECT_FALSE(rejected()) << "the notice goes with the search";
  proceed();
  EXPECT_FALSE(rejected());
}

}  // namespace
}  // namespace weftlight::session
