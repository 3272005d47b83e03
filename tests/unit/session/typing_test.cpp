#include "session/editing/typing.h"

#include <gtest/gtest.h>

#include "../hand_drafts.h"
#include "session/document/document.h"
#include "session/editing/follow_document.h"

namespace weftlight::session {

using design::Design, design::Leading;
using draft::Draft, draft::ShedControl, draft::blank_draft;

namespace {

/// A document with a keyboard.
class Typist {
 public:
  explicit Typist(Design design) : document(std::move(design)) { begin_typing(view, draft(), {}); }
  const Draft& draft() const { return document.now().draft; }
  /// Keys parted by blanks; "wait": as long as a number waits.
  bool type(const std::string& keys) {
    bool taken = true;
    for (size_t at = 0; at <= keys.size();) {
      const size_t end = std::min(keys.find(' ', at), keys.size());
      const std::string key = keys.substr(at, end - at);
      at = end + 1;
      if (key == "wait") now_s += kDigitWaitS + 0.01;
      TypedKey typed =
          key == "wait" ? type_after_wait(view, document.now(), now_s) : type_key(view, document.now(), {}, key, now_s);
      for (const Edit& edit : typed.edits) steps += document.commit(edit, 0);
      follow_document(view, document);
      taken = typed.taken;
    }
    return taken;
  }
  std::vector<int> shafts() const {
    std::vector<int> all;
    for (int end = 0; end < draft().ends(); ++end) all.push_back(draft().threading.first(end) + 1);
    return all;
  }

