#include "session/editing/paint.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "session/editing/orbit.h"

namespace weftlight::session {

using design::Design, design::Yarn, design::straight_twill;
using draft::BitMatrix, draft::drawdown;

namespace {

TEST(Paint, AFastDragSkipsNoThread) {
  const std::vector<Cell> line = line_of_cells({2, 1}, {12, 4});
  ASSERT_EQ(line.size(), 11u);
  EXPECT_EQ(line.front(), (Cell{2, 1}));
  EXPECT_EQ(line.back(), (Cell{12, 4}));
  for (size_t i = 1; i < line.size(); ++i) EXPECT_EQ(line[i].a, line[i - 1].a + 1);
  EXPECT_EQ(line_of_cells({3, 3}, {3, 3}).size(), 1u);
}

TEST(Paint, AStrokeMovesEveryEndToTheShaft) {
  const Design painted = paint_edit(GridId::kThreading, {1, 3}, {4, 3}, true, true).apply(straight_twill(6, 5));
  for (int end = 1; end <= 4; ++end) {
    EXPECT_EQ(painted.draft.threading.first(end), 3);
    EXPECT_FALSE(painted.draft.threading.get(end, 0));
  }
  EXPECT_EQ(painted.draft.threading.first(0), 0);
  EXPECT_EQ(painted.draft.threading.first(5), 1);
}

TEST(Paint, ReadsCellsOfEveryGrid) {
  const Design d = straight_twill(6, 5);
  const BitMatrix cells = drawdown(d.draft);
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kThreading, {5, 1}));
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kTieup, {3, 0}));
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kTreadling, {0, 4}));
  EXPECT_EQ(is_on(d.draft, cells, GridId::kDrawdown, {1, 0}), cells.get(0, 1));
  EXPECT_FALSE(is_on(d.draft, cells, GridId::kThreading, {99, 0})) << "outside is empty, not a crash";
  EXPECT_FALSE(is_on(d.draft, cells, GridId::kNone, {0, 0}));
}

TEST(Paint, DescribesACellInWeaversWords) {
  Design d = straight_twill(6, 5);
  BitMatrix cells = drawdown(d.draft);
  EXPECT_EQ(describe(d, cells, GridId::kThreading, {5, 0}), "End 6 on shaft 2");
  d.draft.threading.set(5, 3, true);
  EXPECT_EQ(describe(d, cells, GridId::kThreading, {5, 0}), "End 6 on shafts 2 and 4");
  d.draft.threading = BitMatrix(6, 4);
  EXPECT_EQ(describe(d, cells, GridId::kThreading, {5, 0}), "End 6 on no shaft");
  EXPECT_EQ(describe(d, cells, GridId::kTreadling, {0, 2}), "Pick 3: treadle 3");
  EXPECT_EQ(describe(d, cells, GridId::kTieup, {0, 1}), "Treadle 1 tied to shaft 2");
  EXPECT_EQ(describe(d, cells, GridId::kThreading, {}), "");
}

TEST(Paint, ColourBarsPaintColourOrYarn) {
  Design d = straight_twill(6, 5);
  d = bar_edit(GridId::kWarpColors, {0, 0}, {2, 0}, BarPaint::kColor, 1).apply(std::move(d));
  EXPECT_EQ(d.draft.warp.color[2], 1);
  EXPECT_EQ(d.draft.warp.color[3], 0);
  d.yarns.push_back(Yarn{});
  d = bar_edit(GridId::kWeftColors, {0, 4}, {0, 3}, BarPaint::kYarn, 1).apply(std::move(d));
  EXPECT_EQ(d.draft.weft.yarn[3], 1);
  EXPECT_EQ(d.draft.weft.yarn[2], 0);
}

TEST(Zoom, EveryZoomStepChangesThePitchAndCanBeReversed) {
  float pitch = 2;
  for (int i = 0; i < 30 && pitch < 48; ++i) {
    const float next = zoomed_pitch(pitch, 1);
    EXPECT_GT(next, pitch);
    EXPECT_LT(zoomed_pitch(next, -1), next);
    pitch = next;
  }
  EXPECT_EQ(zoomed_pitch(48, 5), 48);
  EXPECT_GT(zoomed_pitch(0.02f, -5), 0);
}

TEST(Zoom, SmallerCellsStopWhereTheyCanBeReadOrTheDraftIsSeenWhole) {
  DraftView v;
  v.pitch = 10;
  v.seen_ends = v.seen_picks = 50;
  EXPECT_EQ(smallest_pitch(v, 50, 50), 4) << "a small draft";
  EXPECT_EQ(smallest_pitch(v, 1000, 50), 0.5f) << "500 pixels for 1000 ends";
}

TEST(Orbit, ZoomKeepsThePointUnderThePointer) {
  const Orbit start{0, 0, 1, 0.05f, -0.02f};
  const Orbit near_by = zoomed(start, 4, 0.2f, 0.1f);
  EXPECT_LT(near_by.distance, start.distance);
  // A point of the cloth p (frames from the middle at distance 1) is seen at p / distance + pan.
  const float p = (0.2f - start.pan_x) * start.distance;
  EXPECT_NEAR(p / near_by.distance + near_by.pan_x, 0.2f, 1e-5f);
  const Orbit back = zoomed(near_by, -4, 0.2f, 0.1f);
  EXPECT_NEAR(back.pan_x, start.pan_x, 1e-5f);
  EXPECT_EQ(orbited({}, 0, 1e6f, 1).elevation, 89);
}

}  // namespace
}  // namespace weftlight::session
