// Several drafts in one window: each in its tab, none lost.

#include "on_display.h"

namespace weftlight::gui {

using design::Design, design::with_threading;
namespace {

namespace fs = std::filesystem;

class TabsTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    other_ = folder_ / "other.wif";
    put(other_, straight_draft(20, 4));
  }
  void open(const Window& w, const fs::path& file) const {
    display_.key("ctrl+o");
    ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
    display_.key("ctrl+a");
    display_.type(file.string());
    display_.key("Return");
    ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));
  }
  /// A window with both files open, the other one shown.
  void open_both(const Window& w) const {
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    EXPECT_FALSE(w.has("tab:1")) << "one draft needs no tabs";
    ASSERT_NO_FATAL_FAILURE(open(w, other_));
    ASSERT_TRUE(comes_true([&] { return w.has("tab.shown:2") && w.live() == bytes_of(other_); }))
        << "no tab was opened";
  }

  fs::path other_;
};

TEST_F(TabsTest, EachFileOfTheCommandLineIsOpenedAndWhatCannotBeOpenedIsTold) {
  Window w(display_, folder_, draft_, {}, {}, {folder_ / "none.wif", other_});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_TRUE(comes_true([&] { return w.has("tab.shown:2") && w.live() == bytes_of(other_); })) << "the last in front";
  EXPECT_TRUE(comes_true([&] { return w.has("message.refusal") && w.has("remarks.panel"); })) << "none.wif is not told";
  EXPECT_FALSE(w.has("tab:3"));
  display_.click(w.middle_of("tab:1"));
  EXPECT_TRUE(comes_true([&] { return w.live() == bytes_of(draft_); }));
}

TEST_F(TabsTest, EachHasItsOwnWorkAndQuittingAsksOnceForAll) {
  const std::string one = bytes_of(draft_), two = bytes_of(other_);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_NO_FATAL_FAILURE(open_both(w));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  const std::string two_painted = w.live();
  EXPECT_TRUE(comes_true([&] { return w.has("tab.unsaved:2") && !w.has("tab.unsaved:1"); }));
  display_.key("ctrl+Tab");
  EXPECT_TRUE(comes_true([&] { return w.live() == one && w.has("tab.shown:1"); })) << "the first is shown, unchanged";
  ASSERT_NO_FATAL_FAILURE(paint(w, 2));
  const std::string one_painted = w.live();
  display_.key("ctrl+shift+Tab");
  EXPECT_TRUE(comes_true([&] { return w.live() == two_painted; }));
  display_.click(w.middle_of("tab:1"));
  EXPECT_TRUE(comes_true([&] { return w.live() == one_painted; }));
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == one; })) << "undo is of the draft that is shown";
  display_.key("ctrl+shift+z");
  ASSERT_TRUE(comes_true([&] { return w.live() == one_painted; }));
  ASSERT_NO_FATAL_FAILURE(open(w, other_));
  EXPECT_TRUE(comes_true([&] { return w.live() == two_painted; })) << "a draft that is open is shown";
  EXPECT_FALSE(w.has("tab:3"));

  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Save all"); }));
  display_.click(w.middle_of("dialog:Save all"));
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(bytes_of(draft_), one_painted);
  EXPECT_EQ(bytes_of(other_), two_painted);
}

TEST_F(TabsTest, CopyInOneAndPasteInAnother) {
  // Of the same size, so that a cell has the same position in both.
  Design ground = design_of(straight_draft());
  for (int end = 0; end < 24; ++end) ground = with_threading(ground, end, 7 - end % 8, true);
  put(other_, wif::write_new_wif(ground));
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_NO_FATAL_FAILURE(open_both(w));
  display_.key("ctrl+Tab");
  ASSERT_TRUE(comes_true([&] { return w.live() == bytes_of(draft_); }));
  display_.click(w.middle_of("tool:Select"));
  display_.drag({w.cell("threading", 1, 1), w.cell("threading", 3, 3), w.cell("threading", 4, 4)});
  display_.key("ctrl+c");
  display_.key("ctrl+Tab");
  ASSERT_TRUE(comes_true([&] { return w.live() == bytes_of(other_); }));
  display_.key("ctrl+v");
  display_.click(w.cell("threading", 6, 1));
  Design pasted = ground;
  for (int end = 5; end < 9; ++end) pasted = with_threading(pasted, end, end - 5, true);
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft == pasted.draft; }));
}

