// The window crashes: a report without anything of the draft is left, and shown at the next start beside the unsaved
// work, which is offered as ever.

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "on_display.h"

namespace weftlight::gui {
namespace {

namespace fs = std::filesystem;

class CrashTest : public OnDisplay {
 protected:
  void SetUp() override {
    OnDisplay::SetUp();
    if (folder_.empty()) return;
    const rlimit none{0, 0};  // no picture of the memory beside the tests
    ::setrlimit(RLIMIT_CORE, &none);
    recovery_ = folder_ / "state/weftlight/recovery";
    draft_ = folder_ / "confidential scarf.wif";
    design::Design d = design_of(straight_draft());
    d.title = "Confidential title";
    put(draft_, wif::write_new_wif(d));
  }
  fs::path report() const { return recovery_ / "crash-1.txt"; }
  bool is_kept() const {
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(recovery_, ignored))
      if (entry.path().extension() == ".journal" && entry.file_size(ignored) > 0) return true;
    return false;
  }

  fs::path recovery_;
};

TEST_F(CrashTest, AReportIsLeftAndTheWorkIsOffered) {
  std::string last;
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    const int frame = w.frame();
    display_.key("F4");  // the inspector
    ASSERT_TRUE(comes_true([&] { return w.frame() > frame; }));
    ASSERT_NO_FATAL_FAILURE(paint(w));
    last = w.live();
    ASSERT_TRUE(comes_true([&] { return is_kept(); }));
    ::kill(w.process().id(), SIGSEGV);
    EXPECT_NE(w.process().wait(), 0);
  }
  const std::string text = bytes_of(report());
  EXPECT_TRUE(text.starts_with("Weftlight 0.")) << text;
  EXPECT_NE(text.find("\n  inspector\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  weftlight 0x"), std::string::npos) << text;
  for (const std::string mine : {"onfidential", "scarf", folder_.filename().c_str()})
    EXPECT_EQ(text.find(mine), std::string::npos) << text;
  struct stat facts {};
  ASSERT_EQ(::stat(report().c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
  ASSERT_EQ(::stat(recovery_.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0700u);

  Window again(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return again.has("dialog:Recover") && again.has("recovery.report"); }));
  ASSERT_NO_FATAL_FAILURE(press(again, "Delete report"));
  EXPECT_TRUE(comes_true([&] { return !fs::exists(report()); }));
  EXPECT_FALSE(again.has("recovery.report"));
  ASSERT_NO_FATAL_FAILURE(press(again, "Recover"));
  EXPECT_TRUE(comes_true([&] { return again.live() == last; })) << "not all of it came back";
}

TEST_F(CrashTest, AReportAloneIsShownUntilItIsDeleted) {
  fs::create_directories(recovery_);
  put(report(), "Weftlight 0.1.0\nstack\n");
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.has("recovery.report"); }));
  EXPECT_FALSE(w.has("dialog:Recover"));
  ASSERT_NO_FATAL_FAILURE(press(w, "Later"));
  EXPECT_TRUE(fs::exists(report()));
  EXPECT_FALSE(w.has("recovery.report"));
}

}  // namespace
}  // namespace weftlight::gui
