#include "panels/paint.h"

#include <gtest/gtest.h>

#include "panels/action_list.h"
#include "panels/cell_image.h"
#include "panels/draft_layout.h"
#include "panels/preview_panel.h"

namespace weftlight::panels {
namespace {

Design twill() {
  Design d;
  d.draft = blank_draft(6, 5, 4, 4);
  for (int i = 0; i < 6; ++i) d.draft.threading.set(i, i % 4, true);
  for (int i = 0; i < 5; ++i) d.draft.treadling.set(i, i % 4, true);
  for (int i = 0; i < 4; ++i) d.draft.tieup.set(i, i, true), d.draft.tieup.set(i, (i + 1) % 4, true);
  return d;
}

TEST(Paint, AFastDragLeavesOutNoThread) {
  const std::vector<Cell> line = line_of_cells({2, 1}, {12, 4});
  ASSERT_EQ(line.size(), 11u);
  EXPECT_EQ(line.front(), (Cell{2, 1}));
  EXPECT_EQ(line.back(), (Cell{12, 4}));
  for (size_t i = 1; i < line.size(); ++i) EXPECT_EQ(line[i].a, line[i - 1].a + 1);
  EXPECT_EQ(line_of_cells({3, 3}, {3, 3}).size(), 1u);
}

TEST(Paint, AStrokeMovesEveryEndToTheShaft) {
  const Design painted = paint_edit(GridId::kThreading, {1, 3}, {4, 3}, true, true).apply(twill());
  for (int end = 1; end <= 4; ++end) {
    EXPECT_EQ(painted.draft.threading.first(end), 3);
    EXPECT_FALSE(painted.draft.threading.get(end, 0));
  }
  EXPECT_EQ(painted.draft.threading.first(0), 0);
  EXPECT_EQ(painted.draft.threading.first(5), 1);
}

TEST(Paint, CellsOfEveryGridSayWhatTheyAre) {
  const Design d = twill();
  const BitMatrix cells = drawdown(d.draft);
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kThreading, {5, 1}));
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kTieup, {3, 0}));
  EXPECT_TRUE(is_on(d.draft, cells, GridId::kTreadling, {0, 4}));
  EXPECT_EQ(is_on(d.draft, cells, GridId::kDrawdown, {1, 0}), cells.get(0, 1));
  EXPECT_FALSE(is_on(d.draft, cells, GridId::kThreading, {99, 0})) << "outside is empty, not a crash";
  EXPECT_FALSE(is_on(d.draft, cells, GridId::kNone, {0, 0}));
}

TEST(Paint, TheStatusLineSpeaksAsAWeaverDoes) {
  Design d = twill();
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
  Design d = twill();
  d = bar_edit(GridId::kWarpColors, {0, 0}, {2, 0}, BarPaint::kColor, 1).apply(std::move(d));
  EXPECT_EQ(d.draft.warp.color[2], 1);
  EXPECT_EQ(d.draft.warp.color[3], 0);
  d.yarns.push_back(Yarn{});
  d = bar_edit(GridId::kWeftColors, {0, 4}, {0, 3}, BarPaint::kYarn, 1).apply(std::move(d));
  EXPECT_EQ(d.draft.weft.yarn[3], 1);
  EXPECT_EQ(d.draft.weft.yarn[2], 0);
}

TEST(CellImage, ShowsTheThreadOnTopAndTheMeanWhenCellsAreSmall) {
  Design d = twill();
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix cells(5, 6);
  cells.set(0, 0, true);
  const Axis ends{0, 12, 2, 0, 6, false}, picks{0, 10, 2, 0, 5, false};
  const CellImage image = cell_image(d.draft, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), ends, picks);
  ASSERT_EQ(image.pixels.size(), 120u);
  EXPECT_EQ(image.pixels[0], IM_COL32(0, 0, 0, 255)) << "the warp is black and on top at end 1, pick 1";
  EXPECT_EQ(image.pixels[2], IM_COL32(255, 255, 255, 255));
  const CellImage back = cell_image(d.draft, cells, Face::kBack, DrawdownStyle::kColor, light_colors(), ends, picks);
  EXPECT_EQ(back.pixels[0], IM_COL32(255, 255, 255, 255));

  d.draft = blank_draft(400, 400, 2, 2);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix plain(400, 400);
  for (int pick = 0; pick < 400; ++pick)
    for (int end = pick % 2; end < 400; end += 2) plain.set(pick, end, true);
  const Axis small{0, 100, 0.25f, 0, 400, true};
  const CellImage mean = cell_image(d.draft, plain, Face::kFront, DrawdownStyle::kColor, light_colors(), small, small);
  for (ImU32 pixel : mean.pixels)
    EXPECT_NEAR(static_cast<double>(pixel & 255), 127, 1) << "plain weave is grey from afar";
}

TEST(Layout, GridsStandWhereTheMapSaysAndMeetTheTieUp) {
  const Design d = twill();
  Workspace work;
  const Style style;
  const DraftLayout l = lay_out_draft(d.draft, work, style, {0, 0}, {800, 600});
  EXPECT_EQ(l.threading.x.start, l.drawdown.x.start);
  EXPECT_EQ(l.tieup.y.start, l.threading.y.start);
  EXPECT_EQ(l.tieup.x.start, l.lift.x.start);
  EXPECT_EQ(l.weft_bar.y.start, l.drawdown.y.start);
  const UiGrid grid = map_of(l.threading);
  for (int end = 0; end < 6; ++end)
    for (int shaft = 0; shaft < 4; ++shaft) {
      const ImVec2 at{grid.origin[0] + static_cast<float>(end) * grid.step_a[0],
                      grid.origin[1] + static_cast<float>(shaft) * grid.step_b[1]};
      EXPECT_EQ(l.threading.at(at), (Cell{end, shaft}));
    }
}

TEST(Layout, TenThousandThreadsStayInThePane) {
  const Draft d = blank_draft(10000, 10000, 32, 32);
  for (float pitch : {0.0f, 0.02f, 1.0f, 20.0f}) {
    Workspace work;
    work.pitch = pitch;
    work.scroll_end = 1e9f;
    const DraftLayout l = lay_out_draft(d, work, Style{}, {0, 0}, {640, 800});
    EXPECT_LE(l.weft_bar.max().x, 640);
    EXPECT_LE(l.drawdown.max().y, 800);
    EXPECT_LE(work.scroll_end, 10000);
  }
}

TEST(Commands, TypingNarrowsAndTheBestMatchLeads) {
  int score = 0, better = 0;
  EXPECT_TRUE(matches("Save as", "sa", score));
  EXPECT_TRUE(matches("Larger cells", "lc", score));
  EXPECT_FALSE(matches("Save", "xs", score));
  EXPECT_TRUE(matches("Undo", "", score));
  ASSERT_TRUE(matches("Save", "save", better));
  ASSERT_TRUE(matches("Slide a vase", "save", score));
  EXPECT_GT(better, score);
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
}  // namespace weftlight::panels
