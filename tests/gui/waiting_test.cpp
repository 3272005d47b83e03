// The window never waits: it draws and paints while a file is written to a slow disk, or another program holds a lock.

#include <algorithm>

#include "on_display.h"
#include "platform/file_lock.h"

namespace weftlight::gui {

namespace {

namespace fs = std::filesystem;

class WaitingTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (folder_.empty()) return;
    fs::create_directory(folder_ / "slow");
    draft_ = folder_ / "slow/straight.wif";
    put(draft_, straight_draft());
    original_ = bytes_of(draft_);
  }
  /// Writing in the folder of the draft does not end until disk_ends().
  std::vector<std::string> on_a_slow_disk() const {
    std::vector<std::string> environment = without_dialogs();
    environment.push_back(std::string("LD_PRELOAD=") + WEFTLIGHT_SLOW_DISK_LIBRARY);
    environment.push_back("WEFTLIGHT_SLOW_DISK=" + gate().string());
    return environment;
  }
  /// It answers nothing at all while it hangs.
  std::vector<std::string> on_a_dead_disk() const {
    std::vector<std::string> environment = on_a_slow_disk();
    environment.emplace_back("WEFTLIGHT_DEAD_DISK=1");
    return environment;
  }
  fs::path gate() const { return folder_ / "slow/busy"; }
  void disk_hangs() const { put(gate(), ""); }
  void disk_ends() const { fs::remove(gate()); }
  /// Presses Ctrl+S and waits until the window says that it saves.
  void save(const Window& w) const {
    display_.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return w.has("task"); })) << "nothing tells that the draft is being saved";
    EXPECT_FALSE(w.has("task.cancel")) << "half a save is none";
    EXPECT_EQ(bytes_of(draft_), original_);
  }
  /// Of the window, which tells nothing of its controls while the draft that it starts with is opened.
  void wait_for_a_picture() const {
    ASSERT_TRUE(comes_true([&] {
      return display_.picture({0, 0}, {1280, 800}).find_first_not_of('\0', 20) != std::string::npos;
    })) << "there is no first frame";
  }
  void type_path(const Window& w, const fs::path& path) const {
    display_.key("ctrl+o");
    ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
    display_.key("ctrl+a");
    display_.type(path.string());
    display_.key("Return");
  }
  /// Opens the draft and waits until the window says so.
  void open_slowly(const Window& w) const {
    ASSERT_NO_FATAL_FAILURE(type_path(w, draft_));
    ASSERT_TRUE(comes_true([&] { return w.has("task.cancel"); })) << "nothing tells that the draft is being opened";
  }
  void cancel_opening(const Window& w) const {
    display_.click(w.middle_of("task.cancel"));
    ASSERT_TRUE(comes_true([&] { return !w.has("task"); }));
  }
  /// Another end on shaft 3, and another frame for it.
  void paint_on(const Window& w, int end) const {
    ASSERT_NO_FATAL_FAILURE(paint(w, end));
    // The inspector goes and comes back.
    for (int i = 0; i < 2; ++i) {
      const int frame = w.frame();
      display_.key("F4");
      ASSERT_TRUE(comes_true([&] { return w.frame() > frame; })) << "no frame was drawn";
    }
  }

  std::string original_;
};

TEST_F(WaitingTest, PaintingGoesOnWhileADraftIsSaved) {
  Window w(display_, folder_, draft_, on_a_slow_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  const std::string first = w.live();
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(save(w));
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 4));
  const std::string last = w.live();
  EXPECT_EQ(bytes_of(draft_), original_);
  disk_ends();
  EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) == first; })) << "the draft as it was when it was saved";
  EXPECT_TRUE(comes_true([&] { return !w.has("task"); }));
  EXPECT_EQ(w.live(), last) << "what was painted since is kept";
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Do not save"); })) << "it is not saved yet";
  display_.click(w.middle_of("dialog:Save"));
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(bytes_of(draft_), last);
}

TEST_F(WaitingTest, OfTwoSavesTheNewestIsOnTheDisk) {
  Window w(display_, folder_, draft_, on_a_slow_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(save(w));
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
  display_.key("ctrl+s");
  const std::string last = w.live();
  disk_ends();
  EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) == last; }));
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0) << "nothing is left to save";
}

TEST_F(WaitingTest, QuittingWaitsForTheSaveAndSaysSo) {
  Window w(display_, folder_, draft_, on_a_slow_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w, 1));
  const std::string mine = w.live();
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(save(w));
  display_.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return w.has("task.awaited"); })) << "nothing tells what the window waits for";
  EXPECT_TRUE(w.process().is_running());
  EXPECT_EQ(bytes_of(draft_), original_);
  disk_ends();
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(bytes_of(draft_), mine);
}

TEST_F(WaitingTest, AKillDuringASaveLosesNothing) {
  std::string lost;
  {
    Window w(display_, folder_, draft_, on_a_slow_disk());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_NO_FATAL_FAILURE(paint(w, 1));
    disk_hangs();
    ASSERT_NO_FATAL_FAILURE(save(w));
    ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
    lost = w.live();
    kill_once_kept(w);
  }
  disk_ends();
  EXPECT_EQ(bytes_of(draft_), original_);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Recover"));
  EXPECT_TRUE(comes_true([&] { return w.live() == lost; }));
}

