// What the window tells a weaver: refusals, what leads and what follows.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class DeskTest : public OnDisplay {};

TEST_F(DeskTest, ARefusalIsSeenBesideTheCellUnderThePointer) {
  design::Design d = design_of(bytes_of(draft_));
  d.loom.locked = true;
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("lock:drawdown"); }));
  EXPECT_FALSE(w.has("lock:threading")) << "the threading leads";
  const std::string before = w.live();
  display_.click(w.cell("drawdown", 3, 2));
  ASSERT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "the locked drawdown says nothing";
  EXPECT_EQ(w.live(), before);
  // The pointer goes to another cell: the message stands. It goes with an action after it was read
  // (unit/app/messages_test).
  display_.move(w.cell("drawdown", 6, 2));
  EXPECT_TRUE(w.has("message.refusal"));
  EXPECT_TRUE(comes_true([&] {
    display_.click(w.middle_of("inspector:Yarns"));
    return !w.has("message.refusal");
  })) << "a read message stays";
  // The padlock opens it.
  ASSERT_NO_FATAL_FAILURE(click(w, "lock:drawdown"));
  ASSERT_TRUE(comes_true([&] { return !design_of(w.live()).loom.locked; })) << "the padlock does not open";
  const std::string open = w.live();
  display_.click(w.cell("drawdown", 3, 2));
  EXPECT_TRUE(comes_true([&] { return w.live() != open; })) << "the unlocked drawdown cannot be painted";
}

TEST_F(DeskTest, ASearchWithoutResultSaysSo) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu:Draft"));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu.skeleton"));
  display_.move(w.cell("drawdown", 3, 2));
  EXPECT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "the cell under the pointer hides it";
}

TEST_F(DeskTest, ANewDraftIsMadeByKeyboardAlone) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:twill") && w.has("dialog:Create"); }));
  ASSERT_FALSE(w.has("weave.steps")) << "the test needs a weave that the arrows leave";
  display_.key("Down");
  EXPECT_TRUE(comes_true([&] { return w.has("weave.shafts"); })) << "the arrows do not choose the next weave";
  // Enter on a button presses that, not the first one.
  display_.key("shift+Tab");
  display_.key("shift+Tab");
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog:Create"); })) << "Cancel has the keyboard";
  EXPECT_EQ(design_of(w.live()).draft.ends(), 24);
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Create"); }));
  display_.key("Down Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog:Create"); })) << "Enter on a row is for the dialog";
}

TEST_F(DeskTest, TheSettOnTheLoomStandsBelowTheFirmOne) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Analysis"));
  EXPECT_TRUE(comes_true([&] { return w.has("analysis.loom_sett"); }));
}

TEST_F(DeskTest, ALongNameInAListIsToldByATip) {
  design::Design d = design_of(bytes_of(draft_));
  ASSERT_FALSE(d.yarns.empty());
  d.yarns[0].name = "Heavy mercerised cotton of the old mill by the river";
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Yarns"));
  ASSERT_TRUE(comes_true([&] { return w.has("yarn.list"); }));
  display_.move(w.middle_of("yarn.list"));
  EXPECT_TRUE(comes_true([&] { return w.has("tip"); })) << "the name is cut, and nothing tells the rest";
}

TEST_F(DeskTest, TheDotWhereTheDraftBeginsIsToldByATip) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("origin"); }));
  display_.move(w.middle_of("origin"));
  EXPECT_TRUE(comes_true([&] { return w.has("tip"); })) << "nothing says what the dot means";
}

TEST_F(DeskTest, TabGoesFromOneNumberToTheNext) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave.ends") && w.has("dialog:Create"); }));
  const auto [at, size] = w.place_of("weave.ends");
  display_.click({at.x + size.x / 4, at.y + size.y / 2});
  display_.key("ctrl+a");
  display_.type("40");
  display_.key("Tab");
  display_.type("20");
  ASSERT_NO_FATAL_FAILURE(press(w, "Create"));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 40; }));
  EXPECT_EQ(design_of(w.live()).draft.picks(), 20) << "Tab went past the picks";
}

