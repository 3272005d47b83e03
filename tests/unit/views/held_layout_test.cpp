// The grids stand still under a pressed button, and a stroke is in the cells that the hand came to.

#include "views/draft/held_layout.h"

#include <gtest/gtest.h>

#include <random>

#include "../hand_drafts.h"
#include "design/crossings.h"
#include "design/edits.h"
#include "session/editing/paint.h"

namespace weftlight::views {

using design::Design, design::Leading, design::painted_crossings, design::random_draft, design::straight_twill,
    design::text_of, design::with_leading, design::with_size;
using draft::BitGrid, draft::BitMatrix, draft::Selection, draft::Write, draft::drawdown, draft::whole_grid;
using session::Cell, session::DocumentView, session::DraftView, session::GridId, session::MaybeEdit, session::Settings,
    session::begin_stroke, session::go_on_with_stroke, session::line_of_cells, session::zoomed_pitch;
using ui::Axis, ui::Style, ui::cell_at, ui::clamp_scroll;

namespace {

constexpr int kEnds = 40, kPicks = 36;

class HeldLayoutTest : public testing::Test {
 protected:
  int roll(int below) { return static_cast<int>(dice_() % static_cast<unsigned>(below)); }
  bool toss() { return roll(2) == 0; }

  void begin() {
    design_.draft = random_draft(dice_, kEnds, kPicks, 4, 4);
    design_ = with_leading(std::move(design_), static_cast<Leading>(roll(3)));
    design_.loom.shafts = design_.loom.treadles = kEnds + kPicks;  // it weaves whatever is asked
    view_ = {};
    view_.drawing.given = {design_.draft.shafts, design_.draft.treadles};
    settings_.end1_right = toss();
    settings_.pick1_bottom = toss();
    settings_.threading_below = toss();
    settings_.tiled = toss();
    max_ = {static_cast<float>(260 + roll(500)), static_cast<float>(260 + roll(500))};
  }
  DraftLayout frame(bool down, bool moves = true, ImVec2 window = {}) {
    const DraftLayout l = held_.of(lay_out_draft(design_.draft, view_.draft, settings_, Style{}, {0, 0}, max_),
                                   view_.draft, {down, moves, window});
    settle(view_.draft, l);
    if (down) held_.hold(l, view_.draft);
    return l;
  }
  /// Whatever may happen while the button is down.
  void disturb() {
    switch (roll(6)) {
      case 0:
        view_.draft.pitch = zoomed_pitch(view_.draft.pitch, toss() ? 1 : -1);
        return;
      case 1:
        view_.draft.scroll_end += 3, view_.draft.scroll_pick += 2, view_.draft.scroll_shaft += 1,
            view_.draft.scroll_treadle += 1;
        return;
      case 2:
        max_ = {max_.x - 30, max_.y - 20};
        return;
      case 3: {
        const int ends = design_.draft.ends() + roll(5), picks = design_.draft.picks() + roll(5);
        const int shafts = design_.draft.shafts + roll(3), treadles = design_.draft.treadles + roll(3);
        design_ = with_size(design_, ends, picks, shafts, treadles);
        return;
      }
      default:
        return;
    }
  }
  void apply(const MaybeEdit& edit) {
    if (edit) design_ = edit->apply(std::move(design_));
  }

