#include "views/shell/window_layout.h"

#include <gtest/gtest.h>

namespace weftlight::views {

using ui::Style;

namespace {

TEST(WindowLayout, PanesStayInTheWindowAndAreNeverNegative) {
  Style style;
  for (const float width : {1.0f, 2.0f, 30.0f, 300.0f, 640.0f, 900.0f, 1440.0f, 8000.0f})
    for (const float height : {0.0f, 1.0f, 10.0f, 28.0f, 170.0f, 900.0f})
      for (const float split : {0.2f, 0.5f, 0.8f})
        for (const int finger_and_inspector : {0, 1, 2, 3}) {
          const bool inspector = finger_and_inspector % 2 != 0;
          style.finger = finger_and_inspector > 1 ? 44 : 0;
          const WindowLayout l = lay_out_window(style, {3, 30}, {width, height}, split, {.inspector = inspector});
          for (const PaneRect& p : {l.draft, l.splitter, l.cloth, l.inspector, l.status}) {
            EXPECT_GE(p.size.x, 0);
            EXPECT_GE(p.size.y, 0);
            EXPECT_LE(p.at.x + p.size.x, 3 + width + 1);
            EXPECT_LE(p.at.y + p.size.y, 30 + height + 1);
          }
          EXPECT_GE(l.room, 1);
        }
}

TEST(WindowLayout, AHiddenInspectorLeavesItsWidthToTheOthers) {
  const Style style;
  const WindowLayout with = lay_out_window(style, {0, 0}, {900, 600}, 0.5f, {});
  const WindowLayout without = lay_out_window(style, {0, 0}, {900, 600}, 0.5f, {.inspector = false});
  EXPECT_TRUE(with.inspector.shown());
  EXPECT_FALSE(without.inspector.shown());
  EXPECT_EQ(without.room, 900);
}

TEST(WindowLayout, TheInspectorHasThePlaceOfTheClothInANarrowWindow) {
  Style style;
  const WindowLayout narrow = lay_out_window(style, {0, 0}, {500, 600}, 0.5f, {});
  EXPECT_TRUE(narrow.inspector.shown());
  EXPECT_FALSE(narrow.cloth.shown());
  EXPECT_GT(narrow.draft.size.x, 100);
  EXPECT_TRUE(lay_out_window(style, {0, 0}, {500, 600}, 0.5f, {.inspector = false}).cloth.shown());
  EXPECT_FALSE(lay_out_window(style, {0, 0}, {300, 600}, 0.5f, {}).inspector.shown());
  style.scale = 2;  // an interface of double size in the smallest window that is supported
  EXPECT_TRUE(lay_out_window(style, {0, 0}, {900, 600}, 0.5f, {}).inspector.shown());
  EXPECT_TRUE(lay_out_window(style, {0, 0}, {900, 600}, 0.5f, {.inspector = false}).cloth.shown());
}

TEST(WindowLayout, AnUprightTabletHasTheDraftAboveTheCloth) {
  Style style;
  EXPECT_FALSE(lay_out_window(style, {0, 0}, {768, 1024}, 0.5f, {}).stacked) << "a window for a mouse";
  style.finger = 44;
  EXPECT_FALSE(lay_out_window(style, {0, 0}, {1024, 768}, 0.5f, {}).stacked);
  const WindowLayout l = lay_out_window(style, {0, 0}, {768, 1024}, 0.5f, {});
  EXPECT_EQ(l.draft.size.x, 768);
  EXPECT_GE(l.splitter.size.y, 44);
  EXPECT_GE(l.status.size.y, 44);
  EXPECT_EQ(l.cloth.at.y, l.inspector.at.y);
  EXPECT_EQ(l.cloth.at.y, l.splitter.at.y + l.splitter.size.y);
  EXPECT_EQ(l.cloth.size.x + l.inspector.size.x, 768);
  EXPECT_GT(l.cloth.size.x, 400);
  // A phone shows one of them below the draft.
  EXPECT_FALSE(lay_out_window(style, {0, 0}, {400, 800}, 0.5f, {}).cloth.shown());
  EXPECT_TRUE(lay_out_window(style, {0, 0}, {400, 800}, 0.5f, {.inspector = false}).cloth.shown());
  EXPECT_FALSE(lay_out_window(style, {0, 0}, {768, 1024}, 0.5f, {.cloth = false, .inspector = false}).splitter.shown());
}

}  // namespace
}  // namespace weftlight::views