TEST_F(DeskTest, TheChosenWeaveIsInSightWhereverAnotherDialogLeftTheList) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:twill") && w.has("dialog:Apply"); }));
  display_.type("network");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:network") && !w.has("weave:twill"); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Apply"));
  const auto is_in_sight = [&](const std::string& weave) {
    const auto [field, height] = w.place_of("weave.find");
    const double y = w.middle_of(weave).y;
    return y > field.y + height.y && y < w.place_of("dialog:Cancel").first.y;
  };
  // The list opens in the middle, then at its beginning.
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:plain") && w.has("dialog:Apply"); }));
  EXPECT_TRUE(comes_true([&] { return is_in_sight("weave:network"); }));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Apply"); }));
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:plain") && w.has("dialog:Create"); }));
  EXPECT_TRUE(comes_true([&] { return is_in_sight("weave:plain"); })) << "the chosen weave is above the list";
}

TEST_F(DeskTest, ASearchThatFindsNoWeaveSaysSoInWholeWords) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:twill"); }));
  display_.type("something that nobody weaves");
  ASSERT_TRUE(comes_true([&] { return w.has("weave.none"); }));
  const auto [text, size] = w.place_of("weave.none");
  const auto [field, width] = w.place_of("weave.find");
  EXPECT_LE(text.x + size.x, field.x + width.x) << "the sentence is cut";
}

TEST_F(DeskTest, WhatIsTypedInTheListOfWeavesCanBeTypedOver) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  for (const char* key : {"ctrl+n", "w"}) {
    display_.key(key);
    ASSERT_TRUE(comes_true([&] { return w.has("weave:twill") && w.has("weave:network"); })) << key;
    display_.type("net");
    display_.type("work");
    ASSERT_TRUE(comes_true([&] { return w.has("weave:network") && !w.has("weave:twill"); })) << key;
    display_.key("ctrl+a");
    display_.type("overshot");
    EXPECT_TRUE(comes_true([&] { return w.has("weave:overshot") && !w.has("weave:network"); }))
        << key << ": it was added to the words before";
    display_.key("Escape");
    ASSERT_TRUE(comes_true([&] { return !w.has("weave.find"); })) << key;
  }
}

TEST_F(DeskTest, TheRepeatOfANewDraftIsInSightBelowManyParameters) {
  constexpr double kHeight = 460;  // of the list, and of what stands beside it
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  for (const char* weave : {"weave:plain", "weave:advancing_twill", "weave:undulating_twill"}) {
    ASSERT_NO_FATAL_FAILURE(click(w, weave));
    EXPECT_TRUE(comes_true([&] {
      const auto [text, size] = w.place_of("weave.repeat");
      return size.y > 0 && text.y + size.y <= w.place_of("weave.drawdown").first.y + kHeight + 1;
    })) << weave;
  }
}

TEST_F(DeskTest, TheSettOfANewDraftFollowsItsYarnUntilItIsTyped) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  const auto loom_sett = [&] {
    const design::Design d = design_of(w.live());
    return 10 / d.draft.warp.spacing_mm[0] * (1 - d.plan.weft_shrinkage) / (1 + d.plan.weft_take_up);
  };
  const auto yarn = [&] { return design_of(w.live()).yarns[0].name; };
  display_.key("ctrl+n");
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.yarn"));
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.yarn:Linen"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Create"));
  ASSERT_TRUE(comes_true([&] { return yarn() == "Linen"; }));
  EXPECT_NEAR(loom_sett(), 10, 0.01) << "half of 19.2 wraps in plain weave";
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave.sett") && w.has("dialog:Create"); }));
  const auto [at, size] = w.place_of("weave.sett");
  display_.click({at.x + size.x / 4, at.y + size.y / 2});
  display_.key("ctrl+a");
  display_.type("9");
  display_.key("Tab");
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.yarn"));
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.yarn:Silk"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Create"));
  ASSERT_TRUE(comes_true([&] { return yarn() == "Silk"; }));
  EXPECT_NEAR(loom_sett(), 9, 0.01) << "the typed sett was lost";
}

