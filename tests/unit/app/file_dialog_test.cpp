// Which program shows the file dialog, and its arguments.

#include "app/file_dialog.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "../scratch_fixture.h"

namespace weftlight::app {
namespace {

class FileDialogTest : public ScratchTest {
 protected:
  void install(const char* program, const std::string& does = "") {
    ::chmod(written(program, "#!/bin/sh\n" + does).c_str(), 0755);
  }
  /// The one asker that is found.
  void asks(const std::string& does) {
    install("zenity", does);
    ::setenv("PATH", (dir_.string() + ":/usr/bin:/bin").c_str(), 1);
    ::unsetenv("XDG_CURRENT_DESKTOP");
  }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }
  static bool answered(FileDialog& dialog) {
    for (int i = 0; i < 2000 && dialog.waiting(); ++i) {
      dialog.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return !dialog.waiting();
  }
  std::string path_ = std::getenv("PATH");
};

TEST_F(FileDialogTest, PrefersTheProgramOfTheDesktop) {
  const std::string folders = "/nowhere:" + dir_.string();
  EXPECT_EQ(find_asker(folders, "KDE"), Asker::kNone);
  install("kdialog");
  EXPECT_EQ(find_asker(folders, "GNOME"), Asker::kKdialog);
  install("zenity");
  EXPECT_EQ(find_asker(folders, "ubuntu:GNOME"), Asker::kZenity);
  EXPECT_EQ(find_asker(folders, "KDE"), Asker::kKdialog);
  EXPECT_EQ(find_asker("", ""), Asker::kNone);
}

TEST_F(FileDialogTest, BothProgramsGetTheSameRequest) {
  using Words = std::vector<std::string>;
  const char* kinds =
      "Weaving drafts (*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO)|"
      "WIF drafts (*.wif *.WIF *.wifw *.WIFW)|"
      "Pictures, one pixel for each crossing (*.png *.PNG *.tif *.tiff *.TIF *.bmp)|All files (*)";
  EXPECT_EQ(asker_words(Asker::kKdialog, FileAsk::kOpen, "Open", "/drafts/", ".wif"),
            (Words{"kdialog", "--title", "Open", "--getopenfilename", "/drafts/", kinds}));
  EXPECT_EQ(asker_words(Asker::kKdialog, FileAsk::kFolder, "Folder", "", ""),
            (Words{"kdialog", "--title", "Folder", "--getexistingdirectory", "."}));
  const Words save = asker_words(Asker::kZenity, FileAsk::kSave, "Save as", "/drafts/a.wif", ".wif");
  for (const char* word : {"--save", "--confirm-overwrite", "--filename=/drafts/a.wif"})
    EXPECT_NE(std::ranges::find(save, word), save.end()) << word;
}

TEST_F(FileDialogTest, ReportsAChosenPathAndNothingWhenCancelled) {
  std::vector<std::string> chosen;
  FileDialog dialog;
  const auto ask = [&] {
    dialog.ask(FileAsk::kOpen, "Open", "", ".wif", [&](const std::string& path) { chosen.push_back(path); });
  };
  asks("echo '/drafts/two words.wif'\n");
  ask();
  EXPECT_TRUE(dialog.waiting());
  ASSERT_TRUE(answered(dialog));
  EXPECT_EQ(chosen, std::vector<std::string>{"/drafts/two words.wif"});
  asks("echo /drafts/no.wif\nexit 1\n");
  ask();
  ASSERT_TRUE(answered(dialog));
  EXPECT_EQ(chosen.size(), 1u);
}

TEST_F(FileDialogTest, QuittingDoesNotWaitForAnOpenDialog) {
  const std::string number = (dir_ / "number").string();
  asks("echo $$ >'" + number + "'\nexec sleep 30\n");
  const auto start = std::chrono::steady_clock::now();
  pid_t program = 0;
  {
    FileDialog dialog;
    dialog.ask(FileAsk::kOpen, "Open", "", ".wif", [](const std::string&) { ADD_FAILURE() << "nobody chose"; });
    for (int i = 0; i < 2000 && !(std::ifstream(number) >> program); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    dialog.poll();
    EXPECT_TRUE(dialog.waiting());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20)) << "it sleeps for thirty";
  ASSERT_GT(program, 0);
  EXPECT_NE(::kill(program, 0), 0) << "the dialog is left alone on the screen";
}

}  // namespace
}  // namespace weftlight::app