  Document document;
  DocumentView view;
  double now_s = 10;
  int steps = 0;
};

Design blank(int threads, int shafts) {
  Design d;
  d.draft = blank_draft(threads, threads, shafts, shafts);
  return d;
}

using Shafts = std::vector<int>;

TEST(Typing, DigitsThreadEndAfterEnd) {
  Typist t(blank(6, 8));
  t.type("1 2 3 4");
  EXPECT_EQ(t.shafts(), (Shafts{1, 2, 3, 4, 0, 0}));
  EXPECT_EQ(t.view.drawing.cursor.at.a, 4);
  EXPECT_EQ(t.steps, 4) << "each a step of undo";
  t.document.undo();
  EXPECT_EQ(t.shafts(), (Shafts{1, 2, 3, 0, 0, 0}));
  // What the end was on before goes.
  t.type("Home 5");
  EXPECT_EQ(t.shafts()[0], 5);
  EXPECT_EQ(std::popcount(t.draft().threading.row(0)[0]), 1);
}

TEST(Typing, ANumberThatCouldGetAnotherDigitWaits) {
  Typist t(blank(8, 16));
  t.type("2");
  EXPECT_EQ(t.shafts()[0], 2) << "there is no shaft 20";
  t.type("1");
  EXPECT_EQ(t.shafts()[1], 0) << "it may become 10 to 16";
  EXPECT_TRUE(waits_until(t.view));
  t.type("wait");
  EXPECT_EQ(t.shafts()[1], 1);
  t.type("1 2 1 , 1 Enter 1 Space");
  EXPECT_EQ(t.shafts(), (Shafts{2, 1, 12, 1, 1, 1, 0, 0}));
  EXPECT_EQ(t.steps, 6);
  t.type("1 9");  // 19 is none: 1, and then 9
  EXPECT_EQ(t.shafts(), (Shafts{2, 1, 12, 1, 1, 1, 1, 9}));
  EXPECT_EQ(t.steps, 8);
  t.document.undo();
  EXPECT_EQ(t.shafts()[7], 0);
  EXPECT_EQ(t.shafts()[6], 1) << "two entries are two steps";
  t.type("1 0");
  EXPECT_EQ(t.shafts()[7], 10);
}

TEST(Typing, TheStatusLineSaysWhichNumbersThereAre) {
  Typist t(blank(6, 8));
  t.type("1 2");
  EXPECT_EQ(t.shafts(), (Shafts{1, 2, 0, 0, 0, 0})) << "there is no shaft 12";
  const auto said = [](const Typist& typist) {
    return typing_text(typist.view.drawing.cursor, typist.document.now(), {});
  };
  EXPECT_NE(said(t).find("type a shaft, 1 to 8"), std::string::npos) << said(t);
  t.type("Tab Tab");
  EXPECT_NE(said(t).find("type a treadle, 1 to 8"), std::string::npos) << said(t);
  Typist wide(blank(6, 16));
  EXPECT_NE(said(wide).find("type a shaft, 1 to 16"), std::string::npos) << said(wide);
}

TEST(Typing, AWaitingNumberIsKeptWhenTheCursorIsPutElsewhere) {
  Typist t(blank(8, 16));
  t.type("1");
  const MaybeEdit typed = accept_number(t.view, t.document.now());
  ASSERT_TRUE(typed);
  t.document.commit(*typed, 0);
  EXPECT_EQ(t.shafts()[0], 1);
  EXPECT_FALSE(waits_until(t.view));
  EXPECT_FALSE(accept_number(t.view, t.document.now())) << "once only";
}

TEST(Typing, ACommaMayFollowAnyNumber) {
  Typist t(blank(8, 16));
  t.type("2 , 1 , 1 2 , 5 Enter Enter 7");
  EXPECT_EQ(t.shafts(), (Shafts{2, 1, 12, 5, 0, 7, 0, 0})) << "the second Enter leaves an end out";
}

TEST(Typing, EscapeCancelsTheNumberThenTheTool) {
  Typist t(blank(8, 16));
  t.type("1 Escape");
  EXPECT_EQ(t.view.drawing.cursor.typed, 0);
  EXPECT_EQ(t.view.select.tool, Tool::kType);
  EXPECT_EQ(t.steps, 0);
  t.type("Escape");
  EXPECT_EQ(t.view.select.tool, Tool::kPaint);
}

TEST(Typing, ZeroClearsAndMovesOnDeleteClearsAndStays) {
  Design d = blank(6, 4);
  for (int i = 0; i < 6; ++i) d.draft.threading.set(i, i % 4, true), d.draft.threading.set(i, 3, true);
  Typist t(d);
  t.type("0 Delete");
  EXPECT_EQ(t.shafts(), (Shafts{0, 0, 3, 4, 1, 2}));
  EXPECT_EQ(t.view.drawing.cursor.at.a, 1);
}

TEST(Typing, ArrowKeysMoveOnTheScreenAndAcceptAWaitingNumber) {
  Typist t(blank(30, 16));
  t.view.draft.seen_ends = 10;
  t.view.draft.seen_shafts = 16;
  t.type("Left Left Up");  // end 1 is at the right
  EXPECT_EQ(t.view.drawing.cursor.at, (Cell{2, 1}));
  t.type("1 Left");
  EXPECT_EQ(t.shafts()[2], 1);
  EXPECT_EQ(t.view.drawing.cursor.at.a, 3) << "one step, not two";
  t.type("End");
  EXPECT_EQ(t.view.drawing.cursor.at.a, 29);
  EXPECT_GE(t.view.draft.scroll_end, 20) << "the cursor is in sight";
  t.type("Home");
  EXPECT_EQ(t.view.drawing.cursor.at.a, 0);
  EXPECT_LE(t.view.draft.scroll_end, 0);
  EXPECT_FALSE(t.type("Ctrl+S")) << "what means nothing here is left to the actions";
}

TEST(Typing, TreadlesAreTypedPickByPickAndTabCyclesTheGrids) {
  Typist t(blank(6, 4));
  t.type("Tab Tab");
  ASSERT_EQ(t.view.drawing.cursor.grid, GridId::kTreadling);
  t.type("4 3 2");
  EXPECT_EQ(t.draft().treadling.first(0), 3);
  EXPECT_EQ(t.draft().treadling.first(2), 1);
  EXPECT_EQ(t.view.drawing.cursor.at.b, 3);
  t.type("Tab Tab");
  EXPECT_EQ(t.view.drawing.cursor.grid, GridId::kThreading) << "past the drawdown";
}

TEST(Typing, NumbersToggleMarksInTheTieUpAndSpaceTogglesAnyCell) {
  Typist t(blank(6, 4));
  t.type("Tab 1 3 Enter 2");
  EXPECT_TRUE(t.draft().tieup.get(0, 0));
  EXPECT_TRUE(t.draft().tieup.get(0, 2));
  EXPECT_TRUE(t.draft().tieup.get(1, 1));
  t.type("2 Space");
  EXPECT_FALSE(t.draft().tieup.get(1, 1));
  EXPECT_TRUE(t.draft().tieup.get(1, 0)) << "the cursor's own cell";
}

TEST(Typing, ImpossibleNumbersAreReported) {
  Typist t(blank(6, 4));
  t.type("7");
  EXPECT_EQ(t.view.select.refusal, "There is no shaft 7: the last is 4");
  EXPECT_EQ(t.view.drawing.cursor.at.a, 0);
  EXPECT_EQ(t.steps, 0);
}

TEST(Typing, ALockedGridStaysAndSoDoesTheCursor) {
  Design d = blank(6, 4);
  d.loom.leading = Leading::kDrawdown;
  d.loom.locked = true;
  Typist t(d);
  t.type("2");
  EXPECT_EQ(t.steps, 0);
  EXPECT_EQ(t.view.drawing.cursor.at.a, 0);
  EXPECT_EQ(t.view.select.refusal, "This follows the drawdown and is locked.");
}

TEST(Typing, TheCursorFollowsADraftThatShrinksOrChangesShedControl) {
  TypeCursor c{GridId::kTreadling, {3, 5}};
  Draft d = blank_draft(4, 4, 2, 2);
  follow_draft(c, d);
  EXPECT_EQ(c.at, (Cell{1, 3}));
  d.shed_control = ShedControl::kLiftplan;
  follow_draft(c, d);
  EXPECT_EQ(c.grid, GridId::kLiftplan);
}

}  // namespace
}  // namespace weftlight::session
