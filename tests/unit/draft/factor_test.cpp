// Factoring drawdowns and lifts into threading, tie-up and treadling.

#include "draft/factor.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "draft/skeleton.h"
#include "weaves/weaves.h"

namespace weftlight::design {

using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::Face, draft::ClosestDraft, draft::LoomSize,
    draft::Selection, draft::ShedControl, draft::Skeleton, draft::Write, draft::blank_draft, draft::closest_drawdown,
    draft::drawdown, draft::fewest_for, draft::is_consistent, draft::lifts, draft::skeleton_tieup,
    draft::treadles_needed, draft::whole_grid, draft::with_drawdown, draft::within_loom, draft::without_spare;

using design::Design;
using weaves::Lean, weaves::satin, weaves::twill;
namespace {

Draft bare_loom(const BitMatrix& cells, bool rising = true) {
  Draft d = blank_draft(cells.cols(), cells.rows(), 1, 1);
  d.rising = rising;
  return d;
}

Design two_two_twill(int ends, int picks) { return twill({2, 2}, Lean::kRight, {ends, picks}); }

int most_treadles_per_pick(const BitMatrix& treadling) {
  int most = 0;
  for (int p = 0; p < treadling.rows(); ++p) {
    int pressed = 0;
    for (int t = 0; t < treadling.cols(); ++t) pressed += treadling.get(p, t);
    most = std::max(most, pressed);
  }
  return most;
}

TEST(Factor, APlainWeaveTakesTwoShaftsAndTwoTreadles) {
  const BitMatrix cells = matrix_of({"1010", "0101", "1010", "0101"});
  const base::Result<Draft> f = with_drawdown(bare_loom(cells), cells, {2, 2});
  ASSERT_TRUE(f) << problem_of(f);
  EXPECT_EQ(f->shafts, 2);
  EXPECT_EQ(f->treadles, 2);
  EXPECT_EQ(text_of(f->threading), (Rows{"10", "01", "10", "01"}));
  EXPECT_EQ(text_of(f->treadling), (Rows{"10", "01", "10", "01"}));
  EXPECT_EQ(drawdown(*f), cells);
}

TEST(Factor, FewestShaftsAndTreadlesOfAnyDrawdown) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const Draft d = random_draft(random, 25, 20, 5, 4);
    const BitMatrix cells = drawdown(d);
    const LoomSize fewest = fewest_for(cells);
    for (const bool rising : {true, false}) {
      const base::Result<Draft> f = with_drawdown(bare_loom(cells, rising), cells, {});
      ASSERT_TRUE(f);
      ASSERT_EQ(drawdown(*f), cells);
      ASSERT_LE(f->shafts, fewest.shafts) << "ends that are never up need none";
      if (rising) {
        ASSERT_LE(f->treadles, std::max(fewest.treadles, 1));
      }
    }
  }
}

TEST(Factor, ItsOwnDrawdownLeavesADraftUnchanged) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const Draft d = random_draft(random, 18, 16, 6, 5);
    const base::Result<Draft> f = with_drawdown(d, drawdown(d), {6, 5});
    ASSERT_TRUE(f) << problem_of(f);
    ASSERT_EQ(f->threading, d.threading);
    ASSERT_EQ(f->treadling, d.treadling);
    ASSERT_EQ(drawdown(*f), drawdown(d));
  }
}

TEST(Factor, AnyDrawdownIsWovenAndMostNumberingStays) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    Draft d = random_draft(random, 18, 16, 6, 5);
    BitMatrix cells = drawdown(d);
    const int end = static_cast<int>(random() % 18), pick = static_cast<int>(random() % 16);
    cells.set(pick, end, !cells.get(pick, end));
    const base::Result<Draft> f = with_drawdown(d, cells, {});
    ASSERT_TRUE(f);
    Design made;
    made.draft = *f;
    ASSERT_TRUE(is_consistent(made));
    ASSERT_EQ(drawdown(*f), cells);
    for (int e = 0; e < 18; ++e) {
      if (e == end) continue;
      for (int s = 0; s < d.shafts; ++s) ASSERT_EQ(f->threading.get(e, s), d.threading.get(e, s));
    }
  }
}

