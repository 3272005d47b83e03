#include "analysis/difference.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "design/edits.h"

namespace weftlight::analysis {

using design::Design, design::straight_twill, design::to_liftplan, design::with_size, design::with_threading;
using draft::BitMatrix, draft::CellRect;

namespace {

TEST(Compare, EqualDesignsHaveNoDifferences) {
  const Comparison c = compare(straight_twill(4, 4), straight_twill(4, 4));
  EXPECT_TRUE(c.differences.empty());
  EXPECT_TRUE(c.same_cloth);
}

TEST(Compare, ALiftplanOfTheSameClothDiffersInShedControlAlone) {
  const Comparison c = compare(straight_twill(4, 4), to_liftplan(straight_twill(4, 4)));
  ASSERT_EQ(c.differences.size(), 1u);
  EXPECT_EQ(c.differences[0].what, "shed control");
  EXPECT_TRUE(c.same_cloth);
}

TEST(Compare, NamesThreadsAndCrossings) {
  const Design a = straight_twill(4, 4);
  Design b = with_threading(a, 2, 0, true);
  b.draft.palette.push_back({1, 0, 0});
  b.draft.weft.color[1] = 2;
  b.title = "Other";
  const Comparison c = compare(a, b);
  ASSERT_EQ(c.differences.size(), 3u);
  EXPECT_EQ(c.differences[0].what, "title");
  EXPECT_EQ(c.differences[1].what, "threading");
  EXPECT_EQ(c.differences[1].threads, (std::vector<int>{2}));
  EXPECT_EQ(c.differences[2].what, "weft colours");
  EXPECT_EQ(c.differences[2].threads, (std::vector<int>{1}));
  EXPECT_EQ(c.crossings, 4) << "end 3 weaves the opposite of before";
  EXPECT_EQ(c.where, (CellRect{2, 3, 0, 4}));
}

TEST(Compare, SizesThatDiffer) {
  const Design a = straight_twill(4, 4), b = with_size(a, 70, 5, 4, 4);
  const Comparison c = compare(a, b);
  EXPECT_FALSE(c.same_cloth);
  EXPECT_EQ(c.crossings, 0);
  EXPECT_EQ(c.differences[0].what, "ends");
  EXPECT_EQ(c.differences[0].b, "70");
}

TEST(Compare, ListsRangesOfThreads) {
  EXPECT_EQ(thread_list({0, 1, 2, 5, 7, 8}), "1-3, 6, 8, 9");
  EXPECT_EQ(thread_list({}), "");
}

TEST(Compare, DifferingCrossingsInTheCommonPart) {
  BitMatrix x(10, 70), y(8, 80);
  x.set(1, 3, true);
  x.set(2, 68, true);
  y.set(5, 9, true);
  y.set(5, 75, true);  // beyond the other
  x.set(9, 1, true);   // so is this
  const BitMatrix differ = differing_crossings(x, y);
  EXPECT_EQ(differ.rows(), 10);
  EXPECT_EQ(differ.cols(), 70);
  EXPECT_EQ(differ.count(), 3);
  const std::vector<CellRect> places = differing_regions(differ, 10);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0], (CellRect{3, 69, 1, 3}));
  EXPECT_EQ(places[1], (CellRect{9, 10, 5, 6}));
  EXPECT_EQ(differing_regions(differ, 1).size(), 1u);
}

TEST(Compare, AnEndAndAPickThatCrossAreTwoRegions) {
  BitMatrix differ(12, 12);
  for (int i = 0; i < 12; ++i) {
    differ.set(i, 4, true);
    differ.set(7, i, true);
  }
  const std::vector<CellRect> places = differing_regions(differ, 10);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_EQ(places[0], (CellRect{4, 5, 0, 12}));
  EXPECT_EQ(places[1], (CellRect{0, 12, 7, 8}));
}

}  // namespace
}  // namespace weftlight::analysis