TEST_F(TabsTest, ClosingAsksOnlyForWhatIsUnsaved) {
  const std::string one = bytes_of(draft_);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_NO_FATAL_FAILURE(open_both(w));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  display_.key("ctrl+w");
  ASSERT_NO_FATAL_FAILURE(press(w, "Cancel"));
  EXPECT_TRUE(w.has("tab:2"));
  display_.click(w.middle_of("tab.close:2"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Do not save"));
  EXPECT_TRUE(comes_true([&] { return !w.has("tab:1") && w.live() == one; })) << "one draft is left, without tabs";
  EXPECT_EQ(bytes_of(other_), straight_draft(20, 4));

  ASSERT_NO_FATAL_FAILURE(open(w, other_));
  ASSERT_TRUE(comes_true([&] { return w.has("tab:2"); }));
  display_.middle_click(w.middle_of("tab:1"));
  EXPECT_TRUE(comes_true([&] { return !w.has("tab:1") && w.live() == bytes_of(other_); }));
  display_.key("ctrl+w");
  EXPECT_TRUE(comes_true([&] { return w.live() != bytes_of(other_); }))
      << "after the last one the start draft is shown";
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
}

TEST_F(TabsTest, AKilledWindowOffersAllOfThem) {
  std::string one, two;
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_NO_FATAL_FAILURE(open_both(w));
    ASSERT_NO_FATAL_FAILURE(paint(w, 1));
    two = w.live();
    wait_until_kept();
    display_.key("ctrl+Tab");
    ASSERT_TRUE(comes_true([&] { return w.live() == bytes_of(draft_) && w.has("tab.shown:1"); }));
    ASSERT_NO_FATAL_FAILURE(paint(w, 2));
    one = w.live();
    kill_once_kept(w);
  }
  Window w(display_, folder_, {}, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Recover all"));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.unsaved:1") && w.has("tab.unsaved:2"); }));
  EXPECT_TRUE(comes_true([&] { return w.live() == one; })) << "the newest is shown";
  display_.key("ctrl+Tab");
  EXPECT_TRUE(comes_true([&] { return w.live() == two; }));
}

