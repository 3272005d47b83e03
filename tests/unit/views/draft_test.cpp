// Layout and images of the grids of a draft, and the search for commands.

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "views/common/cell_image.h"
#include "views/draft/draft_layout.h"
#include "views/draft/drag_scroll.h"
#include "views/shell/action_list.h"

namespace weftlight::views {

using design::Design, design::straight_twill;
using draft::BitMatrix, draft::Draft, draft::Face, draft::blank_draft;
using session::Cell, session::DraftView, session::DrawdownStyle, session::Settings;
using ui::Axis, ui::Style, ui::UiGrid, ui::cell_at, ui::light_colors;

namespace {

TEST(CellImage, ShowsTheThreadOnTopAndTheMeanWhenCellsAreSmall) {
  Design d = straight_twill(6, 5);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix cells(5, 6);
  cells.set(0, 0, true);
  const Axis ends{0, 12, 2, 0, 6, false}, picks{0, 10, 2, 0, 5, false};
  const CellImage image = cell_image(d, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), ends, picks);
  ASSERT_EQ(image.pixels.size(), 120u);
  EXPECT_EQ(image.pixels[0], IM_COL32(0, 0, 0, 255)) << "the warp is black and on top at end 1, pick 1";
  EXPECT_EQ(image.pixels[2], IM_COL32(255, 255, 255, 255));
  const CellImage back = cell_image(d, cells, Face::kBack, DrawdownStyle::kColor, light_colors(), ends, picks);
  EXPECT_EQ(back.pixels[0], IM_COL32(255, 255, 255, 255));

  d.draft = blank_draft(400, 400, 2, 2);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix plain(400, 400);
  for (int pick = 0; pick < 400; ++pick)
    for (int end = pick % 2; end < 400; end += 2) plain.set(pick, end, true);
  const Axis small{0, 100, 0.25f, 0, 400, true};
  const CellImage mean = cell_image(d, plain, Face::kFront, DrawdownStyle::kColor, light_colors(), small, small);
  for (ImU32 pixel : mean.pixels)
    EXPECT_NEAR(static_cast<double>(pixel & 255), 127, 1) << "plain weave is grey when small";
}

TEST(CellImage, ShowsTheColoursAlongAThread) {
  Design d = straight_twill(6, 6);
  d.yarns[0].dye.stretches = {{1, draft::Rgb{1, 0, 0}, false}, {2, draft::Rgb{0, 0, 1}, false}};
  const Axis side{0, 12, 2, 0, 6, false};
  for (const bool warp : {true, false}) {
    BitMatrix cells(6, 6);
    for (int p = 0; p < 6 && warp; ++p)
      for (int e = 0; e < 6; ++e) cells.set(p, e, true);
    const CellImage image = cell_image(d, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), side, side);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x)
        EXPECT_EQ(image.pixels[static_cast<size_t>(y * 12 + x)],
                  (warp ? y : x) / 2 % 3 == 0 ? IM_COL32(255, 0, 0, 255) : IM_COL32(0, 0, 255, 255));
  }
}

TEST(Layout, AFingerHitsTheColourBars) {
  const Design d = straight_twill(6, 5);
  Style style;
  style.finger = 44;
  const DraftLayout l = lay_out_draft(d.draft, {}, {}, style, {0, 0}, {800, 600});
  EXPECT_GE(l.warp_bar.y.high(0) - l.warp_bar.y.low(0), 43);
  EXPECT_GE(l.weft_bar.x.high(0) - l.weft_bar.x.low(0), 43);
}