TEST_F(WaitingTest, PaintingGoesOnWhileADraftIsOpened) {
  const fs::path mine = folder_ / "mine.wif";
  put(mine, straight_draft());
  Window w(display_, folder_, mine, on_a_slow_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(open_slowly(w));
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 1));
  ASSERT_NO_FATAL_FAILURE(cancel_opening(w));
  ASSERT_NO_FATAL_FAILURE(open_slowly(w));
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
  EXPECT_NE(w.live(), original_);
  disk_ends();
  EXPECT_TRUE(comes_true([&] { return w.live() == original_; })) << "it is not shown";
}

TEST_F(WaitingTest, AReadThatHangsKeepsNeitherAnotherNorTheEndOfTheProgram) {
  const fs::path mine = folder_ / "mine.wif", other = folder_ / "other.wif";
  put(mine, straight_draft());
  put(other, original_);
  Window w(display_, folder_, mine, on_a_slow_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(open_slowly(w));
  ASSERT_NO_FATAL_FAILURE(cancel_opening(w));
  ASSERT_NO_FATAL_FAILURE(type_path(w, other));
  EXPECT_TRUE(comes_true([&] { return w.has("tab.shown:2"); })) << "a draft elsewhere is not opened";
  EXPECT_FALSE(w.has("task"));
  display_.key("ctrl+q");
  EXPECT_TRUE(comes_true([&] { return !w.process().is_running(); })) << "quitting waits for the disk";
  disk_ends();
  EXPECT_EQ(w.process().wait(), 0);
}

TEST_F(WaitingTest, AShareThatAnswersNothingKeepsNeitherTheWindowNorOtherDrafts) {
  const fs::path other = folder_ / "other.wif", beside = folder_ / "beside.wif";
  put(other, original_);
  Window w(display_, folder_, draft_, on_a_dead_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  disk_hangs();
  ASSERT_NO_FATAL_FAILURE(type_path(w, draft_)) << "it is open, and looked at";
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 1));
  ASSERT_NO_FATAL_FAILURE(type_path(w, other));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.shown:2"); })) << "a draft elsewhere is not opened";
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
  display_.key("ctrl+shift+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type(beside.string());
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return fs::exists(beside); })) << "a draft elsewhere is not saved";
  disk_ends();
}

TEST_F(WaitingTest, WhatAShareHoldsAlreadyIsAskedBesideTheWindow) {
  const fs::path mine = folder_ / "mine.wif";
  put(mine, original_);
  Window w(display_, folder_, mine, on_a_dead_disk());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  disk_hangs();
  // Whether a save would replace a file.
  display_.key("ctrl+shift+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type((folder_ / "slow/new.wif").string());
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.has("task.cancel"); })) << "nothing tells that the share is asked";
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 1));
  ASSERT_NO_FATAL_FAILURE(cancel_opening(w));
  // What is in the folder of an export.
  display_.key("ctrl+e");
  ASSERT_TRUE(comes_true([&] { return w.has("export.ready"); }));
  display_.click(w.middle_of("export.folder"));
  display_.key("ctrl+a");
  display_.type((folder_ / "slow/sets").string());
  display_.click(w.middle_of("dialog:Export"));
  display_.click(w.middle_of("dialog:Close"));
  EXPECT_TRUE(comes_true([&] { return !w.has("export.folder"); })) << "the dialog waits for the share";
  ASSERT_NO_FATAL_FAILURE(paint_on(w, 2));
  EXPECT_FALSE(fs::exists(folder_ / "slow/sets"));
  disk_ends();
}

TEST_F(WaitingTest, QuittingDoesNotWaitForADraftThatIsBeingOpened) {
  disk_hangs();
  Window w(display_, folder_, draft_, on_a_slow_disk());
  ASSERT_NO_FATAL_FAILURE(wait_for_a_picture());
  display_.key("ctrl+q");
  EXPECT_TRUE(comes_true([&] { return !w.process().is_running(); })) << "quitting waits for the disk";
  disk_ends();
  EXPECT_EQ(w.process().wait(), 0);
}

TEST_F(WaitingTest, AWindowComesBeforeASlowFile) {
  show_cloth();
  disk_hangs();
  Window w(display_, folder_, draft_, on_a_slow_disk());
  ASSERT_NO_FATAL_FAILURE(wait_for_a_picture());
  EXPECT_FALSE(w.is_ready()) << "programs that drive the window are told of the file alone";
  disk_ends();
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_EQ(w.live(), original_);
}

TEST_F(WaitingTest, AnotherProgramsLockDoesNotKeepTheWindowAway) {
  const fs::path recovery = folder_ / "state/weftlight/recovery";
  fs::create_directories(recovery);
  const auto held = platform::FileLock::take((recovery / "lock").string());
  ASSERT_TRUE(held.held());
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); })) << "there is no first frame";
  ASSERT_NO_FATAL_FAILURE(paint(w));
  const auto journals = [&] {
    std::error_code ignored;
    return std::ranges::count_if(fs::recursive_directory_iterator(recovery, ignored),
                                 [](const auto& entry) { return entry.path().extension() == ".journal"; });
  };
  EXPECT_TRUE(comes_true([&] { return journals() == 1; })) << "the work is not kept";
}

}  // namespace
}  // namespace weftlight::gui
