// What the window tells a weaver: refusals, what leads and what follows.

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class DeskTest : public OnDisplay {
 protected:
  void click(const Window& w, const std::string& control) const {
    ASSERT_TRUE(comes_true([&] { return w.has(control); })) << control;
    display_.click(w.middle_of(control));
  }
  /// Runs an action by its name in the command palette.
  void command(const Window& w, const std::string& words) const {
    display_.key("ctrl+p");
    ASSERT_TRUE(comes_true([&] { return w.has("commands.typed"); })) << words;
    display_.type(words);
    display_.key("Return");
    ASSERT_TRUE(comes_true([&] { return !w.has("commands.typed"); })) << words;
  }
};

TEST_F(DeskTest, ARefusalIsSeenBesideTheCellUnderThePointer) {
  design::Design d = design_of(bytes_of(draft_));
  d.loom.locked = true;
  put(draft_, wif::write_new_wif(d));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("lock:drawdown"); }));
  EXPECT_FALSE(w.has("lock:threading")) << "the threading leads";
  const std::string before = w.live();
  display_.click(w.cell("drawdown", 3, 2));
  ASSERT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "the locked drawdown says nothing";
  EXPECT_EQ(w.live(), before);
  // The pointer rests on a cell, and goes to another: the message stands. It goes with an action after it was read.
  display_.move(w.cell("drawdown", 6, 2));
  std::this_thread::sleep_for(std::chrono::seconds(5));
  EXPECT_TRUE(w.has("message.refusal"));
  display_.click(w.middle_of("inspector:Yarns"));
  EXPECT_TRUE(comes_true([&] { return !w.has("message.refusal"); })) << "a read message stays";
  // The padlock opens it.
  ASSERT_NO_FATAL_FAILURE(click(w, "lock:drawdown"));
  ASSERT_TRUE(comes_true([&] { return !design_of(w.live()).loom.locked; })) << "the padlock does not open";
  const std::string open = w.live();
  display_.click(w.cell("drawdown", 3, 2));
  EXPECT_TRUE(comes_true([&] { return w.live() != open; })) << "the unlocked drawdown cannot be painted";
}

TEST_F(DeskTest, ASearchWithoutResultSaysSo) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu:Draft"));
  ASSERT_NO_FATAL_FAILURE(click(w, "menu.skeleton"));
  display_.move(w.cell("drawdown", 3, 2));
  EXPECT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "the cell under the pointer hides it";
}

}  // namespace
}  // namespace weftlight::gui
