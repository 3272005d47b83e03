// Tabby between pattern picks, and threads in groups that a weaver counts by.

#include "loom/tabby.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "draft/drawdown.h"
#include "loom/repeats.h"
#include "loom/weaving.h"

namespace weftlight::loom {

using design::treadled;
using draft::BitMatrix, draft::Draft, draft::lifts;

namespace {

Draft four_shafts() {
  return treadled({"1000", "0100", "0010", "0001"}, {"1100", "0110", "0011", "1001", "1010", "0100", "0001"},
                  {"1000000", "0100000", "0010000", "0001000"});
}

TEST(Tabby, OddAndEvenEndsEachHaveAShed) {
  const auto sheds = tabby_sheds(four_shafts());
  ASSERT_TRUE(sheds);
  EXPECT_EQ(sheds->first, (std::vector<int>{0, 2}));
  EXPECT_EQ(sheds->second, (std::vector<int>{1, 3}));
  EXPECT_EQ(treadles_of_shed(four_shafts(), *sheds, false), std::vector<int>{4});
  EXPECT_EQ(treadles_of_shed(four_shafts(), *sheds, true), (std::vector<int>{5, 6})) << "two treadles together";
  Draft sinking = four_shafts();
  sinking.rising = false;
  EXPECT_EQ(treadles_of_shed(sinking, *sheds, true), std::vector<int>{4}) << "what sinks leaves the other up";
}

TEST(Tabby, AShaftWithOddAndEvenEndsHasNone) {
  EXPECT_FALSE(tabby_sheds(treadled({"100", "010", "001", "100", "010", "001"}, {"100"}, {"1"})));
  EXPECT_FALSE(tabby_sheds(treadled({"10"}, {"10"}, {"1"}))) << "nothing is on the second shed";
}

struct Weave {
  Draft draft = four_shafts();
  BitMatrix lifted = lifts(draft);
  WeavingSetup setup(bool between) const { return {draft, lifted, {}, Protocol::kPlain, between}; }
};

TEST(Tabby, ComesBetweenPatternPicksByTurns) {
  const Weave w;
  WeavingState state;
  std::string sent;
  for (int i = 0; i < 5; ++i) {
    const LoomReply reply = reply_to(w.setup(true), state, {LoomReport::kPickWanted});
    state = reply.state;
    sent += reply.send;
  }
  EXPECT_EQ(sent, "C00000003\nC00000005\nC00000006\nC0000000a\nC0000000c\n") << "pattern, tabby a, pattern, tabby b";
  EXPECT_EQ(state.next_pick, 2);
  const WeavingState there = state;
  state.weaving = false;
  for (int i = 0; i < 4; ++i) state = advanced(state, {}, 4, true);
  EXPECT_EQ(state.next_pick, 0) << "back by the same way";
  EXPECT_FALSE(state.at_tabby || state.second_tabby);
  state.weaving = true;
  for (int i = 0; i < 4; ++i) state = advanced(state, {}, 4, true);
  state.waiting = true;
  EXPECT_EQ(state, there);
}

TEST(Tabby, AKeyGivesOneAndReturns) {
  const Weave w;
  WeavingState state = step_by_hand(w.setup(false), {}, true).state;
  LoomReply reply = insert_tabby(w.setup(false), state, true);
  EXPECT_EQ(reply.send, "C00000005\n");
  reply = reply_to(w.setup(false), reply.state, {LoomReport::kPickWanted});
  EXPECT_EQ(reply.send, "C00000003\n") << "the pattern pick that was shown";
  reply = insert_tabby(w.setup(false), reply.state, true);
  EXPECT_EQ(reply.send, "C0000000a\n") << "by turns";
  const WeavingState back = advanced({.next_pick = 0, .weaving = false, .at_tabby = true}, {}, 4);
  EXPECT_EQ(back.next_pick, 0) << "asked for by mistake";
  EXPECT_FALSE(back.at_tabby);
  Weave none;
  none.draft.threading.set(1, 0, true);
  EXPECT_FALSE(insert_tabby(none.setup(false), {}, true).remark.empty());
}

TEST(Repeats, GroupsAreWholeRepeats) {
  const auto straight = groups_by_repeat(std::vector<int>{0, 1, 2, 3, 0, 1, 2, 3, 0, 1});
  ASSERT_EQ(straight.size(), 3u);
  EXPECT_EQ(straight[1], (ThreadGroup{4, 4}));
  EXPECT_EQ(straight[2], (ThreadGroup{8, 2})) << "cut off";
  const auto place = place_in(straight, 9);
  EXPECT_EQ(place.group, 2);
  EXPECT_EQ(place.thread, 1);
  EXPECT_EQ(groups_by_repeat(std::vector<int>(9, 7))[0].count, kMinGroup) << "one shaft over and over, by fours";
  EXPECT_EQ(groups_by_repeat(std::vector<int>{0, 1, 0, 1, 0, 1, 0, 1})[1], (ThreadGroup{4, 4}));
  EXPECT_TRUE(groups_by_repeat({}).empty());
}

TEST(Repeats, TheLastRepeatIsOneGroupHoweverItIsCutOff) {
  const std::vector<int> repeat{0, 1, 0, 1, 0, 1, 0, 1, 2, 3, 2, 3, 2, 3, 2, 3};
  std::vector<int> sequence;
  for (size_t i = 0; i < 3 * repeat.size() + 13; ++i) sequence.push_back(repeat[i % repeat.size()]);
  const auto groups = groups_by_repeat(sequence);
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups[3], (ThreadGroup{48, 13}));
  sequence.insert(sequence.end(), {5, 6, 7, 5, 6, 7});
  EXPECT_EQ(groups_by_repeat(sequence)[3], (ThreadGroup{48, 4})) << "another repeat follows: none is cut off";
}

TEST(Repeats, GroupsCoverEveryThreadOnce) {
  std::vector<int> sequence;
  uint32_t random = 7;
  for (int i = 0; i < 3000; ++i) sequence.push_back(static_cast<int>((random = random * 1664525 + 1013904223) >> 30));
  for (int i = 0; i < 300; ++i) sequence.push_back(i % 24);
  const auto groups = groups_by_repeat(sequence);
  int next = 0;
  for (const ThreadGroup& group : groups) {
    EXPECT_EQ(group.first, next);
    EXPECT_GT(group.count, 0);
    next += group.count;
  }
  EXPECT_EQ(next, static_cast<int>(sequence.size()));
  EXPECT_EQ(place_in(groups, 3299).group, static_cast<int>(groups.size()) - 1);
}

}  // namespace
}  // namespace weftlight::loom