TEST_F(DeskTest, TheDraftKeepsItsColoursBesideADialogThatItFollows) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  // The menu bar is the same throughout.
  const auto brightness = [&] {
    const auto [at, size] = w.place_of("menu:File");
    const std::string picture = display_.picture(at, size);
    double sum = 0;
    for (const char c : picture) sum += static_cast<unsigned char>(c);
    return sum / static_cast<double>(std::max<size_t>(picture.size(), 1));
  };
  const double before = brightness();
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Create"); }));
  EXPECT_TRUE(comes_true([&] { return brightness() < 0.8 * before; }))
      << "another dialog stands before a darker window";
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Create") && brightness() > 0.99 * before; }));
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Apply"); }));
  double last = 0;
  EXPECT_TRUE(comes_true([&] {
    const double now = brightness();
    const bool still = now == last;
    last = now;
    return still;
  }));
  EXPECT_GT(last, 0.9 * before) << "the colours cannot be judged";
}

TEST_F(DeskTest, TypingFindsAWeaveByItsUse) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:twill") && w.has("dialog:Create"); }));
  display_.type("lace curtain");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:canvas") && !w.has("weave:twill"); }));
  EXPECT_TRUE(w.has("weave.unit_size")) << "the first that is found is chosen";
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog:Create"); }));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() % 10 == 0; })) << "whole repeats of huck";
}

TEST_F(DeskTest, TypingANameChoosesThatWeave) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("w");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:twill") && w.has("dialog:Apply"); }));
  display_.type("satin");
  EXPECT_TRUE(comes_true([&] {
    const std::vector<design::WeaveUse> uses = design_of(w.live()).weaves;
    return uses.size() == 1 && uses[0].weave == "satin";
  })) << "another weave, whose description speaks of satin, is woven";
}

TEST_F(DeskTest, TheLoomsLimitsHoldForAWeaveOverTheDraft) {
  design::Design d = design_of(straight_draft(24, 4));
  d.loom.shafts = d.loom.treadles = 4;
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("w");
  ASSERT_NO_FATAL_FAILURE(click(w, "weave:satin"));
  ASSERT_TRUE(comes_true([&] { return w.has("weave.refused"); })) << "nothing says that the loom cannot";
  display_.click(w.middle_of("dialog:Apply"));
  display_.key("Return");
  EXPECT_TRUE(w.has("dialog:Apply")) << "it was applied";
  EXPECT_EQ(design_of(w.live()).draft.shafts, 4);
}

TEST_F(DeskTest, ShaftsThatTakeThreadsWithThemAreNamedBeforeTheyGo) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(command(w, "size and loom"));
  ASSERT_TRUE(comes_true([&] { return w.has("size.shafts"); }));
  EXPECT_FALSE(w.has("size.lost"));
  const auto [at, size] = w.place_of("size.shafts");
  display_.click({at.x + size.x / 4, at.y + size.y / 2});
  display_.key("ctrl+a");
  display_.type("4");
  EXPECT_TRUE(comes_true([&] { return w.has("size.lost"); })) << "half of the ends lose their shaft in silence";
}

TEST_F(DeskTest, JoinsTheDraftWithAnother) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  const int ends = design_of(before).draft.ends();
  ASSERT_NO_FATAL_FAILURE(click(w, "menu:Draft"));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu.join"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type(draft_.string());
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.has("join.first"); }));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 2 * ends; })) << "the draft does not follow";
  EXPECT_GT(w.place_of("join.first").first.x, 640) << "the dialog hides the draft";
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Join"));
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Join"); }));
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == before; })) << "the join was more than one undo step";
}

