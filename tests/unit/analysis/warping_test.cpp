// Order of the warp, heddles, bouts and floating selvedges.

#include "analysis/warping.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "../plain_cloth.h"
#include "analysis/plan_texts.h"

namespace weftlight::analysis {

using design::Design, design::matrix_of;

namespace {

int64_t threads_of(const ThreadOrder& order) {
  int64_t sum = 0;
  for (const ThreadRun& run : order.repeat) sum += order.times * run.threads;
  for (const ThreadRun& run : order.rest) sum += run.threads;
  return sum;
}

TEST(Warping, TheOrderOfColoursIsRunsInARepeat) {
  Design d = plain_cloth(12, 4);
  d.draft.warp.color = {0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1};
  ThreadOrder order = thread_order(d, System::kWarp, 27);
  EXPECT_EQ(order.repeat, (std::vector<ThreadRun>{{0, 0, 4}, {1, 0, 2}}));
  EXPECT_EQ(order.times, 4);
  EXPECT_EQ(order.rest, (std::vector<ThreadRun>{{0, 0, 3}}));
  EXPECT_EQ(threads_of(order), 27);
  order = thread_order(d, System::kWarp, 3);
  EXPECT_EQ(order.times, 1);
  EXPECT_EQ(threads_of(order), 3);
  d.draft.warp.color.assign(12, 1);
  EXPECT_EQ(thread_order(d, System::kWarp, 500).repeat, (std::vector<ThreadRun>{{1, 0, 500}})) << "one colour";
  EXPECT_TRUE(thread_order(d, System::kWarp, 0).repeat.empty());
}

TEST(Warping, HeddlesAreOfThePlannedEnds) {
  const draft::Draft d = design::treadled({"100", "010", "100", "000", "011"}, {"110", "001", "000"}, {"100", "110"});
  const Heddles twice = heddles_for(d, 12);
  EXPECT_EQ(twice.on_shaft, (std::vector<int64_t>{5, 5, 2})) << "two repeats, an end on shaft 1 and one on 2";
  EXPECT_EQ(twice.unthreaded_ends, 2);
  EXPECT_EQ(heddles_for(d, 2).on_shaft, (std::vector<int64_t>{1, 1, 0}));
}

TEST(Warping, BoutsAndRaddleGroupsHoldAllEnds) {
  Design d = plain_cloth(24, 4);
  d.plan = bare_plan();
  d.plan.width_mm = 550;  // 10 ends in a cm
  d.plan.bout_mm = 96;
  const WarpingPlan w = warping_plan(d, cloth_measures(d));
  EXPECT_EQ(w.ends, 550);
  EXPECT_EQ(w.ends_in_bout, 96);
  EXPECT_EQ(w.bouts, 6);
  EXPECT_EQ(w.ends_in_last, 550 - 5 * 96);
  EXPECT_EQ(w.raddle, std::vector<int>{10});
  EXPECT_EQ(w.raddle_groups, 55);
  EXPECT_EQ(w.whole_repeats, 22);
  EXPECT_EQ(w.more_ends, 22);
  EXPECT_EQ(bouts_text(w), "6 bouts of 96 ends, the last of 70");
  EXPECT_EQ(repeats_text(w), "22 repeats of the draft and 22 ends");
  WarpingPlan two = w;
  two.bouts = 2, two.ends_in_bout = 145, two.ends_in_last = 131;
  EXPECT_EQ(bouts_text(two), "2 bouts, of 145 and 131 ends");
  two.ends_in_last = 145;
  EXPECT_EQ(bouts_text(two), "2 bouts of 145 ends");
  d.plan.floating_selvedges = true;
  EXPECT_EQ(warping_plan(d, cloth_measures(d)).ends, 552);
}

TEST(Selvedges, PlainWeaveIsBoundFromEitherSide) {
  const Selvedges s = selvedges(matrix_of({"10", "01"}), 1);
  EXPECT_TRUE(s.any_direction());
  EXPECT_FALSE(s.floating_needed());
}

// Vermont Weaving Supplies, Let's Talk About Selvedges: on a straight twill the edge end is caught at every turn or at
// none, by the direction of the shuttle. M. Petrini, To Float or not to Float: the direction of the first pick decides.
TEST(Selvedges, AStraightTwillIsBoundInOneDirectionOfTheShuttle) {
  const Selvedges s = selvedges(matrix_of({"1100", "0110", "0011", "1001"}), 3);
  EXPECT_FALSE(s.floating_needed());
  EXPECT_FALSE(s.any_direction());
  const Selvedges::Start &good = s.starts[static_cast<size_t>(s.better())],
                         &bad = s.starts[static_cast<size_t>(1 - s.better())];
  EXPECT_EQ(good.missed(), 0);
  EXPECT_TRUE(bad.first.never() && bad.last.never());
}

// With an odd number of ends in the repeat's remainder one edge is caught and the other never is, whatever the
// direction.
TEST(Selvedges, ATwillThatEndsOnAnotherShaftNeedsThem) {
  const Selvedges s = selvedges(matrix_of({"1100", "0110", "0011", "1001"}), 2);
  EXPECT_TRUE(s.floating_needed());
  EXPECT_EQ(selvedges_text(s).substr(0, 7), "Needed:");
}

TEST(Selvedges, AReversedTwillMissesSomeTurns) {
  // Treadled 1 2 3 4 3 2.
  const Selvedges s = selvedges(matrix_of({"1100", "0110", "0011", "1001", "0011", "0110"}), 3);
  EXPECT_TRUE(s.floating_needed());
  for (const Selvedges::Start& start : s.starts)
    for (const EdgeBinding& edge : {start.first, start.last}) {
      EXPECT_EQ(edge.turns, 3);
      EXPECT_EQ(edge.missed == 0, edge.unbound_picks == 0);
    }
}

TEST(Selvedges, AnOddNumberOfPicksTurnsAtBothEdges) {
  const Selvedges s = selvedges(matrix_of({"110", "011", "101"}), 2);
  EXPECT_EQ(s.starts[0].first.turns, 3);
  EXPECT_EQ(s.starts[0].missed(), s.starts[1].missed());
  EXPECT_TRUE(selvedges({}, 0).any_direction()) << "nothing to bind";
}

TEST(Warping, TheLastRaddleGroupHoldsWhatIsLeft) {
  WarpingPlan w;
  w.raddle = {47}, w.raddle_groups = 2, w.ends_in_last_group = 13;
  EXPECT_EQ(raddle_text(w), "2 groups of 47 ends, the last of 13");
  w.ends_in_last_group = 47;
  EXPECT_EQ(raddle_text(w), "2 groups of 47 ends");
  w.raddle_groups = 1, w.ends_in_last_group = 20;
  EXPECT_EQ(raddle_text(w), "one group of 20 ends");
  Design d = plain_cloth(24, 4, 10.0f / 8.65f);
  d.plan = bare_plan();
  d.plan.raddle_mm = 10;
  w = warping_plan(d, cloth_measures(d));
  ASSERT_EQ(w.raddle, (std::vector<int>{8, 9, 9}));
  EXPECT_EQ(w.ends_in_last_group, 7);
  EXPECT_EQ(raddle_text(w), "3 groups of 8-9-7 ends in turn");
  d.plan.width_mm = 520 / 8.65f;  // two such turns
  w = warping_plan(d, cloth_measures(d));
  EXPECT_EQ(w.ends, 52);
  EXPECT_EQ(raddle_text(w), "6 groups of 8-9-9 ends in turn");
}

}  // namespace
}  // namespace weftlight::analysis