TEST(Factor, SaysWhatIsMissingAndOffersTheClosestWeave) {
  // Eight ends of an 8-shaft satin and a loom with four.
  const Draft satin8 = satin(8, 3, Face::kBack, {16, 16}).draft;
  const BitMatrix cells = drawdown(satin8);
  const base::Result<Draft> f = with_drawdown(bare_loom(cells), cells, {4, 8});
  EXPECT_EQ(problem_of(f), "this needs 8 shafts, but the loom has 4");
  const ClosestDraft near = closest_drawdown(bare_loom(cells), cells, {4, 8});
  EXPECT_LE(near.draft.shafts, 4);
  EXPECT_LE(near.draft.treadles, 8);
  int64_t wrong = 0;
  const BitMatrix shown = drawdown(near.draft);
  for (int p = 0; p < 16; ++p)
    for (int e = 0; e < 16; ++e) wrong += shown.get(p, e) != cells.get(p, e);
  EXPECT_EQ(near.wrong, wrong);
  EXPECT_EQ(near.wrong, 32)
      << "four distinct columns of two ends each are woven as another one: four crossings per end";
}

TEST(Factor, AShaftThatNoEndNeedsAnyMoreIsGivenToTheNewOnes) {
  const Draft d = treadled({"10", "10", "01", "01"}, {"10", "01"}, {"10", "01", "10", "01"});
  // The ends of the second shaft join those of the first; one of the first leaves it.
  const BitMatrix cells = matrix_of({"1111", "0100", "1011", "0000"});
  const base::Result<Draft> made = with_drawdown(d, cells, {2, 8});
  ASSERT_TRUE(made) << problem_of(made);
  EXPECT_EQ(drawdown(*made), cells);
  EXPECT_EQ(text_of(made->threading), (Rows{"10", "01", "10", "10"}));
}

TEST(Factor, ADraftMovesToASmallerLoomIfItsClothAllows) {
  // A point threading on eight shafts, of which only four weave differently.
  Draft d = blank_draft(16, 16, 8, 8);
  for (int i = 0; i < 16; ++i) {
    d.threading.set(i, i % 8, true);
    d.treadling.set(i, i % 8, true);
  }
  for (int t = 0; t < 8; ++t)
    for (int s = 0; s < 8; ++s) d.tieup.set(t, s, (t + s) % 4 < 2);
  EXPECT_EQ(within_loom(d, {8, 8}).value(), d) << "it fits unchanged";
  const base::Result<Draft> small = within_loom(d, {4, 4});
  ASSERT_TRUE(small) << problem_of(small);
  EXPECT_LE(small->shafts, 4);
  EXPECT_LE(small->treadles, 4);
  EXPECT_EQ(drawdown(*small), drawdown(d));
  for (int e = 0; e < 16; ++e) EXPECT_EQ(small->threading.count(e), 1) << "every end keeps a heddle";
  const base::Result<Draft> smaller = within_loom(d, {3, 4});
  EXPECT_EQ(problem_of(smaller), "this needs 4 shafts, but the loom has 3");
}

TEST(Factor, TheClosestWeaveFitsTheLoom) {
  std::mt19937 random(11);
  for (int round = 0; round < 60; ++round) {
    Draft d = random_draft(random, 30, 24, 9, 9);
    BitMatrix cells(24, 30);
    fill_randomly(cells, random, 0.5);
    const ClosestDraft near = closest_drawdown(d, cells, {9, 9});
    ASSERT_LE(near.draft.shafts, 9);
    ASSERT_TRUE(near.draft.shed_control == ShedControl::kLiftplan || near.draft.treadles <= 9);
    Design made;
    made.draft = near.draft;
    ASSERT_TRUE(is_consistent(made));
  }
}

// A former defect: a click in the drawdown turned the tie-up into a liftplan, and going back renumbered all treadles.
TEST(PaintedDrawdown, WholeRowsEqualTheirCellsOneByOne) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    Design d;
    d.draft = random_draft(random, 70, 12, 6, 12);
    for (int e = 0; e < 70; ++e)
      for (int s = d.draft.threading.first(e) + 1; s > 0 && s < d.draft.shafts; ++s) d.draft.threading.set(e, s, false);
    BitMatrix cells(12, 70);
    fill_randomly(cells, random, 0.2);
    const Write write = round % 2 == 0 ? Write::kAdd : Write::kErase;
    const Selection all = whole_grid(d.draft, BitGrid::kDrawdown);
    const Design at_once = painted_crossings(d, all, 0, 0, cells, write).value_or(d);
    // A wider block does not take the path for whole rows.
    BitMatrix wide = cells;
    wide.resize(12, 71);
    EXPECT_EQ(at_once, painted_crossings(d, all, 0, 0, wide, write).value_or(d));
  }
}

