// Reports of crashes: what the window shows, and what it removes.

#include "session/recovery/crash_reports.h"

#include <filesystem>

#include "../scratch_fixture.h"
#include "platform/crash_report.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;

class CrashReportsTest : public ScratchTest {
 protected:
  /// `minutes` before now.
  void leave(int number, const std::string& text, int minutes) const {
    const std::string at = written(platform::crash_report_name(number), text);
    fs::last_write_time(at, fs::file_time_type::clock::now() - std::chrono::minutes(minutes));
  }
};

TEST_F(CrashReportsTest, TheNewestIsFirst) {
  leave(1, "old\n", 30);
  leave(2, "new\n", 1);
  leave(5, "older\n", 60);
  const std::vector<CrashReport> found = crash_reports_in(dir_.string());
  EXPECT_EQ(joined_text(found), "new\n\nold\n\nolder\n");
  remove_reports(found);
  EXPECT_TRUE(fs::is_empty(dir_));
}

TEST_F(CrashReportsTest, WhatIsNoReportIsLeftAlone) {
  written("crash-6.txt", "not one of them");
  written("crash-1.txt.bak", "nor this");
  fs::create_directory(path(platform::crash_report_name(2)));
  EXPECT_TRUE(crash_reports_in(dir_.string()).empty());
  EXPECT_TRUE(crash_reports_in(path("nowhere")).empty());
  EXPECT_EQ(joined_text({}), "");
}

TEST_F(CrashReportsTest, ADamagedReportIsShownAsFarAsItIsText) {
  leave(1, std::string("Weft\0light\x1b[31m\n\xff end", 21), 1);
  leave(2, std::string(1 << 20, 'x'), 1);
  EXPECT_EQ(joined_text(crash_reports_in(dir_.string())), "Weftlight[31m\n end");
}

}  // namespace
}  // namespace weftlight::session
