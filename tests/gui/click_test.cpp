// A click is one cell: on every grid, whatever leads, from whichever corner the grids begin, and though the draft grows
// under the pressed button.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "design/crossings.h"
#include "draft/factor.h"
#include "on_display.h"

namespace weftlight::gui {

using design::Leading;

namespace {

/// Where the grids begin, and what leads.
struct Way {
  const char* name;
  Leading leading;
  bool end1_right, pick1_bottom, threading_below;
};

void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

design::Design twill(Leading leading) {
  design::Design d;
  d.draft = draft::blank_draft(48, 48, 4, 4);
  for (int i = 0; i < 48; ++i) {
    d.draft.threading.set(i, i % 4, true);
    d.draft.treadling.set(i, i % 4, true);
  }
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) d.draft.tieup.set(t, s, (s - t + 4) % 4 < 2);
  d.draft.palette = {{0.2f, 0.3f, 0.25f}, {0.7f, 0.65f, 0.5f}, {1, 0, 0}};
  d.draft.warp.color[6] = 2;
  d.scene.mesh = "plane";
  return design::with_leading(std::move(d), leading);
}

class ClickTest : public OnDisplay, public testing::WithParamInterface<Way> {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    const bool from_the_left = !GetParam().end1_right && !GetParam().pick1_bottom;
    settings({{"end1_right", GetParam().end1_right},
              {"pick1_bottom", GetParam().pick1_bottom},
              {"threading_below", GetParam().threading_below},
              {"cloth", from_the_left}});  // beside the cloth, which is busy, too
    put(draft_, wif::write_new_wif(twill(GetParam().leading)));
  }

  /// Middle of a cell, once the window has drawn the draft that it exports.
  static Point cell(const Window& w, const std::string& grid, int a, int b) {
    const draft::Draft d = design_of(w.live()).draft;
    EXPECT_TRUE(comes_true([&] {
      return w.size_of("threading").second == d.shafts &&
             (d.shed_control == draft::ShedControl::kLiftplan || w.size_of("tieup").first == d.treadles);
    }));
    return w.cell(grid, a, b);
  }
  /// The draft after what the hand did: all of it is there once one undo has taken it back, and redo brings it whole.
  /// Empty, and a failure, as soon as one of these does not come.
  design::Design after(const Window& w, const std::string& before, const std::string& what) const {
    const auto fails = [&](bool changed, const char* how) {
      const bool came = comes_true([&] { return (w.live() != before) == changed; });
      EXPECT_TRUE(came) << what << how;
      return !came;
    };
    if (fails(true, " changed nothing")) return {};
    display_.key("ctrl+z");
    if (fails(false, " is not one step of undo")) return {};
    display_.key("ctrl+shift+z");
    if (fails(true, " does not come again")) return {};
    return design_of(w.live());
  }
  void expect_click(const Window& w, const std::string& grid, int a, int b, const design::Design& wanted) const {
    const std::string before = w.live();
    const Point at = cell(w, grid, a, b);
    display_.click(at);
    const std::string what = grid + " " + std::to_string(a) + ", " + std::to_string(b);
    EXPECT_TRUE(after(w, before, what).draft == wanted.draft) << what << ": another cell changed, or none";
  }
  void expect_drag(const Window& w, const std::string& grid, const std::vector<Point>& along,
                   const design::Design& wanted, const std::string& then = {}) const {
    const std::string before = w.live();
    display_.drag(along, then);
    EXPECT_TRUE(after(w, before, grid).draft == wanted.draft) << grid << ": other cells changed";
  }
  static design::Design turned_crossing(const design::Design& d, int end, int pick) {
    const bool up = draft::drawdown(d.draft).get(pick - 1, end - 1);
    design::Design turned = design::with_drawdown_cell(d, end - 1, pick - 1, !up);
    turned.draft = draft::without_spare(std::move(turned.draft), d.draft, {4, 4});
    return turned;
  }
};

class PressTest : public ClickTest {};

TEST_P(ClickTest, IsOneCrossingThoughTheLoomGrowsUnderThePointer) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const design::Design first = design_of(w.live());
  expect_click(w, "drawdown", 3, 2, turned_crossing(first, 3, 2));
  expect_click(w, "drawdown", 3, 2, first);  // and another takes it back, with all that the first had added
  if (HasFailure()) return;

  // Held still, then with a hand that trembles. All three stay in view, though the loom that grows takes of the
  // drawdown's height, in a window that has the frame of Windows on the same screen, too.
  for (const std::vector<Point>& tremor :
       {std::vector<Point>{{0, 0}, {0, 0}, {0, 0}, {0, 0}}, {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {-1, -1}, {0, 0}}})
    for (const auto& [end, pick] : {std::pair{20, 40}, {2, 20}, {36, 3}}) {
      const design::Design now = design_of(w.live());
      const Point at = cell(w, "drawdown", end, pick);
      std::vector<Point> along;
      for (const Point& p : tremor) along.push_back({at.x + p.x, at.y + p.y});
      expect_drag(w, "drawdown", along, turned_crossing(now, end, pick));
      if (HasFailure()) return;
    }
  // The right button clears.
  const design::Design now = design_of(w.live());
  const draft::BitMatrix cells = draft::drawdown(now.draft);
  for (int end = 10; end < 30; ++end) {
    if (!cells.get(19, end - 1)) continue;
    const std::string before = w.live();
    display_.right_click(cell(w, "drawdown", end, 20));
    EXPECT_TRUE(after(w, before, "right click").draft == turned_crossing(now, end, 20).draft);
    break;
  }
}

