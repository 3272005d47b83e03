#include "ui/axis.h"

#include <gtest/gtest.h>

namespace weftlight::ui {
namespace {

TEST(Axis, FindsTheCellThatItDraws) {
  for (bool reversed : {false, true})
    for (float pitch : {0.3f, 1.0f, 7.0f, 18.0f})
      for (float scroll : {0.0f, 3.0f, 10.5f}) {
        const Axis a{50, 300, pitch, scroll, 40, reversed};
        for (int i = a.first_visible(); i < a.end_visible(); ++i) {
          const float middle = (a.low(i) + a.high(i)) / 2;
          if (pitch < 1 || middle < a.start || middle >= a.start + a.length) continue;
          EXPECT_EQ(a.at(middle), i) << "pitch " << pitch << " scroll " << scroll << " reversed " << reversed;
        }
      }
}

TEST(Axis, NeighboursMeetWithoutSeamOrOverlap) {
  const Axis a{13, 500, 7.3f, 2.4f, 60, true};
  for (int i = 0; i + 1 < 60; ++i) EXPECT_EQ(a.low(i), a.high(i + 1));
}

TEST(Axis, ReversedHasTheFirstCellAtTheHighEnd) {
  const Axis a{100, 80, 10, 0, 8, true};
  EXPECT_EQ(a.at(179), 0);
  EXPECT_EQ(a.at(100), 7);
  EXPECT_EQ(a.at(180), -1);
  EXPECT_EQ(a.at(99), -1);
}

TEST(Axis, DragsOutsideStayOnTheLastVisibleCell) {
  const Axis a{0, 50, 10, 3, 20, false};
  EXPECT_EQ(a.nearest(-1000), 3);
  EXPECT_EQ(a.nearest(1000), 7);
  EXPECT_EQ((Axis{0, 50, 10, 0, 0, false}).nearest(10), -1);
}

TEST(Axis, AnEmptyGridHasNoVisibleCells) {
  const Axis a{0, 100, 10, 0, 0, false};
  EXPECT_EQ(a.first_visible(), a.end_visible());
  EXPECT_EQ(a.at(5), -1);
}

TEST(Axis, ZoomKeepsTheCellUnderThePointer) {
  for (bool reversed : {false, true}) {
    Axis a{20, 400, 5, 100, 1000, reversed};
    const int before = a.at(233);
    a.scroll = scroll_about(a, 233, 12);
    a.pitch = 12;
    EXPECT_EQ(a.at(233), before);
  }
}

TEST(Axis, ScrollStopsAtBothEnds) {
  const Axis a{0, 100, 10, 0, 30, false};
  EXPECT_EQ(clamp_scroll(a, -5), 0);
  EXPECT_EQ(clamp_scroll(a, 500), 20);
  EXPECT_EQ(clamp_scroll(Axis{0, 100, 10, 0, 4, false}, 3), 0) << "a small draft does not scroll";
}

TEST(Axis, LabelsKeepTheirDistance) {
  EXPECT_EQ(label_step(40, 30), 1);
  EXPECT_EQ(label_step(16, 30), 2);
  EXPECT_EQ(label_step(6, 30), 5);
  EXPECT_EQ(label_step(0.1f, 30), 500);
}

}  // namespace
}  // namespace weftlight::ui