TEST_F(DeskTest, TurnsTheDraftFromItsMenu) {
  design::Design d = design_of(bytes_of(draft_));
  d.draft = draft::blank_draft(12, 20, 4, 6);
  for (int i = 0; i < 12; ++i) d.draft.threading.set(i, i % 4, true);
  for (int i = 0; i < 20; ++i) d.draft.treadling.set(i, i % 6, true);
  for (int i = 0; i < 6; ++i) d.draft.tieup.set(i, i % 4, true);
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  const auto turn = [&] {
    ASSERT_NO_FATAL_FAILURE(click(w, "menu:Draft"));
    ASSERT_NO_FATAL_FAILURE(click(w, "menu.turn"));
  };
  const auto has_size = [&](int ends, int picks) {
    const draft::Draft now = design_of(w.live()).draft;
    return now.ends() == ends && now.picks() == picks;
  };
  ASSERT_NO_FATAL_FAILURE(turn());
  ASSERT_TRUE(comes_true([&] { return has_size(20, 12); })) << "the warp did not become the weft";
  const draft::Draft turned = design_of(w.live()).draft;
  EXPECT_EQ(turned.shafts, 6);
  EXPECT_EQ(turned.treadles, 4);
  const draft::BitMatrix cloth = draft::drawdown(d.draft), seen = draft::drawdown(turned);
  for (int pick = 0; pick < 20; ++pick)
    for (int end = 0; end < 12; ++end)
      ASSERT_EQ(seen.get(11 - end, pick), !cloth.get(pick, end)) << "end " << end + 1 << ", pick " << pick + 1;
  EXPECT_TRUE(comes_true([&] { return w.size_of("drawdown") == std::pair(20, 12); })) << "the grids do not follow";
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == before; })) << "the turn was more than one undo step";
}

TEST_F(DeskTest, EscapeClosesTheListAndKeepsTheDialog) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+n");
  ASSERT_NO_FATAL_FAILURE(click(w, "weave:twill"));
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.lean"));
  ASSERT_TRUE(comes_true([&] { return w.has("weave.lean:left"); }));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("weave.lean:left"); })) << "the list stays";
  ASSERT_TRUE(w.has("dialog:Create")) << "Escape threw the dialog away";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog:Create"); }));
}

TEST_F(DeskTest, ATitleIsTypedAndEntered) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(command(w, "title and notes"));
  ASSERT_TRUE(comes_true([&] { return w.has("notes.title"); }));
  display_.type("Shawl");
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return !w.has("notes.title"); })) << "Enter did not apply it";
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).title == "Shawl"; })) << "the letters went elsewhere";
}

TEST_F(DeskTest, AltAndF10OpenTheMenus) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  for (const char* key : {"F10", "Alt_L"}) {
    display_.key(key);
    ASSERT_TRUE(comes_true([&] { return w.has("menu.new"); })) << key << " opens no menu";
    display_.key("Right");
    ASSERT_TRUE(comes_true([&] { return w.has("menu.undo") && !w.has("menu.new"); })) << "Right opens the next menu";
    display_.key("Escape");
    ASSERT_TRUE(comes_true([&] { return !w.has("menu.undo"); }));
  }
  // Left goes back, and round from the first to the last.
  display_.key("F10 Right Right");
  ASSERT_TRUE(comes_true([&] { return w.has("menu.notes"); }));
  display_.key("Left");
  ASSERT_TRUE(comes_true([&] { return w.has("menu.undo") && !w.has("menu.notes"); })) << "Left opens the one before";
  display_.key("Left Left");
  ASSERT_TRUE(comes_true([&] { return w.has("menu.tour"); })) << "and goes round";
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("menu.tour"); }));
  // Return runs the first item and closes the menu.
  display_.key("F10 Right Right Right");
  ASSERT_TRUE(comes_true([&] { return w.has("menu.zoom_in"); }));
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("menu.zoom_in"); })) << "Enter runs the first item";
}

TEST_F(DeskTest, ARatioThatCannotBeReadMakesNoDraft) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  display_.key("ctrl+n");
  ASSERT_NO_FATAL_FAILURE(click(w, "weave:twill"));
  ASSERT_NO_FATAL_FAILURE(click(w, "weave.ratio"));
  display_.key("ctrl+a");
  display_.type("3/x");
  ASSERT_TRUE(comes_true([&] { return w.has("weave.refused"); })) << "3/x was mended in silence";
  display_.click(w.middle_of("dialog:Create"));
  EXPECT_TRUE(w.has("dialog:Create"));
  EXPECT_EQ(w.live(), before);
  display_.click(w.middle_of("weave.ratio"));
  display_.key("ctrl+a");
  display_.type("3/1");
  ASSERT_TRUE(comes_true([&] { return !w.has("weave.refused"); }));
  display_.click(w.middle_of("dialog:Create"));
  EXPECT_TRUE(comes_true([&] { return w.live() != before && w.has("grazing"); })) << "its threads are shown flat";
}

