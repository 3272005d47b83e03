// Files that changed or vanished meanwhile, that cannot be written, or that belong to another window.

#include <sys/resource.h>

#include "../program.h"
#include "on_display.h"

namespace weftlight::gui {

namespace {

namespace fs = std::filesystem;

using FilesTest = OnDisplay;

TEST_F(FilesTest, ChangesByAnotherProgramAreNotOverwritten) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w));
  const std::string mine = w.live(), theirs = straight_draft(30, 4);
  put(draft_, theirs);
  display_.key("ctrl+s");
  ASSERT_NO_FATAL_FAILURE(press(w, "Save a copy\xE2\x80\xA6"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return bytes_of(folder_ / "straight-2.wif") == mine; }));
  EXPECT_EQ(bytes_of(draft_), theirs);
}

TEST_F(FilesTest, ChangesByAnotherProgramCanBeReloadedOrReplaced) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w));
  const std::string mine = w.live(), theirs = straight_draft(30, 4);
  put(draft_, theirs);
  display_.key("ctrl+s");
  ASSERT_NO_FATAL_FAILURE(press(w, "Keep mine"));
  EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) == mine; }));
  // Also noticed when the window gets the focus.
  put(draft_, theirs);
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(press(w, "Reload"));
  EXPECT_TRUE(comes_true([&] { return w.live() == theirs; }));
}

TEST_F(FilesTest, TwoWindowsOnOneFile) {
  const fs::path other = folder_ / "other";
  fs::create_directory(other);
  Window one(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return one.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(one));
  std::string theirs;
  {
    const Display beside(1280, 800);
    Window two(beside, other, draft_);
    ASSERT_TRUE(comes_true([&] { return two.is_ready(); }));
    const std::string before = two.live();
    beside.click(two.cell("threading", 2, 5));
    ASSERT_TRUE(comes_true([&] { return two.live() != before; }));
    theirs = two.live();
    beside.key("ctrl+s");
    ASSERT_TRUE(comes_true([&] { return bytes_of(draft_) == theirs; }));
  }
  display_.key("ctrl+s");
  ASSERT_TRUE(comes_true([&] { return one.has("dialog:Reload"); })) << "saved over the other window's work";
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !one.has("dialog:Reload"); }));
  EXPECT_EQ(bytes_of(draft_), theirs) << "cancelling saves nothing";
}

TEST_F(FilesTest, EscapeClosesTheMessagesAboutAFileAfterWhatItCancelsInTheDraft) {
  put(draft_, straight_draft() + "\n[STRANGE]\nno equals sign\n");
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "remarks"));
  ASSERT_TRUE(comes_true([&] { return w.has("remarks.panel"); }));
  display_.key("Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("remarks.panel"); }));
}

TEST_F(FilesTest, SaveAsAsksBeforeItReplaces) {
  const fs::path taken = folder_ / "taken.wif";
  put(taken, "somebody's work");
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const auto save_as = [&] {
    display_.key("ctrl+shift+s");
    ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
    display_.key("ctrl+a");
    display_.type(taken.string());
    display_.key("Return");
  };
  ASSERT_NO_FATAL_FAILURE(save_as());
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Replace"); })) << "replaced without a question";
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog:Replace"); }));
  EXPECT_EQ(bytes_of(taken), "somebody's work") << "Enter replaced it";
  ASSERT_NO_FATAL_FAILURE(save_as());
  ASSERT_NO_FATAL_FAILURE(press(w, "Cancel"));
  EXPECT_EQ(bytes_of(taken), "somebody's work");
  ASSERT_NO_FATAL_FAILURE(save_as());
  ASSERT_NO_FATAL_FAILURE(press(w, "Replace"));
  EXPECT_TRUE(comes_true([&] { return bytes_of(taken) == w.live(); }));
}