  std::mt19937 dice_{11};
  Design design_;
  DocumentView view_;
  Settings settings_;
  ImVec2 max_;
  HeldLayout held_;
};

ImVec2 middle_of(const GridPane& pane, Cell at) {
  const auto middle = [](const Axis& a, int i) { return (a.low(i) + a.high(i)) / 2; };
  return {middle(pane.x, at.a), middle(pane.y, at.b)};
}

std::vector<float> places_of(const DraftLayout& l) {
  std::vector<float> all;
  for (const GridPane* p : {&l.warp_bar, &l.threading, &l.tieup, &l.drawdown, &l.lift, &l.weft_bar, &l.warp_labels,
                            &l.weft_labels, &l.tiled_drawdown})
    for (const Axis* a : {&p->x, &p->y})
      for (const float value : {a->start, a->length, a->pitch, a->scroll}) all.push_back(value);
  return all;
}

TEST_F(HeldLayoutTest, AStrokeIsTheCellsThatTheHandCameToInTheLayoutOfThePress) {
  for (int round = 0; round < 300; ++round) {
    begin();
    frame(false);
    const DraftLayout pressed = frame(true);
    const GridPane& pane = pressed.drawdown;
    const auto cell = [&] {
      const int a0 = pane.x.first_visible(), b0 = pane.y.first_visible();
      return Cell{a0 + roll(pane.x.end_visible() - a0), b0 + roll(pane.y.end_visible() - b0)};
    };
    const bool only_draws = toss();  // else other things happen, too
    const Design before = design_;
    Cell at = cell();
    const bool on = !drawdown(before.draft).get(at.b, at.a);
    apply(begin_stroke(view_, design_, GridId::kDrawdown, at, on, true));
    BitMatrix asked(kPicks, kEnds);
    asked.set(at.b, at.a, true);
    for (int step = 0; step < 8; ++step) {
      const Cell from = at;
      if (toss()) at = cell();  // else it is held still
      for (const Cell& on_way : line_of_cells(from, at)) asked.set(on_way.b, on_way.a, true);
      if (!only_draws) disturb();
      const DraftLayout l = frame(true);
      ASSERT_EQ(places_of(l), places_of(pressed)) << round << ", " << step;
      const ImVec2 hand = middle_of(pane, at);
      ASSERT_EQ(l.drawdown.nearest(hand), at);
      apply(go_on_with_stroke(view_, design_, l.drawdown.nearest(hand), true));
    }
    if (only_draws) {
      const Selection all = whole_grid(before.draft, BitGrid::kDrawdown);
      const Write write = on ? Write::kAdd : Write::kErase;
      ASSERT_EQ(text_of(drawdown(design_.draft)),
                text_of(drawdown(painted_crossings(before, all, 0, 0, asked, write).value_or(before).draft)))
          << round;
    }
    const DraftLayout after = frame(false);
    ASSERT_EQ(places_of(after), places_of(lay_out_draft(design_.draft, view_.draft, settings_, Style{}, {0, 0}, max_)));
  }
}

TEST_F(HeldLayoutTest, ASecondClickWithoutAMoveIsOnTheSameCell) {
  begin();
  design_ = with_leading(std::move(design_), Leading::kDrawdown);
  const DraftLayout pressed = frame(true);
  const Cell at{pressed.drawdown.x.first_visible() + 1, pressed.drawdown.y.first_visible() + 1};
  const Design before = design_;
  apply(begin_stroke(view_, design_, GridId::kDrawdown, at, !drawdown(before.draft).get(at.b, at.a), true));
  ASSERT_NE(places_of(lay_out_draft(design_.draft, view_.draft, settings_, Style{}, {0, 0}, max_)), places_of(pressed));
  EXPECT_EQ(places_of(frame(false, false)), places_of(pressed));
  EXPECT_EQ(places_of(frame(true)), places_of(pressed)) << "the second click";
  EXPECT_NE(places_of(frame(false)), places_of(pressed)) << "the hand moves on";
}

TEST_F(HeldLayoutTest, AWindowOfAnotherSizeIsLaidOutAnew) {
  begin();
  const DraftLayout pressed = frame(true);
  max_ = {max_.x - 50, max_.y - 50};
  EXPECT_EQ(places_of(frame(false, false)), places_of(pressed));
  EXPECT_NE(places_of(frame(false, false, {100, 100})), places_of(pressed));
}

TEST_F(HeldLayoutTest, TheHandItselfMayScroll) {
  for (int round = 0; round < 100; ++round) {
    begin();
    view_.draft.pitch = 20;
    frame(false);
    const DraftLayout pressed = frame(true);
    view_.draft.scroll_end += 2;
    view_.draft.scroll_pick += 1;
    held_.let_scroll();
    const DraftLayout l = frame(true);
    EXPECT_EQ(l.drawdown.x.scroll, clamp_scroll(pressed.drawdown.x, pressed.drawdown.x.scroll + 2));
    for (const GridPane* pane : {&l.threading, &l.warp_bar, &l.warp_labels}) {
      EXPECT_EQ(pane->x.scroll, l.drawdown.x.scroll);
      EXPECT_EQ(pane->x.start, pressed.drawdown.x.start);
    }
    for (const GridPane* pane : {&l.lift, &l.weft_bar, &l.weft_labels}) EXPECT_EQ(pane->y.scroll, l.drawdown.y.scroll);
    // What goes on beyond the edges goes along.
    EXPECT_EQ(cell_at(l.tiled_drawdown.x, l.drawdown.x.low(12) + 1), 12);
    EXPECT_EQ(places_of(frame(true)), places_of(l));
  }
}

TEST_F(HeldLayoutTest, AnotherDocumentIsLaidOutAnew) {
  begin();
  frame(true);
  DraftView other;
  const DraftLayout l = lay_out_draft(straight_twill(6, 5).draft, other, settings_, Style{}, {0, 0}, max_);
  EXPECT_EQ(places_of(held_.of(l, other, {true, true})), places_of(l));
}

}  // namespace
}  // namespace weftlight::views
