// A stroke gives the cells that it passed, whatever it needed on its way.

#include <gtest/gtest.h>

#include <new>
#include <random>
#include <thread>

#include "../hand_drafts.h"
#include "../scarce_memory.h"
#include "../scratch.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "design/selection_edits.h"
#include "session/editing/paint.h"
#include "session/editing/shapes.h"
#include "session/session.h"

namespace weftlight::session {

using design::Design, design::Leading, design::is_consistent, design::painted_crossings, design::random_draft,
    design::text_of, design::with_leading, design::with_moved, design::with_size;
using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::LoomSize, draft::Selection, draft::ShedControl,
    draft::Write, draft::blank_draft, draft::drawdown, draft::lifts, draft::transposed, draft::whole_grid;

namespace {

Design twill(Leading leading, int size = 48) {
  Design d;
  d.draft = blank_draft(size, size, 4, 4);
  for (int i = 0; i < size; ++i) {
    d.draft.threading.set(i, i % 4, true);
    d.draft.treadling.set(i, i % 4, true);
  }
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) d.draft.tieup.set(t, s, (s - t + 4) % 4 < 2);
  return with_leading(std::move(d), leading);
}

/// Where painting has left something that nothing needs, or nothing where something is needed; empty: nowhere.
std::string fault_of(const Draft& d, LoomSize given) {
  const BitMatrix lift = lifts(d), by_shaft = transposed(d.threading), by_treadle = transposed(d.treadling);
  for (int p = 0; d.shed_control == ShedControl::kTreadling && p < d.picks(); ++p)
    if (lift.first(p) >= 0 && d.treadling.first(p) < 0) return "pick " + std::to_string(p + 1) + " has no treadle";
  for (int t = given.treadles; t < d.treadles; ++t)
    if (d.tieup.first(t) < 0 && by_treadle.first(t) < 0) return "treadle " + std::to_string(t + 1) + " is of no use";
  for (int s = given.shafts; s < d.shafts; ++s)
    if (by_shaft.first(s) < 0) return "shaft " + std::to_string(s + 1) + " has no end";
  return {};
}

class StrokeTest : public testing::Test {
 protected:
  void open(Design design) { session_.add(Document(std::move(design)), Origin::kOwn); }
  const Design& now() const { return session_.active().document.now(); }
  DocumentView& view() { return session_.active().view; }
  BitMatrix cells() const { return drawdown(now().draft); }
  void commit(const MaybeEdit& edit) {
    if (edit) session_.commit(*edit, stroke_);
  }
  /// A press on a cell of the drawdown, and the cells that the hand then comes to.
  void paint(const std::vector<Cell>& along) {
    ++stroke_;
    const bool on = !cells().get(along.front().b, along.front().a);
    commit(begin_stroke(view(), now(), GridId::kDrawdown, along.front(), on, true));
    for (const Cell& at : along) commit(go_on_with_stroke(view(), now(), at, true));
    view().drawing.stroke = {};
  }

