// The drawing tools in the real window: lines, rectangles and fills by mouse and keys, each one step of undo.

#include <gtest/gtest.h>

#include <chrono>
#include <utility>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class DrawingTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    blank_.draft = draft::blank_draft(24, 24, 8, 8);
    blank_.scene.mesh = "plane";
    put(draft_, wif::write_new_wif(blank_));
  }
  static draft::Draft draft_of(const Window& w) { return design_of(w.live()).draft; }
  void undone(const Window& w, const char* what) {
    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return draft_of(w) == blank_.draft; }))
        << what << ": one undo did not restore the draft";
  }

  design::Design blank_;
};

TEST_F(DrawingTest, LinesRectanglesAndFillsAreOneStepEach) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("i");
  display_.drag({w.cell("threading", 1, 1), w.cell("threading", 5, 3), w.cell("threading", 8, 8)});
  EXPECT_TRUE(comes_true([&] {
    const draft::Draft d = draft_of(w);
    for (int end = 0; end < 8; ++end)
      if (d.threading.first(end) != end) return false;
    return d.threading.count() == 8;
  })) << "a line has one shaft per end";
  undone(w, "line");

  display_.key("u");
  display_.drag({w.cell("tieup", 2, 2), w.cell("tieup", 4, 3), w.cell("tieup", 5, 5)});
  EXPECT_TRUE(comes_true([&] { return draft_of(w).tieup.count() == 12; }));
  display_.key("g");
  display_.click(w.cell("tieup", 3, 3));
  EXPECT_TRUE(comes_true([&] { return draft_of(w).tieup.count() == 16; })) << "the fill";
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return draft_of(w).tieup.count() == 12; }));
  undone(w, "rectangle");

  display_.click(w.middle_of("tool:Filled"));
  display_.drag({w.cell("treadling", 1, 1), w.cell("treadling", 3, 4)});
  EXPECT_TRUE(comes_true([&] { return draft_of(w).treadling.count() == 12; }));
  undone(w, "filled rectangle");
}

TEST_F(DrawingTest, ShiftConstrainsAndEscapeCancels) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("i");
  display_.drag_holding("shift", {w.cell("treadling", 1, 1), w.cell("treadling", 4, 6), w.cell("treadling", 5, 6)});
  EXPECT_TRUE(comes_true([&] {
    const draft::Draft d = draft_of(w);
    for (int pick = 0; pick < 6; ++pick)
      if (d.treadling.first(pick) != pick) return false;
    return d.treadling.count() == 6;
  })) << "45 degrees: one treadle per pick";
  undone(w, "line");
  display_.drag({w.cell("threading", 1, 1), w.cell("threading", 6, 6)}, "key Escape");
  display_.drag({w.cell("threading", 9, 2), w.cell("threading", 10, 3)});
  EXPECT_TRUE(comes_true([&] { return draft_of(w).threading.count() == 2; })) << "the cancelled shape was drawn";
}

TEST_F(DrawingTest, TheSymmetricPenDrawsBothSides) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.click(w.middle_of("mirror:Ends"));
  display_.click(w.cell("threading", 3, 2));
  EXPECT_TRUE(comes_true([&] {
    const draft::Draft d = draft_of(w);
    return d.threading.get(2, 1) && d.threading.get(21, 1) && d.threading.count() == 2;
  }));
  undone(w, "a mirrored click");
  display_.key("shift+m");
  display_.key("i");
  display_.drag({w.cell("treadling", 1, 1), w.cell("treadling", 4, 6), w.cell("treadling", 8, 8)});
  EXPECT_TRUE(comes_true([&] {
    const draft::Draft d = draft_of(w);
    for (int i = 0; i < 8; ++i)
      if (!d.treadling.get(i, i) || !d.treadling.get(23 - i, i)) return false;
    return d.treadling.count() == 16;
  }));
  undone(w, "a mirrored line");
}

