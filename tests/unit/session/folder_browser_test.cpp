#include "session/library/folder_browser.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>
#include <mutex>

#include "../scratch_fixture.h"
#include "base/whole_files.h"
#include "wif/wif.h"

namespace weftlight::session {
namespace {

class FolderBrowserTest : public ScratchTest {
 protected:
  void SetUp() override {
    ScratchTest::SetUp();
    for (const int shafts : {4, 8}) {
      design::Design d;
      d.draft = draft::blank_draft(8, 8, shafts, shafts);
      const std::string name = "draft " + std::to_string(shafts) + ".wif";
      ASSERT_TRUE(base::write_file_atomically((dir_ / name).string(), wif::write_new_wif(d)));
    }
  }
  /// Takes results until there is nothing to wait for.
  void settle() {
    std::unique_lock lock(mutex_);
    for (;;) {
      browser_.poll();
      if (!browser_.busy()) break;
      woken_.wait_for(lock, std::chrono::seconds(30), [this] { return std::exchange(woke_, false); });
    }
    browser_.poll();
  }

  std::mutex mutex_;
  std::condition_variable woken_;
  bool woke_ = false;
  FolderBrowser browser_{"", [this] {
                           {
                             const std::lock_guard lock(mutex_);
                             woke_ = true;
                           }
                           woken_.notify_one();
                         }};
};

TEST_F(FolderBrowserTest, FindsWhatIsAskedForWhenTheFolderIsRead) {
  browser_.search({.shafts = {8, 8}});
  browser_.open(dir_.string());
  settle();
  ASSERT_EQ(browser_.entries()->size(), 2U);
  EXPECT_EQ(browser_.found(), (std::vector<int>{1}));
  EXPECT_EQ(browser_.said(), "");
  browser_.search({.words = "draft"});
  settle();
  EXPECT_EQ(browser_.found(), (std::vector<int>{0, 1}));
}

TEST_F(FolderBrowserTest, AnotherFolderReplacesTheList) {
  browser_.open(dir_.string());
  settle();
  std::filesystem::create_directories(dir_ / "empty");
  browser_.open((dir_ / "empty").string());
  EXPECT_TRUE(browser_.entries()->empty()) << "no card of the folder before is shown as one of this";
  settle();
  EXPECT_TRUE(browser_.found().empty());
}

TEST_F(FolderBrowserTest, AStopIsSaid) {
  browser_.open(dir_.string());
  browser_.stop();
  settle();
  EXPECT_FALSE(browser_.is_reading());
}

}  // namespace
}  // namespace weftlight::session
