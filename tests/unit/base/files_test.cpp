// Files are written atomically: completely or not at all.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <new>

#include "../scratch_fixture.h"
#include "base/user_folders.h"
#include "base/whole_files.h"

namespace weftlight::base {
namespace {

namespace fs = std::filesystem;

Result<void> write_two(const std::string& name) {
  std::ofstream(name) << "two";
  return {};
}

class FileTest : public ScratchTest {
 protected:
  /// Number of files in the folder; no temporary file may remain.
  int count() const { return static_cast<int>(std::distance(fs::directory_iterator(dir_), fs::directory_iterator{})); }
};

TEST_F(FileTest, new_and_replaced) {
  EXPECT_EQ(problem_of(write_file_atomically(path("a.wif"), "one")), "");
  EXPECT_EQ(read_file(path("a.wif")).value_or(""), "one");
  EXPECT_EQ(problem_of(write_file_atomically(path("a.wif"), std::string("t\0o", 3))), "");
  EXPECT_EQ(read_file(path("a.wif")).value_or(""), std::string("t\0o", 3));
  EXPECT_EQ(count(), 1);
}

TEST_F(FileTest, reading_ends_when_it_is_to_stop) {
  std::ofstream(path("a.wif")) << std::string(200'000, 'x');
  std::stop_source stop;
  EXPECT_EQ(read_file(path("a.wif"), kMaxFileBytes, stop.get_token())->size(), 200'000u);
  stop.request_stop();
  EXPECT_FALSE(read_file(path("a.wif"), kMaxFileBytes, stop.get_token()));
}

TEST_F(FileTest, keep_newest_removes_the_oldest) {
  const auto hours_ago = [&](const std::string& name, int hours) {
    EXPECT_EQ(problem_of(write_file_atomically(path(name), "x")), "");
    fs::last_write_time(path(name), fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (int i = 0; i < 6; ++i) hours_ago("picture" + std::to_string(i) + ".png", i);
  hours_ago("words.txt", 9);
  keep_newest(dir_.string(), ".png", 4, path("picture0.png"));
  EXPECT_EQ(count(), 5);
  for (const char* name : {"picture4.png", "picture5.png"}) EXPECT_FALSE(fs::exists(path(name))) << name;
  keep_newest(dir_.string(), ".png", 4, path("picture0.png"));
  keep_newest(path("no such folder"), ".png", 0, path("no such folder/a.png"));
  EXPECT_EQ(count(), 5);
}

TEST_F(FileTest, keep_newest_keeps_what_was_just_written_though_the_clock_went_back) {
  const auto written_in = [&](const std::string& name, int hours) {
    EXPECT_EQ(problem_of(write_file_atomically(path(name), "x")), "");
    fs::last_write_time(path(name), fs::file_time_type::clock::now() + std::chrono::hours(hours));
  };
  for (int i = 0; i < 4; ++i) written_in("before" + std::to_string(i) + ".glb", 24 + i);
  written_in("one.glb", -1);
  keep_newest(dir_.string(), ".glb", 4, path("one.glb"));
  written_in("two.glb", 0);
  keep_newest(dir_.string(), ".glb", 4, path("two.glb"));
  for (const char* name : {"one.glb", "two.glb"}) EXPECT_TRUE(fs::exists(path(name))) << name;
  EXPECT_EQ(count(), 4);
}

TEST_F(FileTest, permissions_stay) {
  EXPECT_EQ(problem_of(write_file_atomically(path("a.wif"), "one")), "");
  ::chmod(path("a.wif").c_str(), 0640);
  EXPECT_EQ(problem_of(write_file_atomically(path("a.wif"), "two")), "");
  struct stat info {};
  ::stat(path("a.wif").c_str(), &info);
  EXPECT_EQ(info.st_mode & 0777u, 0640u);
}

TEST_F(FileTest, a_link_stays_a_link) {
  fs::create_directories(dir_ / "there");
  EXPECT_EQ(problem_of(write_file_atomically(path("there/a.wif"), "one")), "");
  fs::create_symlink("there/a.wif", dir_ / "b.wif");
  fs::create_symlink("b.wif", dir_ / "c.wif");
  EXPECT_EQ(problem_of(write_file_atomically(path("c.wif"), "two")), "");
  EXPECT_TRUE(fs::is_symlink(dir_ / "b.wif") && fs::is_symlink(dir_ / "c.wif"));
  EXPECT_EQ(read_file(path("there/a.wif")).value_or(""), "two");
  fs::create_symlink("there/new.wif", dir_ / "d.wif");
  EXPECT_EQ(problem_of(write_file_atomically(path("d.wif"), "new")), "");
  EXPECT_EQ(read_file(path("there/new.wif")).value_or(""), "new");
}

TEST_F(FileTest, a_failed_write_leaves_no_file) {
  EXPECT_NE(problem_of(write_file_atomically(path("none/a.wif"), "one")), "");
  EXPECT_NE(problem_of(write_file_atomically(dir_.string(), "one")), "");
  EXPECT_EQ(count(), 0);
  EXPECT_NE(problem_of(read_file(path("none.wif"))), "");
  EXPECT_NE(problem_of(read_file(dir_.string())), "");
}

TEST_F(FileTest, check_writable_agrees_with_a_write) {
  EXPECT_EQ(problem_of(write_file_atomically(path("file"), "one")), "");
  for (const std::string& target : {path("none/a.wif"), path("file/a.wif"), dir_.string(), std::string()}) {
    EXPECT_FALSE(check_writable(target)) << target;
    EXPECT_EQ(problem_of(check_writable(target)), problem_of(write_file_atomically(target, "one"))) << target;
  }
  for (const std::string& target : {path("file"), path("new"), std::string("/dev/null"), std::string("/dev/stdout")})
    EXPECT_EQ(problem_of(check_writable(target)), "") << target;
  EXPECT_EQ(count(), 1);
}

TEST_F(FileTest, a_read_only_file_is_not_replaced) {
  EXPECT_EQ(problem_of(write_file_atomically(path("a.png"), "one")), "");
  ::chmod(path("a.png").c_str(), 0444);
  EXPECT_NE(problem_of(write_file_atomically(path("a.png"), "two")), "");
  EXPECT_NE(problem_of(write_through(path("a.png"), write_two)), "");
  EXPECT_EQ(read_file(path("a.png")).value_or(""), "one");
  EXPECT_EQ(count(), 1);
}

TEST_F(FileTest, write_through_follows_a_link_and_keeps_the_extension) {
  fs::create_directories(dir_ / "there");
  fs::create_symlink("there/a.png", dir_ / "b.png");
  std::string beside;
  EXPECT_EQ(
      problem_of(write_through(path("b.png"), [&](const std::string& name) { return beside = name, write_two(name); })),
      "");
  EXPECT_EQ(fs::path(beside).extension(), ".png");
  EXPECT_EQ(fs::path(beside).parent_path().filename(), "there");
  EXPECT_TRUE(fs::is_symlink(dir_ / "b.png"));
  EXPECT_EQ(read_file(path("there/a.png")).value_or(""), "two");
}

TEST_F(FileTest, a_failed_write_through_keeps_the_old_file) {
  EXPECT_EQ(problem_of(write_file_atomically(path("a.png"), "one")), "");
  const Result<void> failed = write_through(path("a.png"), [](const std::string& name) {
    write_two(name);
    return written_unless("no such colour");
  });
  ASSERT_FALSE(failed);
  EXPECT_EQ(message(failed.error()), path("a.png") + ": cannot be written: no such colour");
  EXPECT_EQ(failed.error().file, path("a.png"));
  EXPECT_EQ(failed.error().kind, ErrorKind::kOutput);
  EXPECT_NE(
      problem_of(write_through(path("a.png"), [](const std::string&) -> Result<void> { throw std::bad_alloc(); })), "");
  EXPECT_EQ(read_file(path("a.png")).value_or(""), "one");
  EXPECT_EQ(count(), 1);
}

TEST_F(FileTest, a_full_device_is_reported) {
  EXPECT_EQ(problem_of(write_file_atomically("/dev/full", "one")), "/dev/full: cannot be written: the disk is full");
  fs::create_symlink("/dev/full", dir_ / "full.png");
  EXPECT_EQ(problem_of(write_through(path("full.png"), write_two)),
            path("full.png") + ": cannot be written: the disk is full");
  EXPECT_EQ(problem_of(write_file_atomically("/dev/null", "one")), "");
}

TEST_F(FileTest, into_a_pipe) {
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  EXPECT_EQ(problem_of(write_file_atomically("/dev/fd/" + std::to_string(ends[1]), "one")), "");
  EXPECT_EQ(problem_of(write_through("/proc/self/fd/" + std::to_string(ends[1]), write_two)), "");
  char got[8] = "";
  EXPECT_EQ(::read(ends[0], got, sizeof got), 6);
  EXPECT_STREQ(got, "onetwo");
  ::close(ends[0]), ::close(ends[1]);
}

TEST_F(FileTest, pipes_and_devices_are_not_read) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(problem_of(read_file(path("pipe"))), path("pipe") + ": is a pipe or a device, not a file");
  EXPECT_NE(problem_of(read_file("/dev/zero")), "");
  EXPECT_EQ(problem_of(write_file_atomically(path("long"), std::string(3 << 20, 'x'))), "");
  EXPECT_EQ(problem_of(read_file(path("long"), 1 << 20)), path("long") + ": is larger than 1 MiB");
}

TEST_F(FileTest, long_names) {
  const std::string name = std::string(240, 'n') + ".wif";
  EXPECT_EQ(problem_of(write_file_atomically(path(name.c_str()), "one")), "");
  EXPECT_EQ(read_file(path(name.c_str())).value_or(""), "one");
  EXPECT_NE(problem_of(write_file_atomically(path(std::string(300, 'n').c_str()), "one")), "");
  EXPECT_NE(problem_of(write_file_atomically("", "one")), "");
}

}  // namespace
}  // namespace weftlight::base
