// Which program asks for a file, in what words, and what becomes of its answer.

#include "platform/desktop.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "../scratch.h"
#include "platform/environment_variables.h"
#include "platform/posix/dialog_program.h"

namespace weftlight::platform {
namespace {

class FileDialogTest : public ::testing::Test {
 protected:
  void install(const char* program, const std::string& does = "") {
    const std::string path = scratch_ / program;
    std::ofstream(path) << "#!/bin/sh\n" << does;
    ::chmod(path.c_str(), 0755);
  }
  /// The one asker that is found.
  void asks(const std::string& does) {
    install("zenity", does);
    set_variable("PATH", scratch_.folder.string() + ":/usr/bin:/bin");
    ::unsetenv("XDG_CURRENT_DESKTOP");
  }
  void TearDown() override { set_variable("PATH", path_); }
  static bool answered(FileDialog& dialog) {
    for (int i = 0; i < 2000 && dialog.waiting(); ++i) {
      dialog.poll();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return !dialog.waiting();
  }
  const Scratch scratch_;
  const std::string path_ = variable("PATH");
};

TEST_F(FileDialogTest, TheDesktopsOwnProgramAsksAndElseTheOneThatIsThere) {
  const std::string folders = "/nowhere:" + scratch_.folder.string();
  EXPECT_EQ(find_dialog_program(folders, "KDE"), DialogProgram::kNone);
  install("kdialog");
  EXPECT_EQ(find_dialog_program(folders, "GNOME"), DialogProgram::kKdialog);
  install("zenity");
  EXPECT_EQ(find_dialog_program(folders, "ubuntu:GNOME"), DialogProgram::kZenity);
  EXPECT_EQ(find_dialog_program(folders, "KDE"), DialogProgram::kKdialog);
  EXPECT_EQ(find_dialog_program("", ""), DialogProgram::kNone);
}

TEST_F(FileDialogTest, BothAreAskedForTheSame) {
  using Words = std::vector<std::string>;
  const std::vector<FileFilter> filters = {{"Drafts", "*.wif *.WIF"}, {"All files", "*"}};
  EXPECT_EQ(
      dialog_words(DialogProgram::kKdialog, {FileAsk::kOpen, "Open", "/drafts/", filters}),
      (Words{"kdialog", "--title", "Open", "--getopenfilename", "/drafts/", "Drafts (*.wif *.WIF)|All files (*)"}));
  EXPECT_EQ(dialog_words(DialogProgram::kKdialog, {FileAsk::kFolder, "Folder", "", {}}),
            (Words{"kdialog", "--title", "Folder", "--getexistingdirectory", "."}));
  EXPECT_EQ(dialog_words(DialogProgram::kZenity, {FileAsk::kFolder, "Folder", "", {}}),
            (Words{"zenity", "--file-selection", "--title=Folder", "--directory"}));
  const Words save = dialog_words(DialogProgram::kZenity, {FileAsk::kSave, "Save as", "/drafts/a.wif", filters});
  for (const char* word :
       {"--save", "--confirm-overwrite", "--filename=/drafts/a.wif", "--file-filter=Drafts | *.wif *.WIF"})
    EXPECT_NE(std::ranges::find(save, word), save.end()) << word;
}

TEST_F(FileDialogTest, WhatIsChosenComesAndWhatIsLeftDoesNot) {
  std::vector<std::string> chosen;
  FileDialog dialog;
  const auto ask = [&] {
    dialog.ask({FileAsk::kOpen, "Open", "", {}}, [&](const std::string& path) { chosen.push_back(path); });
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

TEST_F(FileDialogTest, OneThatIsKilledAsksNoMore) {
  FileDialog dialog;
  // With a helper of its own that lives on and has its output open.
  const std::string helper = scratch_ / "helper";
  asks("sleep 100 & echo $! >'" + helper + "'\necho /drafts/half\nkill -9 $$\n");
  dialog.ask({FileAsk::kOpen, "Open", "", {}}, [](const std::string&) { ADD_FAILURE() << "nobody chose"; });
  ASSERT_TRUE(answered(dialog)) << "the window would ask for no other file";
  pid_t left = 0;
  if (std::ifstream(helper) >> left) ::kill(left, SIGKILL);
  std::vector<std::string> chosen;
  asks("echo /drafts/next.wif\n");
  dialog.ask({FileAsk::kOpen, "Open", "", {}}, [&](const std::string& path) { chosen.push_back(path); });
  ASSERT_TRUE(answered(dialog));
  EXPECT_EQ(chosen, std::vector<std::string>{"/drafts/next.wif"});
}

TEST_F(FileDialogTest, WhoQuitsWhileItAsksDoesNotWait) {
  const std::string number = scratch_ / "number";
  asks("echo $$ >'" + number + "'\nexec sleep 30\n");
  const auto start = std::chrono::steady_clock::now();
  pid_t program = 0;
  {
    FileDialog dialog;
    dialog.ask({FileAsk::kOpen, "Open", "", {}}, [](const std::string&) { ADD_FAILURE() << "nobody chose"; });
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
}  // namespace weftlight::platform