TEST(PaintedDrawdown, KeepsTheTieUp) {
  const Design d = two_two_twill(16, 16);
  const Design next = with_drawdown_cell(d, 2, 5, !drawdown(d.draft).get(5, 2));
  EXPECT_EQ(next.draft.shed_control, ShedControl::kTreadling);
  EXPECT_EQ(next.draft.treadles, 5) << "one more treadle for that pick";
  for (int t = 0; t < 4; ++t) EXPECT_EQ(text_of(next.draft.tieup)[t], text_of(d.draft.tieup)[t]);
  for (int p = 0; p < 16; ++p) EXPECT_EQ(next.draft.treadling.first(p), p == 5 ? 4 : p % 4);
  const Design back = with_drawdown_cell(next, 2, 5, drawdown(d.draft).get(5, 2));
  EXPECT_EQ(drawdown(back.draft), drawdown(d.draft));
  EXPECT_EQ(back.draft.treadling.first(5), 1) << "the pick is on its treadle again";
  EXPECT_EQ(text_of(back.draft.tieup)[4], "0000") << "and the new one free for the next";
}

TEST(PaintedDrawdown, ATreadleOfASinglePickIsTiedAnew) {
  const Design d = two_two_twill(4, 4);
  const Design next = with_drawdown_cell(d, 0, 0, false);
  EXPECT_EQ(next.draft.treadles, 4);
  EXPECT_EQ(text_of(next.draft.treadling), text_of(d.draft.treadling));
  EXPECT_NE(text_of(next.draft.tieup)[0], text_of(d.draft.tieup)[0]);
}

TEST(PaintedDrawdown, SaysWhyTheLoomCannot) {
  Design d = two_two_twill(16, 16);
  d.loom.shafts = d.loom.treadles = 4;
  const bool up = !drawdown(d.draft).get(5, 2);
  EXPECT_EQ(with_drawdown_cell(d, 2, 5, up), d);
  EXPECT_EQ(problem_of(painted_cell(d, 2, 5, up)), "this needs 5 treadles, but the loom has 4");
}

TEST(PaintedDrawdown, LeadingDrawdownChangesOneCrossingAlone) {
  const Design d = with_leading(two_two_twill(16, 16), Leading::kDrawdown);
  BitMatrix cells = drawdown(d.draft);
  cells.set(5, 2, !cells.get(5, 2));
  const Design next = with_drawdown_cell(d, 2, 5, cells.get(5, 2));
  EXPECT_EQ(drawdown(next.draft), cells);
  EXPECT_EQ(next.draft.shafts, 5);
  EXPECT_EQ(next.draft.shed_control, ShedControl::kTreadling);
  for (int e = 0; e < 16; ++e) EXPECT_EQ(next.draft.threading.first(e), e == 2 ? 4 : e % 4);
}

TEST(PaintedDrawdown, ALockProtectsGridsThatFollow) {
  const Design d = with_lock(two_two_twill(8, 8), true);
  EXPECT_EQ(with_drawdown_cell(d, 0, 0, false), d);
  EXPECT_EQ(problem_of(painted_cell(d, 0, 0, false)), "The drawdown follows and is locked.");
  EXPECT_NE(with_tieup(d, 0, 3, true), d);
  const Design free = with_lock(with_leading(two_two_twill(8, 8), Leading::kDrawdown), true);
  EXPECT_EQ(with_threading(free, 0, 3, true), free);
  EXPECT_EQ(with_tieup(free, 0, 3, true), free);
  EXPECT_NE(with_drawdown_cell(free, 0, 0, false), free);
  const Design plan = with_lock(with_leading(two_two_twill(8, 8), Leading::kLiftplan), true);
  EXPECT_EQ(with_drawdown_cell(plan, 0, 0, false), plan);
  EXPECT_NE(with_liftplan(plan, 0, 3, true), plan);
}

TEST(PaintedDrawdown, OfAnyDraftShowsThePaintedCell) {
  std::mt19937 random(19);
  for (int round = 0; round < 400; ++round) {
    Design d;
    d.draft = random_draft(random, 12, 9, 5, 4);
    d.loom.leading = random() % 2 ? Leading::kDrawdown : Leading::kThreading;
    const int end = static_cast<int>(random() % 12), pick = static_cast<int>(random() % 9);
    const bool up = random() % 2 == 0;
    const Design painted = painted_cell(d, end, pick, up).value_or(d);
    ASSERT_TRUE(is_consistent(painted));
    ASSERT_EQ(painted.draft.shed_control, d.draft.shed_control);
    if (d.loom.leading == Leading::kDrawdown) {
      BitMatrix cells = drawdown(d.draft);
      cells.set(pick, end, up);
      ASSERT_EQ(drawdown(painted.draft), cells);
    } else if (d.draft.threading.first(end) >= 0) {
      ASSERT_EQ(drawdown(painted.draft).get(pick, end), up);
    }
  }
}