TEST(Layout, GridsAreWhereTheMapSaysAndAlignWithTheTieUp) {
  const Design d = straight_twill(6, 5);
  DraftView view;
  const Style style;
  const DraftLayout l = lay_out_draft(d.draft, view, {}, style, {0, 0}, {800, 600});
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

TEST(Layout, EveryOrientationIsConsistent) {
  const Design d = straight_twill(6, 5);
  for (const bool right : {false, true})
    for (const bool below : {false, true})
      for (const int how : {0, 1, 2, 3}) {
        const bool tiled = (how & 1) != 0, upwards = (how & 2) != 0;
        Settings settings;
        settings.pick1_bottom = upwards;
        settings.end1_right = right;
        settings.threading_below = below;
        settings.tiled = tiled;
        const DraftLayout l = lay_out_draft(d.draft, {}, settings, Style{}, {0, 0}, {800, 600});
        EXPECT_EQ(l.threading.min().y > l.drawdown.max().y - 1, below);
        EXPECT_EQ(l.warp_bar.min().y > l.threading.max().y - 1, below) << "bar and numbers are outermost";
        EXPECT_EQ(l.warp_labels.min().y > l.warp_bar.max().y - 1, below);
        EXPECT_EQ(l.tieup.y.start, l.threading.y.start);
        EXPECT_LE(std::max(l.warp_labels.max().y, l.drawdown.max().y), 600);
        EXPECT_LE(l.weft_labels.max().x, 800);
        // Shaft 1 is next to the drawdown, end 1 next to the treadling or at the left.
        const UiGrid grid = map_of(l.threading);
        EXPECT_EQ(grid.step_b[1] > 0, below);
        EXPECT_EQ(grid.step_a[0] < 0, right);
        for (const GridPane* pane : {&l.drawdown, &l.lift, &l.weft_bar, &l.weft_labels})
          EXPECT_EQ(map_of(*pane).step_b[1] < 0, upwards) << map_of(*pane).name;
        for (const GridPane* pane : l.panes()) {
          const UiGrid map = map_of(*pane);
          for (int a = 0; a < map.count_a; ++a)
            for (int b = 0; b < map.count_b; ++b) {
              const ImVec2 at{map.origin[0] + static_cast<float>(a) * map.step_a[0],
                              map.origin[1] + static_cast<float>(b) * map.step_b[1]};
              ASSERT_EQ(pane->at(at), (Cell{a, b})) << map.name << " right " << right << " below " << below;
            }
        }
        // The tiled view agrees with the drawdown inside its edges.
        EXPECT_EQ(cell_at(l.tiled_drawdown.x, l.drawdown.x.low(2) + 1), 2);
        EXPECT_EQ(cell_at(l.tiled_drawdown.y, l.drawdown.y.low(3) + 1), 3);
        EXPECT_EQ(l.tiled_drawdown.x.length > l.drawdown.x.length, tiled);
      }
}

TEST(CellImage, RepeatsBeyondTheEdgesIfTiled) {
  Design d = straight_twill(4, 3);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix cells(3, 4);
  cells.set(0, 0, true);
  const Axis ends{0, 24, 2, -4, 4, true}, picks{0, 18, 2, -1, 3, false};
  const CellImage image = cell_image(d, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), ends, picks, true);
  int black = 0;
  for (int y = 0; y < 18; ++y)
    for (int x = 0; x < 24; ++x) {
      const ImU32 pixel = image.pixels[static_cast<size_t>(24 * y + x)];
      black += pixel == IM_COL32(0, 0, 0, 255);
      EXPECT_EQ(pixel, image.pixels[static_cast<size_t>(24 * y + (x + 8) % 24)]);
      EXPECT_EQ(pixel, image.pixels[static_cast<size_t>(24 * ((y + 6) % 18) + x)]);
    }
  EXPECT_EQ(black, 3 * 3 * 4) << "one crossing of twelve, two by two pixels, nine times";
}

TEST(CellImage, Pick1AtTheBottomFlipsTheImage) {
  Design d = straight_twill(4, 6);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  BitMatrix cells(6, 4);
  cells.set(0, 1, true), cells.set(4, 3, true);
  Axis ends{0, 8, 2, 0, 4, true}, picks{0, 12, 2, 0, 6, false};
  const CellImage down = cell_image(d, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), ends, picks);
  picks.reversed = true;
  const CellImage up = cell_image(d, cells, Face::kFront, DrawdownStyle::kColor, light_colors(), ends, picks);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 8; ++x)
      EXPECT_EQ(up.pixels[static_cast<size_t>(8 * y + x)], down.pixels[static_cast<size_t>(8 * (11 - y) + x)]);
}

