// The window system goes away under the window: the server crashes, or the session ends. The program says so in a line
// and ends, and all unsaved work is offered at the next start.

#include <algorithm>
#include <csignal>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class LostDisplayTest : public OnDisplay {};

TEST_F(LostDisplayTest, AllUnsavedWorkIsBack) {
  show_cloth();
  const std::string original = bytes_of(draft_), errors = (folder_ / "errors").string();
  std::string last;
  {
    Display lost(1280, 800);
    ASSERT_TRUE(lost.is_up());
    Window w(lost, folder_, draft_, without_dialogs(), errors);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    w.process().send(SIGPIPE);  // what a write to a server that has gone sends, if it comes before a read
    for (int end = 1; end <= 8; end += 2) {
      const std::string before = w.live();
      lost.click(w.cell("threading", end, 3));
      ASSERT_TRUE(comes_true([&] { return w.live() != before; })) << "the click painted nothing";
    }
    last = w.live();
    lost.kill_now();
    EXPECT_EQ(w.process().wait(), 5) << "it ends in order, and the draft is not written";
  }
  const std::string said = bytes_of(errors);
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_TRUE(said.starts_with("weftlight: ") && said.find("unsaved work") != std::string::npos) << said;
  EXPECT_EQ(bytes_of(draft_), original);
  Window again(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return again.has("dialog:Recover"); })) << "nothing was offered";
  display_.click(again.middle_of("dialog:Recover"));
  EXPECT_TRUE(comes_true([&] { return again.live() == last; })) << "not all of it came back";
}

TEST_F(LostDisplayTest, WithNothingUnsavedNothingIsOffered) {
  const std::string errors = (folder_ / "errors").string();
  {
    Display lost(1280, 800);
    ASSERT_TRUE(lost.is_up());
    Window w(lost, folder_, draft_, without_dialogs(), errors);
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    lost.kill_now();
    EXPECT_EQ(w.process().wait(), 4);
  }
  const std::string said = bytes_of(errors);
  EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
  EXPECT_EQ(said.find("unsaved work"), std::string::npos) << said;
  Window again(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return again.is_ready(); }));
  EXPECT_FALSE(again.has("dialog:Recover"));
}

}  // namespace
}  // namespace weftlight::gui