TEST_F(TabsTest, ARightClickOpensTheMenuOfATab) {
  const std::string one = bytes_of(draft_), two = bytes_of(other_);
  // A script in place of the desktop's xdg-open records its arguments.
  put(folder_ / "xdg-open", "#!/bin/sh\nprintf %s \"$1\" > '" + (folder_ / "opened").string() + "'\n");
  fs::permissions(folder_ / "xdg-open", fs::perms::owner_all);
  Window w(display_, folder_, draft_, {"PATH=" + folder_.string()});
  ASSERT_NO_FATAL_FAILURE(open_both(w));
  const auto choose = [&](const std::string& tab, const std::string& item) {
    display_.right_click(w.middle_of(tab));
    ASSERT_TRUE(comes_true([&] { return w.has("tab_menu." + item); })) << tab << " has no menu";
    display_.click(w.middle_of("tab_menu." + item));
    ASSERT_TRUE(comes_true([&] { return !w.has("tab_menu." + item); }));
  };
  ASSERT_NO_FATAL_FAILURE(choose("tab:1", "show_in_folder"));
  EXPECT_TRUE(comes_true([&] { return bytes_of(folder_ / "opened") == folder_.string(); }));
  EXPECT_TRUE(comes_true([&] { return w.has("tab.shown:1") && w.live() == one; })) << "the menu is about its tab";

  ASSERT_NO_FATAL_FAILURE(choose("tab:2", "duplicate"));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.shown:3") && w.has("tab.unsaved:3"); }));
  EXPECT_EQ(design_of(w.live()), design_of(two));
  display_.key("ctrl+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); })) << "a duplicate has no file yet";
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));

  // Another program writes the file of the first draft, which has unsaved changes.
  display_.click(w.middle_of("tab:1"));
  ASSERT_TRUE(comes_true([&] { return w.live() == one; }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  ASSERT_NO_FATAL_FAILURE(choose("tab:1", "reload"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Reload"); }));
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Reload"); }));
  EXPECT_NE(w.live(), one) << "Enter threw the changes away";
  ASSERT_NO_FATAL_FAILURE(choose("tab:1", "reload"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Reload"));
  EXPECT_TRUE(comes_true([&] { return w.live() == one; }));

  ASSERT_NO_FATAL_FAILURE(choose("tab:2", "close_right"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Cancel"));
  EXPECT_TRUE(w.has("tab:3")) << "the duplicate is not saved";
  ASSERT_NO_FATAL_FAILURE(choose("tab:2", "close_right"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Do not save"));
  ASSERT_TRUE(comes_true([&] { return !w.has("tab:3") && w.has("tab:2"); }));
  ASSERT_NO_FATAL_FAILURE(choose("tab:2", "close_others"));
  EXPECT_TRUE(comes_true([&] { return !w.has("tab:1") && w.live() == two; })) << "one draft needs no tabs";
}

TEST_F(TabsTest, ItsMenuSavesAndCopiesThePath) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_NO_FATAL_FAILURE(open_both(w));
  ASSERT_NO_FATAL_FAILURE(paint(w));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.unsaved:2"); }));
  const auto choose = [&](const std::string& tab, const std::string& item) {
    display_.right_click(w.middle_of(tab));
    ASSERT_TRUE(comes_true([&] { return w.has("tab_menu." + item); })) << tab << " has no " << item;
    display_.click(w.middle_of("tab_menu." + item));
    ASSERT_TRUE(comes_true([&] { return !w.has("tab_menu." + item); }));
  };
  ASSERT_NO_FATAL_FAILURE(choose("tab:2", "save"));
  EXPECT_TRUE(comes_true([&] { return !w.has("tab.unsaved:2") && bytes_of(other_) == w.live(); }));
  ASSERT_NO_FATAL_FAILURE(choose("tab:1", "copy_path"));
  ASSERT_NO_FATAL_FAILURE(choose("tab:1", "close"));
  ASSERT_TRUE(comes_true([&] { return !w.has("tab:2") && w.live() == bytes_of(other_); }));
  // The copied path opens it again.
  display_.key("ctrl+o");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a ctrl+v Return");
  EXPECT_TRUE(comes_true([&] { return w.has("tab.shown:2") && w.live() == bytes_of(draft_); }));
}

TEST_F(TabsTest, ADraftWithoutAFileIsCalledTheSameInItsTabAndOverTheGrids) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const auto heading = [&] { return w.name_after("draft.heading:"); };
  EXPECT_EQ(heading(), "straight.wif");
  for (const char* name : {"Untitled", "Untitled 2"}) {
    display_.key("ctrl+n");
    ASSERT_NO_FATAL_FAILURE(press(w, "Create"));
    EXPECT_TRUE(comes_true([&] { return heading() == name; })) << heading();
  }
}

TEST_F(TabsTest, TheHistoryGoesToAnyStep) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  std::vector<std::string> states{w.live()};
  for (int end = 1; end <= 3; ++end) {
    ASSERT_NO_FATAL_FAILURE(paint(w, end == 3 ? 4 : end));  // end 3 is on shaft 3 already
    states.push_back(w.live());
  }
  display_.key("ctrl+h");
  ASSERT_TRUE(comes_true([&] { return w.has("history:3"); }));
  display_.click(w.middle_of("history:1"));
  EXPECT_TRUE(comes_true([&] { return w.live() == states[1]; }));
  EXPECT_TRUE(w.has("history:3")) << "later steps are still there";
  display_.click(w.middle_of("history:3"));
  EXPECT_TRUE(comes_true([&] { return w.live() == states[3]; }));
  display_.click(w.middle_of("history:0"));
  EXPECT_TRUE(comes_true([&] { return w.live() == states[0]; })) << "to the byte";
  display_.key("ctrl+h");
  EXPECT_TRUE(comes_true([&] { return !w.has("history:0"); }));
}

TEST_F(TabsTest, EscapeLeavesTheTourWhichIsNotShownAtTheLoom) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu:Help"));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu.tour"));
  ASSERT_TRUE(comes_true([&] { return w.has("tour.next"); }));
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.next"); }));
  EXPECT_TRUE(comes_true([&] { return !w.has("tour.next"); })) << "its card hides a part of the loom view";
  display_.key("Escape");
  ASSERT_TRUE(comes_true([&] { return w.has("tour.next"); })) << "Escape was for the loom view";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("tour.next"); })) << "Escape does not leave the tour";
}