TEST(WithoutSpare, TakesBackWhatPaintingAddedAndNothingElse) {
  const Design first = two_two_twill(8, 8);
  const int shafts = first.draft.shafts, treadles = first.draft.treadles;
  const bool up = drawdown(first.draft).get(1, 2);
  const Design grown = with_drawdown_cell(first, 2, 1, !up);
  ASSERT_GT(grown.draft.treadles + grown.draft.shafts, treadles + shafts);
  const Draft back = with_drawdown_cell(grown, 2, 1, up).draft;
  EXPECT_EQ(without_spare(back, grown.draft, {shafts, treadles}), first.draft);
  EXPECT_EQ(without_spare(back, grown.draft, {}), back) << "all were given";
  EXPECT_EQ(without_spare(back, back, {shafts, treadles}), back) << "it was out of use before";
  EXPECT_EQ(without_spare(grown.draft, first.draft, {1, 1}), grown.draft) << "all are in use";
}

TEST(WithoutSpare, WhatComesAfterMovesUp) {
  const Draft before = treadled({"100", "010", "001"}, {"100", "010", "001"}, {"100", "010", "001"});
  Draft after = treadled({"100", "001", "001"}, {"100", "000", "001"}, {"100", "001", "001"});
  const Draft less = without_spare(after, before, {1, 1});
  EXPECT_EQ(text_of(less.threading), (Rows{"10", "01", "01"}));
  EXPECT_EQ(text_of(less.tieup), (Rows{"10", "01"}));
  EXPECT_EQ(text_of(less.treadling), (Rows{"10", "01", "01"}));
  EXPECT_EQ(drawdown(less), drawdown(after));
  EXPECT_TRUE(is_consistent(less));
  after.tieup.set(1, 2, true);
  EXPECT_EQ(without_spare(after, before, {1, 1}).treadles, 3) << "a tie is a use";
  EXPECT_EQ(without_spare(after, before, {1, 1}).shafts, 2);
}

TEST(ShedControl, GoingToTheLiftplanAndBackKeepsTheTreadles) {
  Design d = two_two_twill(8, 8);
  // The weaver's numbering: tabby on treadles 1 and 2, the twill on 3 to 6.
  d.draft = treadled({"1000", "0100", "0010", "0001"}, {"1010", "0101", "1100", "0110", "0011", "1001"},
                     {"001000", "000100", "000010", "000001", "001000", "000100"});
  const Draft same = to_treadling(to_liftplan(d)).draft;
  EXPECT_EQ(same.tieup, d.draft.tieup);
  EXPECT_EQ(same.treadling, d.draft.treadling);
  const Design painted = with_liftplan(d, 5, 3, true);
  const Design back = to_treadling(painted);
  EXPECT_EQ(drawdown(back.draft), drawdown(painted.draft));
  EXPECT_EQ(back.draft.treadles, 7);
  for (int t = 0; t < 6; ++t)
    if (t != 3) {
      EXPECT_EQ(text_of(back.draft.tieup)[t], text_of(d.draft.tieup)[t]);
    }
  for (int p = 0; p < 5; ++p) EXPECT_EQ(back.draft.treadling.first(p), d.draft.treadling.first(p));
}

TEST(ShedControl, MoreTreadlesThanAllowedChangesNothing) {
  Design d;
  std::mt19937 random(2);
  d.draft = random_draft(random, 10, 60, 8, 2);
  d.draft.shed_control = ShedControl::kLiftplan;
  EXPECT_GT(treadles_needed(d.draft), 40);
  EXPECT_EQ(to_treadling(d, 40), d);
  EXPECT_EQ(to_treadling(d).draft.treadles, treadles_needed(d.draft));
}

TEST(Skeleton, FourShaftsAndTwoTreadlesPerPick) {
  // All fourteen sheds of four shafts from the four shafts alone would take up to three treadles per pick; with two,
  // six treadles make the six sheds of two shafts and the four of one.
  const BitMatrix lifts = matrix_of({"1000", "0100", "0010", "0001", "1100", "0110", "0011", "1001", "1010", "0101"});
  const Skeleton s = skeleton_tieup(lifts, 2);
  EXPECT_EQ(s.tieup.rows(), 4);
  EXPECT_TRUE(s.fewest);
  EXPECT_EQ(text_of(skeleton_tieup(lifts, 1).tieup), text_of(lifts));
}

