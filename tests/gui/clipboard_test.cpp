// The clipboard of the X server: another program that holds it and never answers keeps nobody waiting, and what the
// others hold arrives whole.

#include "on_display.h"
#include "selection_owner.h"

namespace weftlight::gui {
namespace {

class ClipboardTest : public OnDisplay {
 protected:
  void begin_path(const Window& w) const {
    display_.key("ctrl+o");
    ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  }
};

TEST_F(ClipboardTest, ASilentOwnerHoldsUpNobody) {
  const SelectionOwner silent(display_.name(), "CLIPBOARD", SelectionOwner::Answers::kNever);
  ASSERT_TRUE(silent.is_owner());
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.key("ctrl+v");
  ASSERT_NO_FATAL_FAILURE(paint(w));
  ASSERT_NO_FATAL_FAILURE(begin_path(w));
  display_.key("ctrl+v Escape");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog.path"); })) << "the text field waits";
}

TEST_F(ClipboardTest, WhatOthersCopiedIsPastedWhole) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  int shafts = 4;
  for (const auto how : {SelectionOwner::Answers::kAtOnce, SelectionOwner::Answers::kInPieces}) {
    const std::filesystem::path other = folder_ / ("o\xCC\x88ther \xE2\x82\xAC " + std::to_string(shafts) + ".wif");
    put(other, straight_draft(24, shafts));
    const SelectionOwner owner(display_.name(), "CLIPBOARD", how, other.string());
    ASSERT_TRUE(owner.is_owner());
    display_.focus();
    ASSERT_NO_FATAL_FAILURE(begin_path(w));
    display_.key("ctrl+a ctrl+v Return");
    EXPECT_TRUE(comes_true([&] { return w.size_of("threading").second == shafts; })) << other;
    shafts = 6;
  }
}

// While the window ends, with all of the work on the disk: it ends as ever, and no error of Xlib scrolls by.
TEST_F(ClipboardTest, AServerThatGoesWhileTheWindowEndsIsNoError) {
  Display lost(1280, 800);
  ASSERT_TRUE(lost.is_up());
  const SelectionOwner manager(lost.name(), "CLIPBOARD_MANAGER", SelectionOwner::Answers::kNever);
  const std::string errors = (folder_ / "errors").string();
  Window w(lost, folder_, draft_, without_dialogs(), errors);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  lost.focus();
  lost.key("ctrl+o");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  lost.type("scarf");
  lost.key("ctrl+a ctrl+c Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));
  lost.key("ctrl+q");
  ASSERT_TRUE(comes_true([&] { return manager.was_asked(); })) << "the test needs a window that is still ending";
  lost.kill_now();
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(bytes_of(errors), "");
}

TEST_F(ClipboardTest, ASilentManagerDoesNotKeepTheProgram) {
  const SelectionOwner manager(display_.name(), "CLIPBOARD_MANAGER", SelectionOwner::Answers::kNever);
  ASSERT_TRUE(manager.is_owner());
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(begin_path(w));
  display_.type("scarf");
  display_.key("ctrl+a ctrl+c Escape");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
}

}  // namespace
}  // namespace weftlight::gui
