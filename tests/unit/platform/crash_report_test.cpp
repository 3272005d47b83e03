// Programs that really crash: each is a process of its own, and ends as it would have ended without a report.

#include "platform/crash_report.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>

namespace weftlight::platform {
namespace {

namespace fs = std::filesystem;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  // a sanitizer has handlers of its own, and ends the program in its own way
#else
constexpr bool kSanitized = false;
#endif

class CrashReportTest : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/weftlight_crash_XXXXXX";
    root_ = mkdtemp(name);
    folder_ = root_ / "state/weftlight/recovery";
  }
  void TearDown() override { fs::remove_all(root_); }

  /// How a process ends in which `crash` runs: the signal, or 0.
  int end_of(const std::function<void()>& crash) const {
    const pid_t child = ::fork();
    if (child == 0) {
      const rlimit none{0, 0};
      ::setrlimit(RLIMIT_CORE, &none);
      std::freopen("/dev/null", "w", stderr);
      report_crashes(folder_.string(), "Weftlight 9.8.7 (abcdef0)");
      crash();
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }
  void expect_end(int signal, const std::function<void()>& crash) const {
    const int end = end_of(crash);
    EXPECT_TRUE(kSanitized || end == signal) << end;
  }
  std::string report(int number = 1) const {
    std::ifstream in(folder_ / crash_report_name(number));
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

  fs::path root_, folder_;
};

volatile int* volatile nowhere = nullptr;
void touch_nothing() { *nowhere = 1; }

int run_over(int depth) {
  volatile char room[4096] = {};
  room[depth % 4096] = 1;
  return depth < 0 ? 0 : run_over(depth + 1) + room[0];
}

TEST_F(CrashReportTest, AFaultLeavesVersionStackAndActions) {
  expect_end(SIGSEGV, [] {
    for (int i = 1; i <= 12; ++i) note_action("action_" + std::to_string(i));
    touch_nothing();
  });
  const std::string text = report();
  EXPECT_TRUE(text.starts_with("Weftlight 9.8.7 (abcdef0)\ntime: 20")) << text;
  EXPECT_TRUE(holds(text, "ended by: SIGSEGV (memory that is not there)")) << text;
  EXPECT_TRUE(holds(text, "thread: the window's\n")) << text;
  EXPECT_TRUE(holds(text, "newest first:\n  action_12\n  action_11\n")) << text;
  EXPECT_TRUE(holds(text, "  action_3\nstack ")) << "the last ten: " << text;
  EXPECT_FALSE(holds(text, "action_2\n")) << text;
  EXPECT_TRUE(holds(text, "\n  platform_test 0x")) << text;
  EXPECT_FALSE(holds(text, "/platform_test")) << "the place of the program is the user's: " << text;
}

TEST_F(CrashReportTest, ItsUserAloneCanReadIt) {
  const mode_t before = ::umask(0);
  expect_end(SIGSEGV, touch_nothing);
  ::umask(before);
  struct stat file {
  }, folder{};
  ASSERT_EQ(::stat((folder_ / crash_report_name(1)).c_str(), &file), 0);
  ASSERT_EQ(::stat(folder_.c_str(), &folder), 0);
  EXPECT_EQ(file.st_mode & 0777, 0600u);
  EXPECT_EQ(folder.st_mode & 0777, 0700u);
}

TEST_F(CrashReportTest, TheLineOfTheFaultIsFound) {
  if (kSanitized || std::system("command -v addr2line >/dev/null") != 0) GTEST_SKIP() << "addr2line is not installed";
  expect_end(SIGSEGV, touch_nothing);
  const std::string text = report();
  // The first frame of this program above the handler and the signal.
  const size_t libc = text.find("\n  libc");
  const size_t at = text.find("\n  platform_test 0x", libc);
  ASSERT_NE(at, std::string::npos) << text;
  const std::string offset = text.substr(at + 17, text.find_first_of(" \n", at + 17) - at - 17);
  const std::string command = "addr2line -Cfe " + fs::read_symlink("/proc/self/exe").string() + " " + offset;
  FILE* pipe = ::popen(command.c_str(), "r");
  char line[512] = {};
  ASSERT_NE(std::fgets(line, sizeof line, pipe), nullptr);
  ::pclose(pipe);
  EXPECT_TRUE(holds(line, "touch_nothing")) << command << ": " << line << text;
}

TEST_F(CrashReportTest, AbortAndUncaughtExceptionsLeaveOne) {
  expect_end(SIGABRT, [] { std::abort(); });
  EXPECT_TRUE(holds(report(), "ended by: SIGABRT")) << report();
  expect_end(SIGABRT, [] { std::thread([] { throw std::runtime_error("/home/anna/scarf.wif"); }).join(); });
  EXPECT_TRUE(holds(report(2), "\nexception: St13runtime_error\nthread: another\n")) << report(2);
  EXPECT_FALSE(holds(report(2), "anna")) << report(2);
}

TEST_F(CrashReportTest, AStackThatRanOverLeavesOne) {
  expect_end(SIGSEGV, [] { run_over(0); });
  EXPECT_TRUE(holds(report(), "SIGSEGV")) << report();
  EXPECT_TRUE(holds(report(), "\n  platform_test 0x")) << report();
}

TEST_F(CrashReportTest, ASignalFromOutsideEndsItTheSameWay) {
  expect_end(SIGSEGV, [] { ::kill(::getpid(), SIGSEGV); });
  EXPECT_TRUE(holds(report(), "SIGSEGV")) << report();
}

TEST_F(CrashReportTest, OfManyTheNewestStay) {
  for (int i = 1; i <= kMaxCrashReports + 1; ++i)
    end_of([i] {
      note_action("run_" + std::to_string(i));
      std::abort();
    });
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), kMaxCrashReports);
  EXPECT_TRUE(holds(report(1), "run_6")) << report(1);
  EXPECT_TRUE(holds(report(2), "run_2")) << report(2);
}

TEST_F(CrashReportTest, AFolderThatCannotBeMadeChangesNothing) {
  std::ofstream(root_ / "state") << "a file";
  const int end = end_of([] { std::abort(); });
  EXPECT_TRUE(kSanitized || end == SIGABRT) << end;
}

TEST_F(CrashReportTest, AnExceptionThatIsCaughtAtTheEndIsReported) {
  EXPECT_EQ(end_of([] {
              try {
                throw std::logic_error("scarf.wif");
              } catch (...) {
                report_exception();
              }
            }),
            0);
  EXPECT_TRUE(holds(report(), "exception: St11logic_error")) << report();
  EXPECT_FALSE(holds(report(), "scarf")) << report();
}

TEST_F(CrashReportTest, AnActionIsAnIdentifierOfBoundedLength) {
  end_of([] {
    note_action("recent:/home/anna/scarf.wif");
    note_action(std::string(1000, 'x'));
    note_action("");
    std::abort();
  });
  EXPECT_TRUE(holds(report(), "first:\n  \n  " + std::string(47, 'x') + "\n  recent\n")) << report();
}

}  // namespace
}  // namespace weftlight::platform