TEST(Skeleton, WeavesTheSameWithinTheTreadlesPerPick) {
  std::mt19937 random(29);
  for (int round = 0; round < 60; ++round) {
    Design d;
    d.draft = random_draft(random, 12, 20, 6, 5);
    const int treadles_per_pick = 1 + static_cast<int>(random() % 3);
    const Skeleton s = skeleton_tieup(lifts(d.draft), treadles_per_pick, {}, 500000);
    ASSERT_LE(most_treadles_per_pick(s.treadling), treadles_per_pick);
    ASSERT_LE(s.at_least, s.tieup.rows());
    ASSERT_LE(s.tieup.rows(), treadles_needed(d.draft));
    const Design next = to_skeleton(d, treadles_per_pick);
    ASSERT_TRUE(is_consistent(next));
    ASSERT_EQ(drawdown(next.draft), drawdown(d.draft));
  }
}

/// Counts its reports, and asks to stop at the first one.
struct StopsAtOnce {
  std::stop_source stop;
  int reports = 0;
  base::TaskProgress progress{stop.get_token(), [this](float, const std::string&) {
                                ++reports;
                                stop.request_stop();
                              }};
};

TEST(Skeleton, EndsSoonAfterItIsAskedToStop) {
  std::mt19937 random(37);
  Design d;
  d.draft = random_draft(random, 40, 40, 12, 40);
  d.draft.shed_control = ShedControl::kLiftplan;
  fill_randomly(d.draft.liftplan, random, 0.4);
  int reports = 0;
  const base::TaskProgress counted({}, [&reports](float share, const std::string&) {
    ++reports;
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
  });
  skeleton_tieup(lifts(d.draft), 2, counted);
  ASSERT_GT(reports, 20) << "the search should be long";
  StopsAtOnce stops;
  const Design next = to_skeleton(d, 2, stops.progress);
  EXPECT_EQ(stops.reports, 1);
  EXPECT_TRUE(is_consistent(next));
  EXPECT_EQ(drawdown(next.draft), drawdown(d.draft)) << "what it has found weaves the same";
  const Skeleton never_begun = skeleton_tieup(lifts(d.draft), 2, stops.progress);
  EXPECT_EQ(never_begun.tieup.rows(), treadles_needed(d.draft));
  EXPECT_FALSE(never_begun.fewest);
}

TEST(Factor, TheClosestWeaveEndsSoonAfterItIsAskedToStop) {
  std::mt19937 random(41);
  BitMatrix cells(200, 200);
  fill_randomly(cells, random, 0.5);
  int reports = 0;
  const base::TaskProgress counted({}, [&reports](float, const std::string&) { ++reports; });
  EXPECT_LE(closest_drawdown(bare_loom(cells), cells, {8, 8}, counted).draft.shafts, 8);
  ASSERT_GT(reports, 100) << "the search should be long";
  StopsAtOnce stops;
  const ClosestDraft stopped = closest_drawdown(bare_loom(cells), cells, {8, 8}, stops.progress);
  EXPECT_EQ(stops.reports, 1);
  EXPECT_FALSE(stopped.exact);
  EXPECT_EQ(stopped.draft, bare_loom(cells));
}

TEST(Skeleton, ShaftsBeyondTheFirstSixtyFourCount) {
  // Two lifts that differ on shaft 70 alone, and one of both their treadles.
  BitMatrix lifts(3, 70);
  lifts.set(0, 0, true);
  lifts.set(1, 1, true), lifts.set(1, 69, true);
  for (const int s : {0, 1, 69}) lifts.set(2, s, true);
  const Skeleton s = skeleton_tieup(lifts, 2);
  EXPECT_EQ(s.tieup.rows(), 2);
  for (int pick = 0; pick < 3; ++pick)
    for (int shaft = 0; shaft < 70; ++shaft) {
      bool lifted = false;
      for (int t = 0; t < s.tieup.rows(); ++t) lifted |= s.treadling.get(pick, t) && s.tieup.get(t, shaft);
      EXPECT_EQ(lifted, lifts.get(pick, shaft)) << "pick " << pick << ", shaft " << shaft;
    }
}

TEST(Skeleton, FindsTheTreadlesOfTheLifts) {
  std::mt19937 random(31);
  for (int round = 0; round < 20; ++round) {
    BitMatrix treadles(5, 12);
    fill_randomly(treadles, random, 0.3);
    BitMatrix lifts(10, 12);
    int row = 0;
    for (int a = 0; a < 5; ++a)
      for (int b = a + 1; b < 5; ++b, ++row)
        for (int s = 0; s < 12; ++s) lifts.set(row, s, treadles.get(a, s) || treadles.get(b, s));
    EXPECT_LE(skeleton_tieup(lifts, 2).tieup.rows(), 5);
  }
}

}  // namespace
}  // namespace weftlight::design