/// A kdialog script that records its arguments and prints a prepared answer, or that it has none.
TEST_F(FilesTest, KdialogAsksOnItsDesktop) {
  const fs::path other = folder_ / "other.wif", saved = folder_ / "kept here.wif";
  put(other, straight_draft(20, 4));
  put(folder_ / "kdialog", "#!/bin/sh\nfor word; do echo \"$word\"; done >> '" + (folder_ / "asked").string() +
                               "'\nread -r answer < '" + (folder_ / "answer").string() + "' || { echo cancelled >> '" +
                               (folder_ / "asked").string() + "'; exit 1; }\necho \"$answer\"\n");
  put(folder_ / "zenity", "#!/bin/sh\nexit 1\n");
  for (const char* program : {"kdialog", "zenity"}) fs::permissions(folder_ / program, fs::perms::owner_all);
  Window w(display_, folder_, draft_, {"PATH=" + folder_.string(), "XDG_CURRENT_DESKTOP=KDE"});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const auto asked = [&](const std::string& word) {
    return bytes_of(folder_ / "asked").find(word) != std::string::npos;
  };

  put(folder_ / "answer", other.string() + "\n");
  display_.key("ctrl+o");
  ASSERT_TRUE(comes_true([&] { return asked("--getopenfilename\n"); }));
  EXPECT_TRUE(comes_true([&] { return w.live() == bytes_of(other); })) << "the chosen file was not opened";
  EXPECT_TRUE(asked("Weaving drafts (*.wif"));

  put(folder_ / "answer", saved.string() + "\n");
  ASSERT_NO_FATAL_FAILURE(paint(w));
  display_.key("ctrl+shift+s");
  ASSERT_TRUE(comes_true([&] { return asked("--getsavefilename\n"); }));
  EXPECT_TRUE(comes_true([&] { return bytes_of(saved) == w.live(); })) << "it was not saved at the chosen path";

  // Cancelled: nothing happens, and the dialog can be opened again.
  fs::remove(folder_ / "answer");
  fs::remove(folder_ / "asked");
  const std::string before = w.live();
  display_.key("ctrl+o");
  ASSERT_TRUE(comes_true([&] { return asked("cancelled\n"); }));
  put(folder_ / "answer", draft_.string() + "\n");
  display_.move(w.cell("drawdown", 3, 2));  // drawn once it knows
  EXPECT_EQ(w.live(), before);
  // As long as it does not know that the dialog is gone, it opens no other.
  EXPECT_TRUE(comes_true([&] {
    display_.key("ctrl+o");
    return w.live() == bytes_of(draft_);
  }));
}

TEST_F(FilesTest, SavesThroughALink) {
  const fs::path link = folder_ / "link.wif";
  fs::create_symlink(draft_, link);
  Window w(display_, folder_, link, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w));
  display_.key("ctrl+s");
  EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) == w.live(); }));
  EXPECT_TRUE(fs::is_symlink(link));
}

TEST_F(FilesTest, APictureIsWovenInItsDialog) {
  std::string picture = "P6\n40 20\n255\n";
  for (int i = 0; i < 40 * 20; ++i) picture.append(3, i % 40 < 10 ? '\0' : '\xff');
  put(folder_ / "stripe.ppm", picture);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.click(w.middle_of("menu:Draft"));
  ASSERT_TRUE(comes_true([&] { return w.has("menu.picture"); }));
  display_.click(w.middle_of("menu.picture"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type((folder_ / "stripe.ppm").string());
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return w.has("picture.woven"); }));
  for (const char* field : {"picture.ends", "picture.loom:Jacquard", "picture.floats"}) {
    const auto [at, size] = w.place_of(field);
    EXPECT_LT(at.x + size.x, 1280) << field << " is out of sight";
  }
  ASSERT_NO_FATAL_FAILURE(press(w, "Weave the picture"));
  EXPECT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 40; }));
  EXPECT_EQ(design_of(w.live()).draft.picks(), 20);
}