  Scratch scratch_{"strokes"};
  Session session_{scratch_ / "recovery", Document(twill(Leading::kThreading))};
  uint64_t stroke_ = 0;
};

TEST_F(StrokeTest, AStrokeOverAWholePickLeavesNoSpareTreadle) {
  open(twill(Leading::kThreading));
  paint({{2, 1}, {1, 1}});
  EXPECT_EQ(now().draft.treadles, 4) << "the fifth was for the first of the two crossings";
  EXPECT_LT(now().draft.treadling.first(1), 0) << "all of the row was cleared";
  EXPECT_EQ(fault_of(now().draft, {4, 4}), "");
}

TEST_F(StrokeTest, TwoClicksOnACellChangeNothing) {
  for (const Leading leading : {Leading::kThreading, Leading::kLiftplan, Leading::kDrawdown}) {
    open(twill(leading));
    const Design first = now();
    paint({{2, 1}});
    EXPECT_NE(now(), first);
    paint({{2, 1}});
    EXPECT_EQ(now(), first) << static_cast<int>(leading);
    paint({{39, 39}});
    paint({{30, 5}});
    paint({{39, 39}});
    EXPECT_EQ(fault_of(now().draft, {4, 4}), "") << "what was added first is no longer needed, what came second is";
    paint({{30, 5}});
    EXPECT_EQ(now(), first) << static_cast<int>(leading);
  }
}

TEST_F(StrokeTest, ShaftsAndTreadlesThatTheWeaverAddedStay) {
  open(twill(Leading::kThreading));
  session_.commit({"Size", [](Design d) { return with_size(std::move(d), 48, 48, 4, 6); }}, 0);
  const Design first = now();
  paint({{2, 1}});
  paint({{2, 1}});
  EXPECT_EQ(now(), first);
  session_.undo();
  session_.undo();
  session_.undo();
  EXPECT_EQ(now().draft.treadles, 4);
  session_.redo();
  paint({{2, 1}});
  paint({{2, 1}});
  EXPECT_EQ(now(), first) << "those that redo brought back, too";
}

TEST_F(StrokeTest, AnUndoDuringAStrokeIsNotPaintedOver) {
  open(twill(Leading::kDrawdown));
  const Design first = now();
  ++stroke_;
  commit(begin_stroke(view(), now(), GridId::kDrawdown, {2, 1}, false, true));
  session_.undo();
  ASSERT_EQ(now(), first);
  commit(go_on_with_stroke(view(), now(), {2, 2}, true));
  EXPECT_TRUE(cells().get(1, 2)) << "what was taken back has come again";
}

TEST_F(StrokeTest, AStrokeContinuesOnlyInAnotherCell) {
  open(twill(Leading::kDrawdown));
  EXPECT_TRUE(begin_stroke(view(), now(), GridId::kDrawdown, {2, 1}, false, true));
  EXPECT_FALSE(go_on_with_stroke(view(), now(), {2, 1}, true));
  EXPECT_FALSE(go_on_with_stroke(view(), now(), {}, true));
}

TEST_F(StrokeTest, AStrokeInAnyDraftGivesTheRequestedCells) {
  std::mt19937 random(7);
  const auto roll = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  for (int round = 0; round < 300; ++round) {
    Design design;
    design.draft = random_draft(random, 14, 12, 5, 4);
    design.draft.rising = roll(4) != 0;
    design = with_leading(std::move(design), static_cast<Leading>(roll(3)));
    open(design);
    view().drawing.mirror_ends = roll(4) == 0;
    view().drawing.mirror_picks = roll(4) == 0;
    const LoomSize given{now().draft.shafts, now().draft.treadles};
    for (int strokes = 0; strokes < 3; ++strokes) {
      const Design before = now();
      const Mirror mirror = mirror_of(view().drawing, view().select.selected, before.draft);
      std::vector<Cell> along{{roll(14), roll(12)}};
      for (int steps = roll(6); steps > 0; --steps) along.push_back({roll(14), roll(12)});
      const bool on = !cells().get(along.front().b, along.front().a);
      BitMatrix asked(12, 14);
      for (size_t i = 0; i < along.size(); ++i)
        for (const Cell& at : line_of_cells(along[i == 0 ? 0 : i - 1], along[i]))
          for (const Cell& image : images_of(mirror, GridId::kDrawdown, at)) asked.set(image.b, image.a, true);
      paint(along);
      const auto wanted = painted_crossings(before, whole_grid(before.draft, BitGrid::kDrawdown), 0, 0, asked,
                                            on ? Write::kAdd : Write::kErase);
      ASSERT_EQ(text_of(cells()), text_of(drawdown(wanted.value_or(before).draft))) << round;
      ASSERT_EQ(fault_of(now().draft, given), "") << round;
      ASSERT_TRUE(is_consistent(now())) << round;
      const Design after = now();
      if (after == before) continue;
      session_.undo();
      ASSERT_EQ(now(), before) << "one step of undo";
      session_.redo();
    }
  }
}

TEST_F(StrokeTest, PaintingNeverNeedsAWholeDrawdown) {
  constexpr int kSize = 4000;
  constexpr size_t kDrawdown = size_t{kSize} * kSize / 8;  // bytes
  for (const Leading leading : {Leading::kDrawdown, Leading::kThreading}) {
    open(twill(leading, kSize));
    BitMatrix wanted = cells();
    int end = 100;
    while (wanted.get(3000, end)) ++end;  // a crossing that painting changes
    bool enough = true;
    {
      const Scarce scarce(kDrawdown / 8);
      std::thread window([&] {
        try {
          ++stroke_;
          commit(begin_stroke(view(), now(), GridId::kDrawdown, {end, 3000}, true, true));
          for (int i = 1; i < 20; ++i) commit(go_on_with_stroke(view(), now(), {end + i, 3000 + i}, true));
        } catch (const std::bad_alloc&) {
          enough = false;
        }
      });
      window.join();
    }
    ASSERT_TRUE(enough) << "work on every crossing";
    for (int i = 0; i < 20; ++i) wanted.set(3000 + i, end + i, true);
    if (leading == Leading::kDrawdown) {
      EXPECT_EQ(cells(), wanted);
    }
    EXPECT_EQ(session_.active().document.cells(), cells());
    EXPECT_TRUE(now().draft != twill(leading, kSize).draft);
    view().drawing.stroke = {};
  }
}

TEST_F(StrokeTest, AMirroredShapeLeavesNoSpareShaftOrTreadle) {
  std::mt19937 random(8);
  const auto roll = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  for (int round = 0; round < 200; ++round) {
    Design design;
    design.draft = random_draft(random, 14, 12, 5, 4);
    open(with_leading(std::move(design), static_cast<Leading>(roll(3))));
    const LoomSize given = view().drawing.given;
    view().drawing.mirror_ends = view().drawing.mirror_picks = true;
    constexpr Tool kTools[] = {Tool::kLine, Tool::kRectangle, Tool::kFilledRectangle};
    view().drawing.shape =
        ActiveShape{kTools[roll(3)], GridId::kDrawdown, {roll(14), roll(12)}, {roll(14), roll(12)}, roll(2) == 0};
    ++stroke_;
    commit(finish_shape(view(), now()));
    ASSERT_EQ(fault_of(now().draft, given), "") << round;
  }
}

TEST_F(StrokeTest, AMovedBlockLeavesNoSpareShaftOrTreadle) {
  std::mt19937 random(9);
  const auto roll = [&random](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  for (int round = 0; round < 300; ++round) {
    Design design;
    design.draft = random_draft(random, 14, 12, 5, 4);
    open(with_leading(std::move(design), static_cast<Leading>(roll(3))));
    const LoomSize given = view().drawing.given;
    const int a = roll(10), b = roll(8);
    const Selection s{BitGrid::kDrawdown, a, a + 1 + roll(4), b, b + 1 + roll(4)};
    ASSERT_EQ(fault_of(with_moved(now(), s, roll(10), roll(8)).draft, given), "") << round;
  }
}

}  // namespace
}  // namespace weftlight::session
