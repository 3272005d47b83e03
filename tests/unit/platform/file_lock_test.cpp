// Who has a lock lives, whatever its number; who has not, or cannot be asked, is not taken for dead.

#include "platform/file_lock.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "../heir.h"
#include "../no_locks.h"
#include "../scratch.h"
#include "platform/unique_name.h"

namespace weftlight::platform {
namespace {

namespace fs = std::filesystem;

TEST(FileLockTest, OneHasItUntilItGoes) {
  const Scratch scratch("lock");
  {
    FileLock first = FileLock::take(scratch / "lock");
    ASSERT_TRUE(first.held()) << first.cause();
    EXPECT_EQ(FileLock::take(scratch / "lock").answer(), LockAnswer::kTaken);
    const FileLock moved = std::move(first);
    EXPECT_EQ(FileLock::take_existing(scratch / "lock").answer(), LockAnswer::kTaken);
    // Another opening and closing of the file does not end it.
    std::ofstream(scratch / "lock") << "written meanwhile";
    EXPECT_EQ(FileLock::take(scratch / "lock").answer(), LockAnswer::kTaken);
  }
  EXPECT_TRUE(FileLock::wait_for(scratch / "lock").held());
}

TEST(FileLockTest, AForkHasItToo) {
  const Scratch scratch("heir");
  Heir heir([&](const auto& inherit) {
    const FileLock lock = FileLock::take(scratch / "lock");
    inherit(lock.held() ? "held" : "");
  });
  EXPECT_EQ(heir.name(), "held");
  EXPECT_EQ(FileLock::take(scratch / "lock").answer(), LockAnswer::kTaken);
  heir.kill();
  EXPECT_TRUE(FileLock::take(scratch / "lock").held());
}

TEST(FileLockTest, AForkThatEndsDoesNotEndIt) {
  const Scratch scratch("fork");
  FileLock lock = FileLock::take(scratch / "lock");
  const pid_t child = fork();
  if (child == 0) {
    lock = FileLock();
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_EQ(FileLock::take(scratch / "lock").answer(), LockAnswer::kTaken);
}

TEST(FileLockTest, KnowsWhetherItsFileStandsThere) {
  const Scratch scratch("stands");
  const FileLock lock = FileLock::make(scratch / "a");
  ASSERT_TRUE(lock.held());
  EXPECT_TRUE(lock.stands_at(scratch / "a"));
  fs::rename(scratch / "a", scratch / "b");
  EXPECT_FALSE(lock.stands_at(scratch / "a"));
  EXPECT_TRUE(lock.stands_at(scratch / "b"));
  std::ofstream(scratch / "a") << "another";
  EXPECT_FALSE(lock.stands_at(scratch / "a"));
  EXPECT_FALSE(FileLock().stands_at(scratch / "a"));
}

TEST(FileLockTest, MakesOnlyWhatIsToBeMade) {
  const Scratch scratch("make");
  EXPECT_EQ(FileLock::take_existing(scratch / "a").answer(), LockAnswer::kNoFile);
  EXPECT_FALSE(fs::exists(scratch / "a"));
  std::ofstream(scratch / "a") << "text";
  EXPECT_EQ(FileLock::make(scratch / "a").cause(), std::errc::file_exists);
  EXPECT_TRUE(FileLock::take(scratch / "a").held());
  EXPECT_EQ(fs::file_size(scratch / "a"), 4u);
  fs::create_symlink(scratch / "a", scratch / "link");
  EXPECT_EQ(FileLock::take_existing(scratch / "link").answer(), LockAnswer::kNoFile);
  EXPECT_EQ(FileLock::take(scratch / "no folder/a").cause(), std::errc::no_such_file_or_directory);
}

TEST(FileLockTest, WhereThereAreNoneItSaysSo) {
  const Scratch scratch("none");
  const int answer = without_locks([&] {
    const FileLock lock = FileLock::take(scratch / "lock");
    return lock.answer() == LockAnswer::kNoLocks && lock.cause() == std::errc::no_lock_available && !lock.held();
  });
  if (answer < 0) GTEST_SKIP() << "the system filters no calls";
  EXPECT_EQ(answer, 1);
}

TEST(UniqueName, IsDrawnOnce) {
  std::set<std::string> drawn;
  for (int i = 0; i < 1000; ++i) drawn.insert(unique_name());
  EXPECT_EQ(drawn.size(), 1000u);
  for (const std::string& name : drawn) EXPECT_TRUE(is_unique_name(name)) << name;
  for (const char* name : {"", "0123456789abcde", "0123456789abcdef0", "0123456789abcdeF"})
    EXPECT_FALSE(is_unique_name(name)) << name;
}

}  // namespace
}  // namespace weftlight::platform