TEST_F(DrawingTest, AnEditBeyondTheLoomOffersTheClosestWeave) {
  show_cloth();  // beside it all picks fit, and no drag scrolls
  // A twill on a loom of four shafts and treadles, its drawdown painted.
  blank_.draft = draft::blank_draft(24, 24, 4, 4);
  for (int i = 0; i < 24; ++i) {
    blank_.draft.threading.set(i, i % 4, true);
    blank_.draft.treadling.set(i, i % 4, true);
  }
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) blank_.draft.tieup.set(t, s, (t + s) % 4 < 2);
  blank_.loom.leading = design::Leading::kDrawdown;
  blank_.loom.shafts = blank_.loom.treadles = 4;
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();

  // Two thirds of the ends become warp floats: a new kind of end, and the most frequent one.
  const bool drawn = !draft::drawdown(blank_.draft).get(0, 0);  // a drag from a filled cell clears
  const auto refused = [&] {
    display_.key("shift+u");
    display_.drag({w.cell("drawdown", 1, 1), w.cell("drawdown", 5, 5), w.cell("drawdown", 16, 24)});
    ASSERT_TRUE(comes_true([&] { return w.has("closest.leave"); })) << "there is no notice";
    EXPECT_EQ(w.live(), before) << "the draft changed";
    ASSERT_TRUE(w.has("closest.see")) << "there is a closer weave than the draft";
  };
  ASSERT_NO_FATAL_FAILURE(refused());
  display_.click(w.middle_of("closest.leave"));
  ASSERT_TRUE(comes_true([&] { return !w.has("closest.leave"); }));
  ASSERT_NO_FATAL_FAILURE(refused());
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("closest.leave"); })) << "Escape dismisses it, too";

  ASSERT_NO_FATAL_FAILURE(refused());
  display_.click(w.middle_of("closest.see"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Use closest weave") && w.live() != before; }));
  EXPECT_TRUE(w.has("closest.place:1")) << "the crossings that differ are listed";
  display_.click(w.middle_of("closest.place:1"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Cancel"));
  EXPECT_TRUE(comes_true([&] { return w.live() == before; })) << "to the byte";

  ASSERT_NO_FATAL_FAILURE(refused());
  display_.click(w.middle_of("closest.see"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Use closest weave"));
  const draft::Draft taken = draft_of(w);
  EXPECT_NE(taken, blank_.draft);
  EXPECT_LE(taken.shafts, 4);
  EXPECT_LE(taken.treadles, 4);
  undone(w, "the closest weave");

  ASSERT_NO_FATAL_FAILURE(refused());
  display_.click(w.middle_of("closest.larger"));
  EXPECT_TRUE(comes_true([&] {
    const draft::BitMatrix cells = draft::drawdown(draft_of(w));
    for (int pick = 0; pick < 24; ++pick)
      for (int end = 0; end < 16; ++end)
        if (cells.get(pick, end) != drawn) return false;
    return true;
  })) << "a larger loom weaves the edit";
  undone(w, "the larger loom");
}

TEST_F(DrawingTest, NumbersAreTypedIntoThreadingAndTreadling) {
  blank_.draft = draft::blank_draft(24, 24, 12, 12);
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("n");
  ASSERT_TRUE(comes_true([&] { return w.has("type.cursor"); }));
  display_.click(w.cell("threading", 1, 1));
  display_.type("2312,");
  const auto shaft = [&](int end) { return draft_of(w).threading.first(end - 1) + 1; };
  EXPECT_TRUE(comes_true([&] { return shaft(1) == 2 && shaft(2) == 3 && shaft(3) == 12; }));
  display_.type("1");
  EXPECT_TRUE(comes_true([&] { return shaft(4) == 1; })) << "accepted after a second";
  display_.key("KP_4");
  EXPECT_TRUE(comes_true([&] { return shaft(5) == 4; })) << "the number pad";
  display_.key("ctrl+z ctrl+z");
  EXPECT_TRUE(comes_true([&] { return shaft(4) == 0 && shaft(3) == 12; })) << "an entry is one undo step";
  display_.click(w.cell("treadling", 3, 2));
  display_.type("54");
  display_.key("Up space");
  EXPECT_TRUE(comes_true([&] {
    const draft::BitMatrix t = draft_of(w).treadling;
    return t.first(1) == 4 && t.first(2) == -1;
  })) << "Space inverts the cell at the cursor";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("type.cursor"); }));
}

TEST_F(DrawingTest, TheMapFollowsTheOrientation) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const auto by_name = [&](const std::string& words) {
    display_.key("ctrl+p");
    display_.type(words);
    display_.key("Return");
  };
  ASSERT_LT(w.cell("threading", 1, 1).y, w.cell("drawdown", 1, 1).y);
  by_name("threading below");
  ASSERT_TRUE(comes_true([&] { return w.cell("threading", 1, 1).y > w.cell("drawdown", 1, 24).y; }));
  EXPECT_LT(w.cell("threading", 1, 1).y, w.cell("threading", 1, 8).y) << "shaft 1 lies next to the drawdown";
  by_name("end 1 at the right");
  ASSERT_TRUE(comes_true([&] { return w.cell("drawdown", 1, 1).x < w.cell("drawdown", 24, 1).x; }));
  display_.click(w.cell("threading", 3, 7));
  EXPECT_TRUE(comes_true([&] { return draft_of(w).threading.get(2, 6); })) << "the click missed the cell";
  display_.click(w.cell("tieup", 2, 5));
  EXPECT_TRUE(comes_true([&] { return draft_of(w).tieup.get(1, 4); }));
  display_.drag({w.cell("warp_colors", 20, 1), w.cell("warp_colors", 24, 1)});
  display_.key("n");
  display_.click(w.cell("threading", 5, 1));
  display_.key("Right Down space");
  EXPECT_TRUE(comes_true([&] { return draft_of(w).threading.get(5, 1); })) << "arrows move as on the screen";
}

TEST_F(DrawingTest, TheTiledViewRepeatsTheDrawdownAndOutlinesTheRepeat) {
  put(draft_, straight_draft(24, 8));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(shrink(w, 4));
  const auto below = [&] {
    const Point last = w.cell("drawdown", 20, 24), before = w.cell("drawdown", 20, 23);
    return display_.picture({last.x, last.y + 3 * (last.y - before.y)}, {30, 30});
  };
  std::string plain;
  comes_true([&] { return std::exchange(plain, below()) == plain; });
  display_.key("shift+t");
  EXPECT_TRUE(comes_true([&] { return below() != plain; })) << "nothing beyond the last pick";
  display_.click(w.cell("threading", 3, 7));
  EXPECT_TRUE(comes_true([&] { return draft_of(w).threading.get(2, 6); }));
  display_.key("ctrl+z");
  const auto edge = [&] { return display_.picture(w.cell("drawdown", 8, 8), {12, 12}); };
  comes_true([&] { return std::exchange(plain, edge()) == plain; });
  display_.key("F2");
  EXPECT_TRUE(comes_true([&] { return edge() != plain; })) << "the repeat of eight is not outlined";
}

TEST_F(DrawingTest, TheMinimapShowsThePartAndScrolls) {
  put(draft_, straight_draft(400, 8));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(enlarge(w, 4));
  // It goes soon after the zoom, but stays under the pointer.
  ASSERT_TRUE(comes_true([&] {
    if (w.has("minimap.stays")) return true;
    if (w.has("minimap")) display_.move(w.middle_of("minimap"));
    else display_.key("ctrl+minus"), display_.key("ctrl+plus");
    return false;
  }));
  const auto [at, size] = w.place_of("minimap");
  const Point far_corner{at.x + 6, at.y + size.y - 6};
  const double before = w.cell("drawdown", 400, 400).x;
  display_.click(far_corner);
  EXPECT_TRUE(comes_true([&] { return w.cell("drawdown", 400, 400).x > 0 && w.cell("drawdown", 400, 400).x > before; }))
      << "the last end is not visible";
  EXPECT_EQ(design_of(w.live()), design_of(bytes_of(draft_))) << "the click went through to the drawdown";
  display_.drag({far_corner, {at.x + size.x / 2, at.y + size.y / 2}, {at.x + size.x - 6, at.y + 6}});
  EXPECT_TRUE(comes_true([&] { return w.cell("drawdown", 1, 1).y > w.cell("threading", 1, 1).y; }));
  display_.key("o");
  EXPECT_TRUE(comes_true([&] { return !w.has("minimap"); }));
}

TEST_F(DrawingTest, APasteThatAddsTreadlesLeavesAFittedDraftFitted) {
  design::Design wide = design_of(straight_draft(60, 8));
  wide = design::with_size(std::move(wide), 60, 24, 8, 8);
  put(draft_, wif::write_new_wif(wide));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_FALSE(w.has("scroll.ends")) << "it is fitted";
  const auto pitch = [&] { return std::abs(w.cell("drawdown", 1, 1).x - w.cell("drawdown", 2, 1).x); };
  const double before = pitch();
  // Eight picks that lift a shaft each.
  display_.drag_holding("ctrl", {w.cell("threading", 1, 1), w.cell("threading", 8, 8)});
  display_.key("ctrl+c");
  display_.move(w.cell("drawdown", 1, 1));
  display_.key("ctrl+v");
  display_.click(w.cell("drawdown", 1, 1));
  ASSERT_TRUE(comes_true([&] { return draft_of(w).treadles == 16; }));
  EXPECT_EQ(pitch(), before) << "the cells stay under the hand";
  display_.move(w.cell("threading", 20, 4));
  EXPECT_TRUE(comes_true([&] { return pitch() < before && !w.has("scroll.ends"); }))
      << "the last ends are out of sight";
}

TEST_F(DrawingTest, ALockedGridSaysWhyNothingIsDeletedInIt) {
  design::Design locked = design_of(straight_draft());
  locked.loom.leading = design::Leading::kDrawdown;
  locked.loom.locked = true;
  put(draft_, wif::write_new_wif(locked));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.drag_holding("ctrl", {w.cell("threading", 1, 1), w.cell("threading", 4, 4)});
  EXPECT_FALSE(w.has("message.refusal"));
  display_.key("Delete");
  EXPECT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "it is silent";
  EXPECT_EQ(draft_of(w), locked.draft);
}

TEST_F(DrawingTest, ANumberThatWaitsIsKeptByAClickElsewhere) {
  put(draft_, straight_draft(24, 16));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.move(w.cell("threading", 3, 3));
  display_.key("n");
  display_.key("1");
  display_.click(w.cell("threading", 9, 9));
  EXPECT_TRUE(comes_true([&] { return draft_of(w).threading.first(2) == 0; })) << "end 3 is on shaft 1";
}

TEST_F(DrawingTest, OnlyTheColoursOfThreadsAreCopied) {
  blank_.draft.palette = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  blank_.draft.warp.color[0] = blank_.draft.warp.color[2] = 2;
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.drag({w.cell("warp_numbers", 1, 1), w.cell("warp_numbers", 2, 1)});
  display_.key("ctrl+alt+c");
  display_.drag({w.cell("weft_numbers", 1, 5), w.cell("weft_numbers", 1, 8)});
  display_.key("ctrl+alt+v");
  EXPECT_TRUE(comes_true([&] {
    const std::vector<int> weft = draft_of(w).weft.color;
    return weft.size() > 8 && weft[4] == 2 && weft[5] == 0 && weft[6] == 2 && weft[7] == 0 && weft[8] == 1;
  }));
  undone(w, "the paste");
}

TEST_F(DrawingTest, AnOrderOfColoursIsTyped) {
  blank_.draft.palette = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  ASSERT_NO_FATAL_FAILURE(click(w, "threads.color"));
  ASSERT_NO_FATAL_FAILURE(click(w, "threads.color:order"));
  display_.key("ctrl+a");
  display_.type("9");
  ASSERT_TRUE(comes_true([&] { return w.has("threads.color:note"); })) << "it does not say that there is no colour 9";
  EXPECT_EQ(w.live(), before);
  display_.key("ctrl+a");
  // On the way to 24x1, this is colour 2.
  const auto begun = std::chrono::steady_clock::now();
  display_.type("2");
  for (;; usleep(20'000)) {
    const std::string now = w.live();
    if (std::chrono::steady_clock::now() - begun > std::chrono::milliseconds(350)) break;
    ASSERT_EQ(now, before) << "the ends follow a number that is half typed";
  }
  display_.key("ctrl+a");
  display_.type("4x3 2x1");
  EXPECT_TRUE(comes_true([&] {
    const std::vector<int> warp = draft_of(w).warp.color;
    for (size_t i = 0; i < warp.size(); ++i)
      if (warp[i] != (i % 6 < 4 ? 2 : 0)) return false;
    return true;
  })) << "the ends do not follow the order";
  EXPECT_FALSE(w.has("threads.color:note"));
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("threads.color:order"); })) << "Enter leaves the list open";
  undone(w, "the order");
}

