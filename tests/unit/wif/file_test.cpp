// Files are replaced whole or not at all.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "wif/wif.h"

namespace weftlight::wif {
namespace {

namespace fs = std::filesystem;

class FileTest : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::path(::testing::TempDir()) / ("weftlight-" + std::to_string(::getpid()) + "-" +
                                             ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(dir_);
  }
  void TearDown() override {
    std::error_code ignored;
    fs::remove_all(dir_, ignored);
  }
  std::string path(const char* name) const { return (dir_ / name).string(); }
  /// Names in the folder: no temporary may be left.
  int count() const { return static_cast<int>(std::distance(fs::directory_iterator(dir_), fs::directory_iterator{})); }
  fs::path dir_;
};

TEST_F(FileTest, new_and_replaced) {
  EXPECT_EQ(write_file_atomically(path("a.wif"), "one"), "");
  EXPECT_EQ(read_file(path("a.wif")).bytes, "one");
  EXPECT_EQ(write_file_atomically(path("a.wif"), std::string("t\0o", 3)), "");
  EXPECT_EQ(read_file(path("a.wif")).bytes, std::string("t\0o", 3));
  EXPECT_EQ(count(), 1);
}

TEST_F(FileTest, permissions_stay) {
  EXPECT_EQ(write_file_atomically(path("a.wif"), "one"), "");
  ::chmod(path("a.wif").c_str(), 0640);
  EXPECT_EQ(write_file_atomically(path("a.wif"), "two"), "");
  struct stat info {};
  ::stat(path("a.wif").c_str(), &info);
  EXPECT_EQ(info.st_mode & 0777u, 0640u);
}

TEST_F(FileTest, a_link_stays_a_link) {
  fs::create_directories(dir_ / "there");
  EXPECT_EQ(write_file_atomically(path("there/a.wif"), "one"), "");
  fs::create_symlink("there/a.wif", dir_ / "b.wif");
  fs::create_symlink("b.wif", dir_ / "c.wif");
  EXPECT_EQ(write_file_atomically(path("c.wif"), "two"), "");
  EXPECT_TRUE(fs::is_symlink(dir_ / "b.wif") && fs::is_symlink(dir_ / "c.wif"));
  EXPECT_EQ(read_file(path("there/a.wif")).bytes, "two");
  fs::create_symlink("there/new.wif", dir_ / "d.wif");
  EXPECT_EQ(write_file_atomically(path("d.wif"), "new"), "");
  EXPECT_EQ(read_file(path("there/new.wif")).bytes, "new");
}

TEST_F(FileTest, what_cannot_be_written_leaves_nothing) {
  EXPECT_NE(write_file_atomically(path("none/a.wif"), "one"), "");
  EXPECT_NE(write_file_atomically(dir_.string(), "one"), "");
  EXPECT_EQ(count(), 0);
  EXPECT_NE(read_file(path("none.wif")).error, "");
  EXPECT_NE(read_file(dir_.string()).error, "");
}

}  // namespace
}  // namespace weftlight::wif
