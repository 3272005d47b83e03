#include "design/thread_order.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"

namespace weftlight::design {

using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::System, draft::Threads, draft::blank_draft,
    draft::kMaxThreads, draft::lifts;

namespace {

/// Ends on shafts 1 2 3 4 in colours 0 1 2 3, of different yarn, thickness and spacing; picks likewise.
Design straight() {
  Design design;
  design.yarns.resize(4);
  Draft& d = design.draft;
  d = treadled({"1000", "0100", "0010", "0001"}, {"1100", "0110", "0011", "1001"}, {"1000", "0100", "0010", "0001"});
  d.palette.assign(4, Rgb{});
  for (Threads* t : {&d.warp, &d.weft})
    for (int i = 0; i < 4; ++i) {
      t->color[i] = t->yarn[i] = i;
      t->thickness_mm[i] = t->spacing_mm[i] = static_cast<float>(i);
    }
  return design;
}

Rows threading(const Design& d) { return text_of(d.draft.threading); }
const ThreadRange kMiddle{System::kWarp, 1, 3};

/// Every property of a thread has the same number.
void expect_properties(const Threads& t, const std::vector<int>& properties) {
  EXPECT_EQ(t.color, properties);
  EXPECT_EQ(t.yarn, properties);
  const std::vector<float> lengths(properties.begin(), properties.end());
  EXPECT_EQ(t.thickness_mm, lengths);
  EXPECT_EQ(t.spacing_mm, lengths);
}

TEST(ThreadOrder, BareThreadsCopyThePropertiesOfTheNextThread) {
  const Design d = with_bare_threads(straight(), System::kWarp, 1, 2);
  EXPECT_EQ(threading(d), (Rows{"1000", "0000", "0000", "0100", "0010", "0001"}));
  expect_properties(d.draft.warp, {0, 1, 1, 1, 2, 3});
  const Design stripes_stay = with_bare_threads(straight(), System::kWarp, 1, 2, false);
  EXPECT_EQ(stripes_stay.draft.threading, d.draft.threading);
  expect_properties(stripes_stay.draft.warp, {0, 1, 2, 3, 3, 3});
  EXPECT_EQ(threading(with_bare_threads(straight(), System::kWarp, 4, 1)).back(), "0000");
  EXPECT_TRUE(is_consistent(d));
}

TEST(ThreadOrder, PicksKeepTreadlingAndLiftplanInStep) {
  Design d = straight();
  d.draft.liftplan = lifts(d.draft);
  d = without_threads(std::move(d), {System::kWeft, 0, 2});
  EXPECT_EQ(text_of(d.draft.treadling), (Rows{"0010", "0001"}));
  EXPECT_EQ(d.draft.liftplan, lifts(d.draft));
  expect_properties(d.draft.weft, {2, 3});
}

TEST(ThreadOrder, DeletedThreadsTakeTheirColoursAlong) {
  const Design d = without_threads(straight(), kMiddle);
  EXPECT_EQ(threading(d), (Rows{"1000", "0001"}));
  expect_properties(d.draft.warp, {0, 3});
  expect_properties(without_threads(straight(), kMiddle, false).draft.warp, {0, 1});
  EXPECT_EQ(without_threads(straight(), {System::kWarp, 0, 4}), straight()) << "a draft keeps at least one end";
  EXPECT_EQ(without_threads(straight(), {System::kWarp, 3, 99}).draft.ends(), 3);
}

TEST(ThreadOrder, ReversedThreads) {
  const Design d = with_reversed_threads(straight(), {System::kWarp, 0, 3});
  EXPECT_EQ(threading(d), (Rows{"0010", "0100", "1000", "0001"}));
  expect_properties(d.draft.warp, {2, 1, 0, 3});
}

TEST(ThreadOrder, MirroredCopiesShareTheTurningThread) {
  EXPECT_EQ(threading(with_doubled_threads(straight(), kMiddle, false)),
            (Rows{"1000", "0100", "0010", "0100", "0010", "0001"}));
  const Design point = with_doubled_threads(straight(), {System::kWarp, 0, 4}, true);
  EXPECT_EQ(threading(point), (Rows{"1000", "0100", "0010", "0001", "0010", "0100", "1000"}));
  expect_properties(point.draft.warp, {0, 1, 2, 3, 2, 1, 0});
}

TEST(ThreadOrder, APointRepeatTurnsOnceAtBothEnds) {
  Design d = with_bare_threads(straight(), System::kWarp, 4, 6);
  d = with_point_repeat(std::move(d), {System::kWarp, 0, 4}, RepeatExtent::kToEnd);
  expect_properties(d.draft.warp, {0, 1, 2, 3, 2, 1, 0, 1, 2, 3});
  EXPECT_EQ(d.draft.threading.first(4), 2);
  EXPECT_EQ(d.draft.threading.first(6), 0);
  expect_properties(with_point_repeat(straight(), kMiddle, RepeatExtent::kAll).draft.warp, {2, 1, 2, 1});
  expect_properties(with_point_repeat(straight(), {System::kWarp, 2, 3}, RepeatExtent::kToEnd).draft.warp,
                    {0, 1, 2, 2});
}

TEST(ThreadOrder, AnAdvancingRepeatWrapsRoundTheShafts) {
  Design d = with_bare_threads(straight(), System::kWarp, 4, 5);
  d = with_advancing_repeat(std::move(d), {System::kWarp, 0, 3}, 1);
  std::vector<int> shafts;
  for (int i = 0; i < 9; ++i) shafts.push_back(d.draft.threading.first(i));
  EXPECT_EQ(shafts, (std::vector<int>{0, 1, 2, 1, 2, 3, 2, 3, 0}));
  expect_properties(d.draft.warp, {0, 1, 2, 0, 1, 2, 0, 1, 2});
  const Design back = with_advancing_repeat(straight(), {System::kWarp, 0, 1}, -1);
  EXPECT_EQ(threading(back), (Rows{"1000", "0001", "0010", "0100"}));
}

TEST(ThreadOrder, AdvancingPicksMovesTheActiveShedControl) {
  Design d = straight();
  const BitMatrix plan = d.draft.liftplan;
  const Design treadles = with_advancing_repeat(d, {System::kWeft, 0, 1}, 2);
  EXPECT_EQ(text_of(treadles.draft.treadling), (Rows{"1000", "0010", "1000", "0010"}));
  EXPECT_EQ(treadles.draft.liftplan, plan);
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.liftplan = matrix_of({"1100", "0000", "0000", "0000"});
  EXPECT_EQ(text_of(with_advancing_repeat(d, {System::kWeft, 0, 1}, 1).draft.liftplan),
            (Rows{"1100", "0110", "0011", "1001"}));
}

TEST(ThreadOrder, ImpossibleOrdersChangeNothing) {
  const Design d = straight();
  EXPECT_EQ(with_bare_threads(d, System::kWarp, 0, kMaxThreads), d);
  EXPECT_EQ(with_bare_threads(d, System::kWarp, 0, -1), d);
  EXPECT_EQ(with_bare_threads(d, System::kWarp, 0, 1 << 30), d);
  EXPECT_EQ(with_thread_order(d, System::kWarp, std::vector<ThreadSource>{{4}}, true), d);
  EXPECT_EQ(with_thread_order(d, System::kWarp, {}, true), d);
  for (const ThreadRange& r :
       {ThreadRange{System::kWarp, 2, 2}, ThreadRange{System::kWeft, 7, 9}, ThreadRange{System::kWarp, 3, -1}}) {
    EXPECT_EQ(without_threads(d, r), d);
    EXPECT_EQ(with_doubled_threads(d, r, true), d);
    EXPECT_EQ(with_repeated_threads(d, r, RepeatExtent::kAll), d);
    EXPECT_EQ(with_point_repeat(d, r, RepeatExtent::kAll), d);
    EXPECT_EQ(with_advancing_repeat(d, r, 1), d);
    EXPECT_EQ(with_rotated_threads(d, r, 1), d);
  }
  Design wide;
  wide.draft = blank_draft(30000, 70000, 1, 1);
  EXPECT_EQ(with_doubled_threads(wide, {System::kWarp, 0, 30000}, false), wide)
      << "more crossings than a draft may have";
}

}  // namespace
}  // namespace weftlight::design
