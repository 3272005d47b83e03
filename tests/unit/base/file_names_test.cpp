// Names of files: which are those of one file, and how they end.

#include "base/file_names.h"

#include <filesystem>

#include "../scratch_fixture.h"

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;
using FileNamesTest = ScratchTest;

TEST_F(FileNamesTest, ManyPathsOfOneFileAreTheSameFile) {
  const std::string file = written("a.wif", "one");
  fs::create_symlink(file, path("link.wif"));
  fs::create_hard_link(file, path("hard.wif"));
  EXPECT_TRUE(same_file(file, path("link.wif")));
  EXPECT_TRUE(same_file(file, path("hard.wif")));
  EXPECT_TRUE(same_file(file, path("./x/../a.wif")));
  EXPECT_TRUE(same_file(path("none.wif"), path("./none.wif")));
  EXPECT_FALSE(same_file(file, path("none.wif")));
  EXPECT_FALSE(same_file("", ""));
}

TEST_F(FileNamesTest, an_extension_does_not_mind_case) {
  EXPECT_EQ(extension_of("a/Cloth.PNG"), ".png");
  EXPECT_EQ(extension_of("cloth.v2.Wif"), ".wif");
  EXPECT_EQ(extension_of("folder.png/cloth"), "");
  EXPECT_EQ(extension_of(""), "");
}

}  // namespace
}  // namespace weftlight::base
