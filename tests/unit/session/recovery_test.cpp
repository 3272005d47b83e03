// Crashed sessions are recognised by their locks; their work is offered once, newest first.

#include "session/recovery/recovery.h"

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <thread>

#include "../heir.h"
#include "../scratch_fixture.h"
#include "session/document/bring_back.h"
#include "session/recovery/journal.h"

namespace weftlight::session {

using base::write_file_atomically;

namespace {

namespace fs = std::filesystem;

class RecoveryTest : public ScratchTest {
 protected:
  std::string root() const { return path("recovery"); }

  /// A session in a process of its own that is killed with these documents unsaved.
  void crash(const std::vector<std::string>& names) const {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Recovery recovery(root());
      Journal journal(recovery);
      usleep(20'000);  // file times tell sessions apart
      for (const std::string& name : names)
        journal.keep(journal.new_document(), {path(name), name, {}}, [name] { return "text of " + name; });
      journal.settle();
      kill(getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  static std::vector<std::string> names(const std::vector<LeftWork>& left) {
    std::vector<std::string> found;
    for (const LeftWork& one : left) found.push_back(one.note ? one.note->name : "");
    return found;
  }
};

using Names = std::vector<std::string>;

TEST_F(RecoveryTest, OffersEveryCrashedSessionNewestFirst) {
  crash({"first.wif"});
  crash({"second.wif", "Untitled"});
  crash({"third.wif"});
  Recovery now(root());
  const std::vector<LeftWork> left = now.left_behind();
  ASSERT_EQ(left.size(), 4u);
  EXPECT_EQ(left.front().note->name, "third.wif");
  EXPECT_EQ(left.back().note->name, "first.wif");
  for (const LeftWork& one : left) EXPECT_EQ(read_left(one)->text, "text of " + one.note->name);
}

TEST_F(RecoveryTest, AnotherWindowDoesNotOfferTheSameWork) {
  crash({"a.wif"});
  Recovery one(root());
  EXPECT_EQ(one.left_behind().size(), 1u);
  EXPECT_TRUE(Recovery(root()).left_behind().empty());
  EXPECT_EQ(one.left_behind().size(), 1u) << "the same window may ask again";
}

TEST_F(RecoveryTest, PostponedWorkIsOfferedNextTime) {
  crash({"a.wif"});
  { Recovery(root()).left_behind(); }
  EXPECT_EQ(names(Recovery(root()).left_behind()), Names{"a.wif"});
}

TEST_F(RecoveryTest, ARunningSessionIsLeftAlone) {
  Recovery living(root());
  Journal journal(living);
  journal.keep(1, {"", "Untitled", {}}, [] { return "text"; });
  journal.settle();
  Recovery other(root());
  EXPECT_TRUE(other.left_behind().empty());
  EXPECT_TRUE(fs::exists(living.journal_path(1)));
}

TEST_F(RecoveryTest, ASessionInAnotherContainerIsLeftAloneWhateverTheClockSays) {
  Heir heir([&](const auto& inherit) {
    Recovery living(root());
    EXPECT_TRUE(living.open());
    EXPECT_TRUE(write_file_atomically(living.journal_path(1), journal_start({{"", "Untitled", {}}, "text"})));
    inherit(living.journal_path(1));
  });
  ASSERT_TRUE(fs::exists(heir.name()));
  const fs::path folder = fs::path(heir.name()).parent_path();
  for (const int years : {-60, 60}) {
    const auto then = fs::file_time_type::clock::now() + std::chrono::hours(24 * 365 * years);
    for (const fs::path& at : {fs::path(heir.name()), folder / "lock", folder}) fs::last_write_time(at, then);
    EXPECT_TRUE(Recovery(root()).left_behind().empty()) << years;
    EXPECT_TRUE(fs::exists(heir.name())) << years;
  }
  heir.kill();
  EXPECT_EQ(names(Recovery(root()).left_behind()), Names{"Untitled"});
}

TEST_F(RecoveryTest, ItsUserAloneCanReadIt) {
  const mode_t before = ::umask(0);
  Recovery recovery(root());
  Journal journal(recovery);
  journal.keep(1, {"", "a", {}}, [] { return "text"; });
  journal.settle();
  ::umask(before);
  const fs::path file = recovery.journal_path(1);
  for (const fs::path& folder : {fs::path(root()), file.parent_path()})
    EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all) << folder;
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(RecoveryTest, WaitsForNobodysLock) {
  crash({"a.wif"});
  // Held by a program that has stopped, on a disk that several share.
  const auto held = platform::FileLock::take(path("recovery/lock"));
  ASSERT_TRUE(held.held());
  Recovery now(root());
  EXPECT_TRUE(now.open());
  EXPECT_EQ(names(now.left_behind()), Names{"a.wif"});
  EXPECT_TRUE(Recovery(root()).left_behind().empty());
}

TEST_F(RecoveryTest, AFolderThatWasHalfMadeGoes) {
  fs::create_directories(path("recovery/00000000000000ff.making"));
  written("recovery/00000000000000ff.making/lock", "");
  fs::create_directories(path("recovery/00000000000000fe.making"));
  written("recovery/00000000000000fe.making/lock", "");
  const auto held = platform::FileLock::take(path("recovery/00000000000000fe.making/lock"));
  Recovery now(root());
  EXPECT_TRUE(now.left_behind().empty());
  EXPECT_FALSE(fs::exists(path("recovery/00000000000000ff.making")));
  EXPECT_TRUE(fs::exists(path("recovery/00000000000000fe.making"))) << "its session is about to begin";
}

TEST_F(RecoveryTest, DiscardsOneJournalAndFinallyTheFolder) {
  crash({"a.wif", "b.wif"});
  Recovery now(root());
  std::vector<LeftWork> left = now.left_behind();
  ASSERT_EQ(left.size(), 2u);
  const fs::path folder = fs::path(left[0].journal).parent_path();
  now.discard(left[0]);
  EXPECT_TRUE(fs::exists(left[1].journal));
  now.discard(left[1]);
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_TRUE(now.left_behind().empty());
}

TEST_F(RecoveryTest, UnreadableWorkIsListedLastAndKept) {
  crash({"a.wif"});
  fs::create_directories(path("recovery/00000000000000ff"));
  written("recovery/00000000000000ff/1.journal", "not a journal");
  written("recovery/00000000000000ff/2.journal", "");         // ended before it wrote anything
  fs::create_directories(path("recovery/0000000000000000"));  // nothing in it
  fs::create_directories(path("recovery/mine"));
  Recovery now(root());
  const std::vector<LeftWork> left = now.left_behind();
  ASSERT_EQ(names(left), (Names{"a.wif", ""}));
  EXPECT_TRUE(left[0].note) << problem_of(left[0].note);
  EXPECT_EQ(left[1].journal, path("recovery/00000000000000ff/1.journal"));
  EXPECT_FALSE(left[1].note);
  EXPECT_FALSE(read_left(left[1]));
  const OpenResult back = bring_back(left[1]);
  ASSERT_EQ(back.remarks.size(), 1u);
  EXPECT_NE(back.remarks[0].text.find(left[1].journal + " cannot be read: "), std::string::npos);
  EXPECT_TRUE(fs::exists(left[1].journal));
  EXPECT_FALSE(fs::exists(path("recovery/00000000000000ff/2.journal")));
  EXPECT_FALSE(fs::exists(path("recovery/0000000000000000")));
  EXPECT_TRUE(fs::exists(path("recovery/mine")));
}

TEST_F(RecoveryTest, SessionsStartedAtOnceDoNotSeemCrashed) {
  std::vector<std::thread> starts;
  std::atomic<int> taken{0};
  for (int t = 0; t < 8; ++t)
    starts.emplace_back([&] {
      for (int i = 0; i < 20; ++i) {
        Recovery session(root());
        EXPECT_TRUE(session.open());
        EXPECT_TRUE(write_file_atomically(session.journal_path(1), journal_start({{}, "text"})));
        taken += static_cast<int>(session.left_behind().size());
        EXPECT_TRUE(fs::exists(session.journal_path(1)));
        fs::remove(session.journal_path(1));
      }
    });
  for (std::thread& t : starts) t.join();
  EXPECT_EQ(taken, 0);
}

}  // namespace
}  // namespace weftlight::session