TEST_F(DrawingTest, AnOrderOfColoursIsKeptByEnterAndByAClickElsewhere) {
  blank_.draft.palette = {{0, 0, 0}, {1, 1, 1}, {1, 0, 0}};
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  for (const bool by_enter : {true, false}) {
    ASSERT_NO_FATAL_FAILURE(click(w, "threads.color"));
    ASSERT_NO_FATAL_FAILURE(click(w, "threads.color:order"));
    display_.key("ctrl+a");
    display_.type("3 2");
    if (by_enter) display_.key("Return");
    else display_.click(w.middle_of("inspector:Threads"));
    ASSERT_TRUE(comes_true([&] { return !w.has("threads.color:order"); }));
    EXPECT_TRUE(comes_true([&] {
      const std::vector<int> warp = draft_of(w).warp.color;
      return warp.size() > 1 && warp[0] == 2 && warp[1] == 1;
    })) << by_enter;
    undone(w, "the order");
  }
}

TEST_F(DrawingTest, ADragBeyondTheEdgeScrolls) {
  blank_.draft = draft::blank_draft(400, 24, 8, 8);
  put(draft_, wif::write_new_wif(blank_));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(enlarge(w, 4));
  const auto is_seen = [&](int end) { return w.cell("drawdown", end, 1).x > 14; };
  ASSERT_TRUE(comes_true([&] { return w.has("minimap") && !is_seen(150); }));
  const Point from = w.cell("threading", 20, 3);
  display_.drag({from, {60, from.y}, {3, from.y}}, "sleep 1.5");
  EXPECT_TRUE(comes_true([&] { return is_seen(80); })) << "the grid did not scroll";
  int painted = 0;
  EXPECT_TRUE(comes_true([&] {
    painted = 0;
    const draft::Draft d = draft_of(w);
    while (d.threading.get(19 + painted, 2)) ++painted;
    return painted > 60 && d.threading.count() == painted;
  })) << painted
      << " ends painted, none skipped";
  undone(w, "the drag");
}

}  // namespace
}  // namespace weftlight::gui