TEST_F(DeskTest, ThePaletteSaysWhenNothingFitsAndWhatACommandNeeds) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+p");
  ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); }));
  display_.type("xyzzy");
  EXPECT_TRUE(comes_true([&] { return w.has("commands.none"); }));
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("commands.typed"); }));
  display_.key("ctrl+p");
  ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); }));
  display_.type("rotate");
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return w.has("commands.why"); })) << "without a selection it cannot rotate";
  EXPECT_TRUE(w.has("commands.typed")) << "it closed without a word";
}

TEST_F(DeskTest, TheViewsOfTheClothAreReachableInASmallWindow) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.resize(900, 600);
  ASSERT_TRUE(comes_true([&] { return w.place_of("view").second.x < 560; }));
  for (const char* control : {"views", "hanging:Drape", "hanging:Flat"})
    EXPECT_TRUE(comes_true([&] { return w.has(control); })) << control;
  ASSERT_NO_FATAL_FAILURE(click(w, "hanging:Flat"));
  EXPECT_TRUE(comes_true([&] { return w.has("grazing"); }));
}

TEST_F(DeskTest, ADialogAsHighAsTheWindowIsAllSeen) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.resize(1000, 640);
  ASSERT_TRUE(comes_true([&] { return w.place_of("view").second.x < 700; }));
  display_.key("ctrl+e");
  ASSERT_TRUE(comes_true([&] { return w.has("export.for:gltf") && w.has("dialog:Export"); }));
  constexpr double kTitle = 40;  // stands over the first row
  EXPECT_TRUE(comes_true([&] { return w.place_of("export.for:gltf").first.y >= kTitle; }));
  EXPECT_LE(w.place_of("dialog:Export").first.y + w.place_of("dialog:Export").second.y, 640);
}

TEST_F(DeskTest, TheMapComesWithTheScrollAndGoes) {
  show_cloth();
  put(draft_, straight_draft(400, 8));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return is_settled(w); })) << "as long as the cloth is drawn, so is the map";
  display_.move(w.cell("drawdown", 3, 3));
  for (int i = 0; i < 4; ++i) display_.key("ctrl+plus");
  ASSERT_TRUE(comes_true([&] { return w.has("minimap"); }));
  EXPECT_TRUE(comes_true([&] { return !w.has("minimap"); })) << "it hides the cells below it";
}

TEST_F(DeskTest, AnotherClothIsNotShownInPlaceOfTheOneToCome) {
  show_cloth();
  design::Design d = design_of(straight_draft(900, 16));
  unsigned seed = 1;
  for (int end = 0; end < 900; ++end) {
    for (int shaft = 0; shaft < 16; ++shaft) d.draft.threading.set(end, shaft, false);
    d.draft.threading.set(end, static_cast<int>((seed = seed * 1664525u + 1013904223u) >> 28), true);
  }
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("view.picture"); }));
  display_.focus();
  display_.key("f");
  EXPECT_TRUE(comes_true([&] { return !w.has("view.picture"); }))
      << "the drape is shown under the camera of the swatch";
  EXPECT_TRUE(comes_true([&] { return w.has("view.picture"); }));
}

TEST_F(DeskTest, PrintsOnTheSystemsPrinter) {
  const std::filesystem::path programs = folder_ / "bin", job = folder_ / "job";
  std::filesystem::create_directories(programs);
  put(programs / "lp", "#!/bin/sh\nfor word; do last=$word; done\necho \"$@\" > " + job.string() +
                           ".words\n/bin/cp \"$last\" " + job.string() + "\n");
  std::filesystem::permissions(programs / "lp", std::filesystem::perms::owner_all);
  Window w(display_, folder_, draft_, {"PATH=" + programs.string()});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+shift+p");
  ASSERT_TRUE(comes_true([&] { return w.has("print.ready"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "print.extent:One repeat"));
  ASSERT_NO_FATAL_FAILURE(click(w, "dialog:Print"));
  ASSERT_TRUE(comes_true([&] { return w.has("message"); })) << "nothing is said";
  EXPECT_TRUE(comes_true([&] { return bytes_of(job).starts_with("%PDF"); }));
  EXPECT_NE(bytes_of(job.string() + ".words").find("media=A4"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::gui
