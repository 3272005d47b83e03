// Everyday things by real clicks: the page of drafts with pictures.

#include "on_display.h"

namespace weftlight::gui {

using namespace draft;
namespace {

namespace fs = std::filesystem;

class DeskTest : public OnDisplay {
 protected:
  /// Where no zenity is, so that the window asks itself.
  static std::vector<std::string> without_dialogs() { return {"PATH=/nowhere"}; }

  void settings(const nlohmann::json& more) const {
    nlohmann::json all = {{"width", 1280}, {"height", 800}};
    all.update(more);
    put(folder_ / "config/weftlight/settings.json", all.dump());
  }
  void press(const Window& w, const std::string& control) const {
    ASSERT_TRUE(comes_true([&] { return w.has(control); })) << control << " is not there";
    display_.click(w.middle_of(control));
  }
};

TEST_F(DeskTest, RecentDraftsStandOnAPageWithPictures) {
  const fs::path other = folder_ / "other.wif", gone = folder_ / "gone.wif";
  put(other, straight_draft(20, 4));
  settings({{"recent", {gone.string(), other.string(), draft_.string()}}});
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    display_.key("ctrl+shift+o");
    ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:1") && w.has("gallery.picture:3"); }))
        << "what was opened now stands first; the lost one has no picture";
    EXPECT_TRUE(w.has("gallery.missing:2"));
    ASSERT_NO_FATAL_FAILURE(press(w, "gallery.remove:2"));
    ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:2") && !w.has("gallery:3"); }));
    display_.type("other");
    ASSERT_TRUE(comes_true([&] { return !w.has("gallery:2"); }));
    display_.key("Return");
    ASSERT_TRUE(comes_true([&] { return w.live() == bytes_of(other) && w.has("tab.shown:2"); }));
    EXPECT_FALSE(w.has("gallery:1")) << "the page is closed";
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
  const std::string kept = bytes_of(folder_ / "config/weftlight/settings.json");
  EXPECT_EQ(kept.find("gone.wif"), std::string::npos) << "it was taken off the list";
  EXPECT_TRUE(fs::exists(folder_ / "cache/weftlight/drafts"));
}

TEST_F(DeskTest, TheLibraryLooksTheSameAndGivesCopies) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "menu:Library"));
  ASSERT_NO_FATAL_FAILURE(press(w, "menu.library"));
  ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:1"); }));
  display_.type("overshot");
  ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:1") && !w.has("gallery:2"); }));
  display_.click(w.middle_of("gallery:1"));
  ASSERT_TRUE(comes_true([&] { return w.has("tab.shown:2"); }));
  display_.key("ctrl+s");
  EXPECT_TRUE(comes_true([&] { return w.has("dialog.path"); })) << "a shipped draft is never overwritten";
}

}  // namespace
}  // namespace weftlight::gui