TEST_F(TabsTest, TheTourDoesNotBlockTheWindow) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_FALSE(w.has("tour.next")) << "no tour if flags drive the window";
  display_.click(w.middle_of("menu:Help"));
  ASSERT_TRUE(comes_true([&] { return w.has("menu.tour"); }));
  display_.click(w.middle_of("menu.tour"));
  ASSERT_TRUE(comes_true([&] { return w.has("tour.next"); }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  for (int step = 1; step < 5; ++step) {
    const Point before = w.middle_of("tour.next");
    display_.click(before);
    ASSERT_TRUE(comes_true([&] {
      const Point now = w.middle_of("tour.next");
      return now.x != before.x || now.y != before.y;
    })) << "step "
        << step;
  }
  display_.click(w.middle_of("tour.next"));
  EXPECT_TRUE(comes_true([&] { return !w.has("tour.next"); }));
  display_.key("ctrl+s");
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_NE(bytes_of(folder_ / "config/weftlight/settings.json").find("\"toured\": true"), std::string::npos);
}

TEST_F(TabsTest, TypingSearchesTheShortcutsAtOnce) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  display_.key("F1");
  ASSERT_TRUE(comes_true([&] { return w.has("key:history") && w.has("key:save"); }));
  display_.type("history");
  EXPECT_TRUE(comes_true([&] { return w.has("key:history") && !w.has("key:save"); })) << "the letters went elsewhere";
  EXPECT_EQ(w.live(), before);
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("keys.typed"); })) << "Escape leaves the window open";
}

TEST_F(TabsTest, ShortcutsCanBeChangedAndAreSaved) {
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    display_.key("F1");
    ASSERT_TRUE(comes_true([&] { return w.has("key:history"); }));
    display_.click(w.middle_of("keys.typed"));
    display_.type("history");
    ASSERT_TRUE(comes_true([&] { return !w.has("key:save"); })) << "filtered by typing";
    display_.click(w.middle_of("key:history"));
    display_.key("ctrl+z");
    ASSERT_TRUE(comes_true([&] { return w.has("key.take"); })) << "no notice that another command has the key";
    display_.key("ctrl+u");
    ASSERT_TRUE(comes_true([&] { return w.has("keys.shipped"); })) << "nothing was changed";
    display_.key("ctrl+u");
    EXPECT_TRUE(comes_true([&] { return w.has("history:0"); })) << "the new key does nothing";
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+h");
  display_.key("ctrl+u");
  EXPECT_TRUE(comes_true([&] { return w.has("history:0"); })) << "the old key does nothing, the new one was kept";
}

TEST_F(TabsTest, AWifwIsOpenedAndSavedUnderItsName) {
  const fs::path mac = folder_ / "scarf.wifw", copy = folder_ / "shawl.wifw";
  put(mac, straight_draft(20, 4));
  Window w(display_, folder_, mac, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  display_.key("ctrl+s");
  EXPECT_TRUE(comes_true([&] { return bytes_of(mac) == w.live(); }));
  display_.key("ctrl+shift+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type(copy.string());
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return bytes_of(copy) == w.live(); })) << "saved under another name";
}

}  // namespace
}  // namespace weftlight::gui
