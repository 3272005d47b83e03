// A finished file comes to stand in another's place so that a power failure at any moment leaves the old or the new
// one.

#include "platform/durable_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "../scratch.h"
#include "platform/unique_name.h"

namespace {

std::vector<std::string> steps;  // what was asked of the system, in order

std::string name_of(int file) {
  return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file)).filename().string();
}

}  // namespace

// In place of the system's own, for this program and its libraries.
extern "C" int fsync(int file) {
  steps.push_back("sync " + name_of(file));
  return static_cast<int>(::syscall(SYS_fsync, file));
}
extern "C" int rename(const char* from, const char* to) noexcept {
  steps.push_back("rename to " + std::filesystem::path(to).filename().string());
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace weftlight::platform {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class DurableFileTest : public ::testing::Test {
 protected:
  void SetUp() override { steps.clear(); }
  std::string path(const std::string& name) const { return scratch_ / name; }
  std::string folder_name() const { return scratch_.folder.filename().string(); }
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  int count() const {
    return static_cast<int>(std::distance(fs::directory_iterator(scratch_.folder), fs::directory_iterator{}));
  }
  const Scratch scratch_;
};

TEST_F(DurableFileTest, is_synced_then_renamed_then_its_folder_is_synced) {
  written("a.wif", "old");
  DurableFile file(path("a.wif"));
  ASSERT_FALSE(file.error());
  EXPECT_TRUE(is_temporary_of(path("a.wif"), fs::path(file.beside()).filename().string()));
  std::ofstream(file.beside()) << "new";
  EXPECT_EQ(text_of(path("a.wif")), "old");
  const std::string beside = fs::path(file.beside()).filename().string();
  EXPECT_FALSE(file.put_in_place());
  EXPECT_EQ(text_of(path("a.wif")), "new");
  EXPECT_EQ(steps, (std::vector<std::string>{"sync " + beside, "rename to a.wif", "sync " + folder_name()}));
}

TEST_F(DurableFileTest, of_a_folder_every_file_is_synced_before_the_rename) {
  fs::create_directories(path("made/within"));
  for (const char* name : {"made/one", "made/two", "made/within/three"}) written(name, name);
  fs::create_symlink("nowhere", path("made/link"));
  EXPECT_FALSE(put_in_place(path("made"), path("set")));
  EXPECT_EQ(text_of(path("set/within/three")), "made/within/three");
  const auto renamed = std::find(steps.begin(), steps.end(), "rename to set");
  ASSERT_NE(renamed, steps.end());
  for (const char* name : {"one", "two", "three", "within", "made"})
    EXPECT_LT(std::find(steps.begin(), steps.end(), std::string("sync ") + name), renamed) << name;
  EXPECT_EQ(steps.back(), "sync " + folder_name());
}

TEST_F(DurableFileTest, a_folder_replaces_an_empty_one_only) {
  for (const char* name : {"made", "empty", "full"}) fs::create_directory(path(name));
  written("made/one", "1");
  written("full/two", "2");
  EXPECT_TRUE(put_in_place(path("made"), path("full")));
  EXPECT_EQ(text_of(path("full/two")), "2");
  EXPECT_FALSE(put_in_place(path("made"), path("empty")));
  EXPECT_EQ(text_of(path("empty/one")), "1");
}

TEST_F(DurableFileTest, without_being_put_in_place_it_leaves_nothing) {
  written("a.wif", "old");
  { std::ofstream(DurableFile(path("a.wif")).beside()) << "new"; }
  EXPECT_EQ(text_of(path("a.wif")), "old");
  EXPECT_EQ(count(), 1);
}

TEST_F(DurableFileTest, keeps_the_old_permissions_and_writes_through_links) {
  ::chmod(written("a.wif", "old").c_str(), 0600);
  fs::create_symlink("a.wif", path("link.wif"));
  DurableFile file(path("link.wif"));
  std::ofstream(file.beside()) << "new";
  EXPECT_FALSE(file.put_in_place());
  EXPECT_TRUE(fs::is_symlink(path("link.wif")));
  EXPECT_EQ(text_of(path("a.wif")), "new");
  EXPECT_EQ(fs::status(path("a.wif")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(DurableFileTest, the_file_beside_is_locked_while_it_is_written) {
  DurableFile file(path("a.wif"));
  EXPECT_EQ(FileLock::take_existing(file.beside()).answer(), LockAnswer::kTaken);
}

TEST_F(DurableFileTest, says_beforehand_what_it_would_say) {
  ::chmod(written("a.wif", "old").c_str(), 0444);
  for (const std::string& target : {path("a.wif"), path("none/a.wif"), path("a.wif/b.wif")}) {
    EXPECT_TRUE(why_not_replaced(target)) << target;
    EXPECT_EQ(DurableFile(target).error(), why_not_replaced(target)) << target;
  }
  EXPECT_FALSE(why_not_replaced(path("new.wif")));
  EXPECT_EQ(count(), 1);
}

}  // namespace
}  // namespace weftlight::platform