TEST_F(FilesTest, RecoveredUnsavedWorkDoesNotOverwriteAFile) {
  const std::string original = bytes_of(draft_);
  std::string lost;
  {
    Window w(display_, folder_, {});
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_NO_FATAL_FAILURE(paint(w));
    lost = w.live();
    kill_once_kept(w);
  }
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Recover"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()) == design_of(lost); }));
  display_.key("ctrl+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); })) << "saved without asking where";
  EXPECT_EQ(bytes_of(draft_), original);
}

TEST_F(FilesTest, RecoveredWorkWhoseFileChangedAsksForAPath) {
  std::string lost;
  {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_NO_FATAL_FAILURE(paint(w));
    lost = w.live();
    kill_once_kept(w);
  }
  const std::string theirs = straight_draft(30, 4);
  put(draft_, theirs);
  Window w(display_, folder_, {}, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Recover"));
  ASSERT_TRUE(comes_true([&] { return w.live() == lost; }));
  display_.key("ctrl+s");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  EXPECT_EQ(bytes_of(draft_), theirs);
}

TEST_F(FilesTest, UnreadableUnsavedWorkIsListedAndKept) {
  const fs::path journal = folder_ / "state/weftlight/recovery/00112233445566ff/1.journal";
  fs::create_directories(journal.parent_path());
  put(journal, "damaged");
  for (int start = 0; start < 2; ++start) {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_TRUE(comes_true([&] { return w.has("recovery:1"); })) << "no dialog at start " << start;
    EXPECT_FALSE(w.has("recovery:2"));
    ASSERT_NO_FATAL_FAILURE(press(w, start == 0 ? "Recover" : "Later"));
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
    EXPECT_EQ(bytes_of(journal), "damaged");
  }
}

/// A folder that nobody can write to, not even root, during the lifetime of this object.
class ReadOnlyFolder {
 public:
  explicit ReadOnlyFolder(fs::path folder) : folder_(std::move(folder)) {
    fs::permissions(folder_, fs::perms::owner_write, fs::perm_options::remove);
    if (geteuid() == 0) flagged_ = run("chattr +i ");
    std::error_code error;
    const fs::path probe = folder_ / "probe";
    holds_ = !std::ofstream(probe).is_open();
    fs::remove(probe, error);
  }
  ~ReadOnlyFolder() { release(); }
  ReadOnlyFolder(const ReadOnlyFolder&) = delete;
  ReadOnlyFolder& operator=(const ReadOnlyFolder&) = delete;
  bool holds() const { return holds_; }
  void release() {
    if (flagged_) run("chattr -i ");
    flagged_ = false;
    fs::permissions(folder_, fs::perms::owner_write, fs::perm_options::add);
  }

 private:
  bool run(const std::string& words) const {
    return std::system((words + "'" + folder_.string() + "' > /dev/null 2>&1").c_str()) == 0;
  }
  fs::path folder_;
  bool flagged_ = false, holds_ = false;
};

TEST_F(FilesTest, SavingToAReadOnlyFolderFailsWithAMessage) {
  const fs::path shelf = folder_ / "shelf";
  fs::create_directory(shelf);
  const fs::path file = shelf / "kept.wif";
  put(file, straight_draft());
  const std::string original = bytes_of(file);
  ReadOnlyFolder locked(shelf);
  if (!locked.holds()) GTEST_SKIP() << "root can write everywhere here: neither chattr +i nor permissions prevent it";
  std::string lost;
  {
    Window w(display_, folder_, file, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_NO_FATAL_FAILURE(paint(w));
    lost = w.live();
    display_.key("ctrl+s");
    // The text is that of write_file_atomically: file and cause (base.Files).
    ASSERT_TRUE(comes_true([&] { return w.has("dialog:Save as\xE2\x80\xA6"); })) << "there is no message";
    ASSERT_NO_FATAL_FAILURE(press(w, "Cancel"));
    EXPECT_EQ(bytes_of(file), original);
    EXPECT_EQ(w.live(), lost) << "the work is kept";
    kill_once_kept(w);
  }
  locked.release();
  Window w(display_, folder_, {}, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Recover"));
  EXPECT_TRUE(comes_true([&] { return w.live() == lost; }));
}

TEST_F(FilesTest, AWriteErrorIsShownUntilItIsSolved) {
  const fs::path folder = folder_ / "live";
  fs::create_directory(folder);
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_FALSE(w.has("trouble"));
  // A file instead of the folder of unsaved work.
  fs::remove_all(folder_ / "state");
  put(folder_ / "state", "in the way");
  display_.click(w.cell("threading", 1, 3));
  ASSERT_TRUE(comes_true([&] { return w.has("trouble"); })) << "there is no message";
  fs::remove(folder_ / "state");
  EXPECT_TRUE(comes_true([&] { return !w.has("trouble"); })) << "the message is still there";
  EXPECT_TRUE(fs::exists(folder_ / "state/weftlight/recovery"));
}

TEST_F(FilesTest, AFailedSaveIsReportedAndKeepsTheOldFile) {
  const std::string original = bytes_of(draft_);
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(paint(w));
  const std::string kept = w.live();
  ASSERT_TRUE(comes_true([&] { return journal_bytes() > 0; }));
  // No file may grow past some bytes: writing fails as on a full disk. The map of the controls cannot be written
  // either, so the question is first seen in a screenshot, and read when the limit is gone.
  const rlimit full{100, RLIM_INFINITY}, none{RLIM_INFINITY, RLIM_INFINITY};
  ASSERT_EQ(prlimit(w.process().id(), RLIMIT_FSIZE, &full, nullptr), 0);
  display_.move({640, 798});  // where nothing is highlighted
  const std::string before = display_.picture({0, 0}, {1280, 800});
  display_.key("ctrl+s");
  EXPECT_TRUE(comes_true([&] {
    const std::string now = display_.picture({0, 0}, {1280, 800});
    size_t other = 0;
    for (size_t k = 0; k < std::min(before.size(), now.size()); ++k) other += before[k] != now[k] ? 1 : 0;
    return other > before.size() / 20;
  })) << "no question covers the window";
  ASSERT_TRUE(w.process().is_running()) << "a full disk must not end the window";
  ASSERT_EQ(prlimit(w.process().id(), RLIMIT_FSIZE, &none, nullptr), 0);
  display_.move({642, 798});  // another frame, whose map can be written
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Save as\xE2\x80\xA6"); })) << "the failed save is not reported";
  const std::string said = w.name_after("question:");
  EXPECT_TRUE(said.starts_with(draft_.string() + ": cannot be written: ")) << said;
  EXPECT_NE(said.find("Your work is still here."), std::string::npos) << said;
  EXPECT_EQ(bytes_of(draft_), original);
  w.process().kill_now();
  w.process().wait();
  Window again(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(again, "Recover"));
  EXPECT_TRUE(comes_true([&] { return again.live() == kept; })) << "the unsaved work from before the disk was full";
}

TEST_F(FilesTest, FlagsDoNotOverwriteForeignFiles) {
  const auto code = [&](const std::vector<std::string>& flags) {
    std::vector<std::string> words{tested_program(), draft_.string()};
    words.insert(words.end(), flags.begin(), flags.end());
    return Process(words, {"DISPLAY=" + display_.name(), "XDG_STATE_HOME=" + (folder_ / "state").string()}).wait();
  };
  const std::string original = bytes_of(draft_);
  put(folder_ / "other.wif", "somebody's");
  EXPECT_EQ(code({"--live-export", draft_.string()}), 2);
  EXPECT_EQ(code({"--live-export", (folder_ / "other.wif").string()}), 2);
  EXPECT_EQ(code({"--ui-map", draft_.string()}), 2);
  EXPECT_EQ(code({"--ui-map", (folder_ / "other.wif").string()}), 2);
  EXPECT_EQ(code({"--ui-map", "/tmp/weftlight_same", "--live-export", "/tmp/weftlight_same"}), 2);
  EXPECT_EQ(bytes_of(draft_), original);
  EXPECT_EQ(bytes_of(folder_ / "other.wif"), "somebody's");
}

}  // namespace
}  // namespace weftlight::gui
