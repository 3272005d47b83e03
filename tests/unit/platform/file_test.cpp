#include "platform/file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "../scratch.h"
#include "platform/files_below.h"

namespace weftlight::platform {
namespace {

namespace fs = std::filesystem;

class FolderContents : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_ / name; }
  std::string written(const std::string& name, const char* text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }

 private:
  const Scratch scratch_;
};

TEST_F(FolderContents, AreNamedOnceEach) {
  written("b.wif", "b"), written(".hidden", "");
  fs::create_directory(path("a folder"));
  std::error_code error;
  std::vector<std::string> names = names_in(path(""), error);
  EXPECT_FALSE(error) << error.message();
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{".hidden", "a folder", "b.wif"}));
}

TEST_F(FolderContents, ThatCannotBeReadHaveAReason) {
  std::error_code error;
  EXPECT_TRUE(names_in(path("none"), error).empty());
  EXPECT_EQ(error, std::errc::no_such_file_or_directory);
  EXPECT_TRUE(names_in(written("file", "bytes"), error).empty());
  EXPECT_EQ(error, std::errc::not_a_directory);
}

TEST_F(FolderContents, AreFoundBelowOtherFoldersOnceEach) {
  fs::create_directories(path("a/b"));
  written("z", "bytes"), written("a/y", "bytes"), written("a/b/x", "bytes");
  fs::create_directory_symlink(path("a"), path("a/b/round"));
  fs::create_symlink(path("z"), path("a/link"));
  fs::create_symlink(path("none"), path("a/nowhere"));
  const FilesBelow below = files_below(path("a"));
  EXPECT_EQ(below.files, (std::vector<std::string>{path("a/b/x"), path("a/link"), path("a/y")}));
  EXPECT_TRUE(below.unread.empty());
  EXPECT_EQ(files_below(path("none")).unread, (std::vector<std::string>{path("none")}));
}

TEST_F(FolderContents, GoWithTheFolderButNotWhatLinksLeadTo) {
  written("kept", "bytes");
  fs::create_directories(path("set/maps"));
  written("set/maps/height.png", "bytes"), written("set/list.json", "{}");
  fs::create_symlink(path("kept"), path("set/link"));
  fs::create_directory(path("beside"));
  written("beside/also kept", "bytes");
  fs::create_directory_symlink(path("beside"), path("set/maps/folder"));
  EXPECT_FALSE(remove_with_contents(path("set")));
  EXPECT_FALSE(fs::exists(path("set")));
  EXPECT_TRUE(fs::exists(path("kept")));
  EXPECT_TRUE(fs::exists(path("beside/also kept")));
  EXPECT_FALSE(remove_with_contents(path("set"))) << "there is none: nothing to do";
}

}  // namespace
}  // namespace weftlight::platform
