// Two drafts in one cloth, against drawdowns put together by hand.

#include "weaves/joined_drafts.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "analysis/weave_layers.h"
#include "design/edits.h"
#include "weaves/weaves.h"

namespace weftlight::weaves {

using analysis::weave_layers;
using design::Design, design::Rows, design::is_consistent, design::text_of, design::with_rising;
using draft::Rgb, draft::drawdown;

namespace {

Rows joined(const Design& a, const Design& b, Joining how) {
  const base::Result<Design> made = joined_drafts(a, b, how);
  EXPECT_TRUE(made) << problem_of(made);
  EXPECT_TRUE(is_consistent(*made));
  return text_of(drawdown(made->draft));
}

// 10 / 01 and 1100 / 0110 / 0011 / 1001.
const Design& tabby() {
  static const Design d = plain({2, 2});
  return d;
}
const Design& serge() {
  static const Design d = twill({2, 2}, Lean::kRight, {4, 4});
  return d;
}

TEST(JoinedDrafts, EndsInTurn) {
  EXPECT_EQ(joined(tabby(), serge(), {JoinBy::kEnds, 1, 1}), (Rows{"11011000", "00110110", "10001101", "01100011"}))
      << "the shorter draft repeats";
  EXPECT_EQ(joined(tabby(), serge(), {JoinBy::kEnds, 1, 2}), (Rows{"111000", "001110", "100011", "010101"}));
}

TEST(JoinedDrafts, PicksInTurn) {
  EXPECT_EQ(joined(serge(), tabby(), {JoinBy::kPicks, 2, 1}), (Rows{"1100", "0110", "1010", "0011", "1001", "0101"}));
}

TEST(JoinedDrafts, LayersLieOnEachOther) {
  const Design a = with_colors(tabby(), {Rgb{1, 0, 0}}, {{0, 1}}, {{0, 1}});
  const base::Result<Design> made = joined_drafts(a, tabby(), {JoinBy::kLayers, 1, 1});
  ASSERT_TRUE(made) << problem_of(made);
  EXPECT_EQ(text_of(drawdown(made->draft)), (Rows{"1000", "1110", "0010", "1011"}));
  EXPECT_EQ(weave_layers(drawdown(made->draft)).size(), 2u);
  EXPECT_EQ(made->draft.palette[static_cast<size_t>(made->draft.warp.color[0])], (Rgb{1, 0, 0}));
  EXPECT_NE(made->draft.palette[static_cast<size_t>(made->draft.warp.color[1])], (Rgb{1, 0, 0}));
  EXPECT_FLOAT_EQ(made->draft.warp.spacing_mm[0], 0.5f * tabby().draft.warp.spacing_mm[0]) << "each keeps its sett";
}

TEST(JoinedDrafts, OfASinkingShedWeaveTheSameCloth) {
  const Design sinking = with_rising(serge(), false);
  const Rows cloth = joined(sinking, tabby(), {JoinBy::kEnds, 1, 1});
  for (size_t p = 0; p < 4; ++p)
    for (size_t e = 0; e < 4; ++e)
      EXPECT_EQ(cloth[p][2 * e] == '1', drawdown(sinking.draft).get(static_cast<int>(p), static_cast<int>(e)));
}

TEST(JoinedDrafts, StayWithinTheLoom) {
  Design known = tabby();
  known.loom.shafts = 4;
  EXPECT_EQ(joined_drafts(known, tabby(), {JoinBy::kLayers, 1, 1})->loom.shafts, 4);
  EXPECT_EQ(problem_of(joined_drafts(known, serge(), {JoinBy::kLayers, 1, 1})),
            "this needs 6 shafts, but the loom has 4");
}

TEST(JoinedDrafts, TooManyThreadsAreRefused) {
  EXPECT_FALSE(joined_drafts(plain({60000, 2}), plain({60000, 2}), {JoinBy::kEnds, 1, 1}));
  EXPECT_FALSE(joined_drafts(tabby(), tabby(), {JoinBy::kLayers, 100000, 100000}));
  EXPECT_FALSE(joined_drafts(tabby(), Design{}, {}));
}

}  // namespace
}  // namespace weftlight::weaves