TEST_P(ClickTest, IsOneCellOnEveryOtherGrid) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  design::Design now = design_of(w.live());
  const auto expect = [&](const char* grid, int a, int b, const design::Design& wanted) {
    expect_click(w, grid, a, b, wanted);
    now = design_of(w.live());
  };
  expect("threading", 3, 1, design::with_threading(now, 2, 0, true));
  expect("threading", 47, 4, design::with_threading(now, 46, 3, true));
  if (GetParam().leading == Leading::kLiftplan) {
    expect("liftplan", 2, 5, design::with_liftplan(now, 4, 1, !now.draft.liftplan.get(4, 1)));
  } else {
    expect("tieup", 1, 4, design::with_tieup(now, 0, 3, true));
    expect("treadling", 4, 6, design::with_treadling(now, 5, 3, true));
  }
  expect("warp_colors", 7, 1, design::with_thread_color(now, draft::System::kWarp, 6, 0));
  expect("weft_colors", 1, 9, design::with_thread_color(now, draft::System::kWeft, 8, 0));
  // The number of a thread chooses that one: its colour goes to one pick.
  display_.click(cell(w, "warp_numbers", 5, 1));
  display_.key("ctrl+alt+c");
  display_.click(cell(w, "weft_numbers", 1, 30));
  const std::string before = w.live();
  display_.key("ctrl+alt+v");
  EXPECT_TRUE(after(w, before, "numbers").draft == design::with_thread_color(now, draft::System::kWeft, 29, 0).draft);
}

TEST_P(PressTest, IsOneCrossingThoughTheWindowOrThePitchChangesMeanwhile) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  for (const char* meanwhile : {"key ctrl+plus", "keydown ctrl click 4 click 4 keyup ctrl", "click 5 click 5",
                                "key End", "search --onlyvisible --class weftlight windowsize 1100 700"}) {
    if (HasFailure()) return;
    const design::Design now = design_of(w.live());
    const Point at = cell(w, "drawdown", 24, 24);
    expect_drag(w, "drawdown", {at, at}, turned_crossing(now, 24, 24), meanwhile);
    display_.key("ctrl+z");
    EXPECT_TRUE(comes_true([&] { return design_of(w.live()) == now; })) << meanwhile;
  }
}

TEST_P(PressTest, AStrokeLeavesNoTreadleAndNoShaftThatItAddedOnItsWay) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const design::Design first = design_of(w.live());
  // Its first crossings ask for more than the loom has, all of them for less.
  const draft::BitMatrix cells = draft::drawdown(first.draft);
  const int from = cells.get(1, 2) ? 2 : 4, to = from + 1;
  const Point a = cell(w, "drawdown", from, 2), b = cell(w, "drawdown", to, 2);
  ASSERT_EQ(cells.get(1, from - 1), cells.get(1, to - 1));
  draft::BitMatrix both(1, 2);
  both.set(0, 0, true), both.set(0, 1, true);
  const draft::Selection s{draft::BitGrid::kDrawdown, from - 1, to, 1, 2};
  const draft::Write write = cells.get(1, from - 1) ? draft::Write::kErase : draft::Write::kAdd;
  expect_drag(w, "drawdown", {a, {(a.x + b.x) / 2, a.y}, b, b},
              design::painted_crossings(first, s, s.a0, s.b0, both, write).value());
}

std::string name_of(const testing::TestParamInfo<Way>& way) { return way.param.name; }

INSTANTIATE_TEST_SUITE_P(Ways, ClickTest,
                         testing::Values(Way{"threading_from_the_right", Leading::kThreading, true, false, false},
                                         Way{"threading_from_below", Leading::kThreading, false, true, true},
                                         Way{"liftplan_from_the_right", Leading::kLiftplan, true, true, false},
                                         Way{"liftplan_from_the_left", Leading::kLiftplan, false, false, true},
                                         Way{"drawdown_from_the_right", Leading::kDrawdown, true, false, true},
                                         Way{"drawdown_from_the_left", Leading::kDrawdown, false, true, false}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Ways, PressTest,
                         testing::Values(Way{"threading", Leading::kThreading, true, false, false},
                                         Way{"drawdown", Leading::kDrawdown, false, true, true}),
                         name_of);

}  // namespace
}  // namespace weftlight::gui
