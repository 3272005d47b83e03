// Which program asks for a file, and in what words.

#include "app/file_dialog.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "../scratch_fixture.h"

namespace weftlight::app {
namespace {

class FileDialogTest : public ScratchTest {
 protected:
  void install(const char* program) { ::chmod(written(program, "#!/bin/sh\n").c_str(), 0755); }
};

TEST_F(FileDialogTest, TheDesktopsOwnProgramAsksAndElseTheOneThatIsThere) {
  const std::string folders = "/nowhere:" + dir_.string();
  EXPECT_EQ(find_asker(folders, "KDE"), Asker::kNone);
  install("kdialog");
  EXPECT_EQ(find_asker(folders, "GNOME"), Asker::kKdialog);
  install("zenity");
  EXPECT_EQ(find_asker(folders, "ubuntu:GNOME"), Asker::kZenity);
  EXPECT_EQ(find_asker(folders, "KDE"), Asker::kKdialog);
  EXPECT_EQ(find_asker("", ""), Asker::kNone);
}

TEST_F(FileDialogTest, BothAreAskedForTheSame) {
  using Words = std::vector<std::string>;
  EXPECT_EQ(asker_words(Asker::kKdialog, FileAsk::kOpen, "Open", "/drafts/", ".wif"),
            (Words{"kdialog", "--title", "Open", "--getopenfilename", "/drafts/",
                   "Weaving drafts (*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO)|"
                   "WIF drafts (*.wif *.WIF *.wifw *.WIFW)|"
                   "Pictures, a pixel a crossing (*.png *.PNG *.tif *.tiff *.TIF *.bmp)|All files (*)"}));
  EXPECT_EQ(asker_words(Asker::kKdialog, FileAsk::kFolder, "Folder", "", ""),
            (Words{"kdialog", "--title", "Folder", "--getexistingdirectory", "."}));
  const Words save = asker_words(Asker::kZenity, FileAsk::kSave, "Save as", "/drafts/a.wif", ".wif");
  for (const char* word : {"--save", "--confirm-overwrite", "--filename=/drafts/a.wif"})
    EXPECT_NE(std::ranges::find(save, word), save.end()) << word;
}

}  // namespace
}  // namespace weftlight::app