TEST(DragScroll, GoesTowardsThePointerAndStopsAtTheEnd) {
  Axis axis{100, 200, 10, 30, 100, false};
  EXPECT_EQ(dragged_scroll(axis, 150, 0.1f), 30) << "inside";
  EXPECT_LT(dragged_scroll(axis, 90, 0.1f), 30);
  const float near_by = dragged_scroll(axis, 310, 0.1f), far_off = dragged_scroll(axis, 500, 0.1f);
  EXPECT_GT(near_by, 30);
  EXPECT_GT(far_off, near_by);
  EXPECT_EQ(dragged_scroll(axis, 5000, 100), 80) << "the last thread stays at the edge";
  axis.reversed = true;
  EXPECT_GT(dragged_scroll(axis, 90, 0.1f), 30);
}

TEST(Layout, TenThousandThreadsStayInThePane) {
  const Draft d = blank_draft(10000, 10000, 32, 32);
  for (float pitch : {0.0f, 0.02f, 1.0f, 20.0f}) {
    DraftView view;
    view.pitch = pitch;
    view.scroll_end = 1e9f;
    const DraftLayout l = lay_out_draft(d, view, {}, Style{}, {0, 0}, {640, 800});
    EXPECT_LE(l.weft_bar.max().x, 640);
    EXPECT_LE(l.drawdown.max().y, 800);
    settle(view, l);
    EXPECT_LE(view.scroll_end, 10000);
    EXPECT_TRUE(is_settled(view, lay_out_draft(d, view, {}, Style{}, {0, 0}, {640, 800})));
  }
}

TEST(Layout, ASmallDraftFillsItsPaneWithinBounds) {
  const Style style;
  const Draft d = blank_draft(16, 16, 4, 4);
  DraftView view;
  const float width = fitting_width(d, {}, style, 400, 700, 800);
  const DraftLayout l = lay_out_draft(d, view, {}, style, {0, 0}, {width, 800});
  EXPECT_GE(l.pitch, 24);
  EXPECT_LE(l.pitch, 28);
  EXPECT_EQ(l.pitch, static_cast<float>(static_cast<int>(l.pitch))) << "whole pixels";
  EXPECT_FALSE(l.scroll_ends || l.scroll_picks);
  EXPECT_EQ(fitting_width(blank_draft(1, 1, 1, 1), {}, style, 400, 700, 800), 400);
  EXPECT_EQ(fitting_width(blank_draft(2000, 2000, 8, 8), {}, style, 400, 700, 800), 700);
}

TEST(Commands, TypedWordsAreWholeBeginningsOrInside) {
  EXPECT_EQ(fit_of("Undo: Paint threading", "undo"), Fit::kWord);
  EXPECT_EQ(fit_of("Compare with a draft\xE2\x80\xA6", "DRAFT compare"), Fit::kWord) << "in any order";
  EXPECT_EQ(fit_of("Save as", "sa"), Fit::kBeginning);
  EXPECT_EQ(fit_of("Interface size: 150%", "size: 150"), Fit::kWord);
  EXPECT_EQ(fit_of("Ctrl+Shift+S", "shift+s"), Fit::kWord);
  EXPECT_EQ(fit_of("Houndstooth", "tooth"), Fit::kInside);
  EXPECT_EQ(fit_of("Houndstooth", "undo"), Fit::kNone) << "its letters in their order are no match";
  EXPECT_EQ(fit_of("Save as", "save quit"), Fit::kNone) << "every word";
  EXPECT_EQ(fit_of("\xC3\x85ngra", "\xC3\xA5ngra"), Fit::kWord) << "capitals of any language";
  EXPECT_EQ(fit_of("\xC3\x85ngra", "angra"), Fit::kWord) << "without marks";
  EXPECT_EQ(fit_of("Undo", " "), Fit::kWord);
}

TEST(Commands, TheBestMatchIsFirst) {
  std::vector<ActionItem> items;
  for (const char* label : {"Unsaved work", "Do not save", "Save all", "Save", "Saved views", "Redo"}) {
    items.emplace_back();
    items.back().label = label;
  }
  const auto found = [&items](const char* typed) {
    std::vector<std::string> labels;
    for (const ActionItem* item : found_actions(items, typed)) labels.push_back(item->label);
    return labels;
  };
  EXPECT_EQ(found("save"),
            (std::vector<std::string>{"Save", "Save all", "Do not save", "Saved views", "Unsaved work"}));
  EXPECT_EQ(found("").size(), items.size());
  EXPECT_EQ(found("").front(), "Unsaved work") << "in their order";
}

}  // namespace
}  // namespace weftlight::views
