// The tour names the user's shortcuts, not the default ones.

#include "views/shell/tour.h"

#include <gtest/gtest.h>

namespace weftlight::views {

using session::ActionItem;

namespace {

std::vector<ActionItem> items() {
  ActionItem undo, open;
  undo.id = "undo", undo.menu = "Edit", undo.label = "Undo: Paint threading", undo.shortcut = "Ctrl+Z";
  open.id = "open", open.menu = "File", open.label = "Open", open.shortcut = "";
  return {undo, open};
}

TEST(Tour, NamesTheShortcuts) {
  EXPECT_EQ(with_keys("{undo} takes back any step.", items()), "Ctrl+Z takes back any step.");
  std::vector<ActionItem> own = items();
  own[0].shortcut = "Ctrl+U";
  EXPECT_EQ(with_keys("Any step: {undo}", own), "Any step: Ctrl+U");
}

TEST(Tour, NamesTheMenuOfAnActionWithoutShortcut) {
  std::vector<ActionItem> own = items();
  own[0].shortcut = "";
  EXPECT_EQ(with_keys("{undo}; {open}.", own), "Edit, Undo; File, Open.");
}

TEST(Tour, LeavesOtherTextUnchanged) {
  EXPECT_EQ(with_keys("", items()), "");
  EXPECT_EQ(with_keys("no key", items()), "no key");
  EXPECT_EQ(with_keys("an open { brace", items()), "an open ");
}

}  // namespace
}  // namespace weftlight::views
