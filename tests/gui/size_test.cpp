// How large things are: the interface, rulers, the cloth at its true distance; and a folder of drafts.

#include <algorithm>

#include "on_display.h"

namespace weftlight::gui {
namespace {

namespace fs = std::filesystem;

class SizeTest : public OnDisplay {
 protected:
  nlohmann::json kept_settings() const {
    return nlohmann::json::parse(bytes_of(folder_ / "config/weftlight/settings.json"), nullptr, false);
  }
};

TEST_F(SizeTest, TheInterfaceChangesItsSizeAtOnceAndKeepsIt) {
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  const double before = w.place_of("menu:File").second.y;
  ASSERT_NO_FATAL_FAILURE(command(w, "interface size: 150"));
  EXPECT_TRUE(comes_true([&] { return std::abs(w.place_of("menu:File").second.y / before - 1.5) < 0.1; }));
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
  EXPECT_EQ(kept_settings()["interface_percent"], 150);
}

TEST_F(SizeTest, FiguresStandInTheMiddleOfTheirSliders) {
  for (const int percent : {100, 150}) {
    settings({{"interface_percent", percent}});
    Window w(display_, folder_, draft_);
    ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Analysis"));
    ASSERT_TRUE(comes_true([&] { return w.has("floats.limit:figure"); }));
    EXPECT_NEAR(w.middle_of("floats.limit:figure").y, w.middle_of("floats.limit").y, 1) << percent;
  }
}

TEST_F(SizeTest, ControlsOfARowAreOfOneHeightAndEndWithTheirPanel) {
  for (const int percent : {100, 150}) {
    settings({{"interface_percent", percent}});
    Window w(display_, folder_, draft_);
    ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Threads"));
    ASSERT_TRUE(comes_true([&] { return w.has("threads.sett") && w.has("palette.add"); }));
    EXPECT_NEAR(w.place_of("threads.sett").second.y, w.place_of("threads.per:/cm").second.y, 1) << percent;
    const auto right_of = [&](const std::string& control) {
      const auto [at, size] = w.place_of(control);
      return at.x + size.x;
    };
    EXPECT_LE(right_of("palette.add"), right_of("threads.which") + 1) << percent << ": the button is cut";
    EXPECT_LE(right_of("threads.spacing:yarn"), right_of("threads.which") + 1) << percent << ": the button is cut";
    EXPECT_GT(w.place_of("inspector:Threads").second.x, w.place_of("inspector:Plan").second.x)
        << percent << ": the longest name has no room beside it";
  }
}

TEST_F(SizeTest, ATipIsAsDarkBesideAGreyIconAsElsewhere) {
  Window w(display_, folder_, draft_);
  ASSERT_NO_FATAL_FAILURE(click(w, "inspector:Threads"));
  const auto darkest = [&](const std::string& control) {
    EXPECT_TRUE(comes_true([&] { return w.has(control); })) << control;
    display_.move(w.middle_of("menu:File"));
    EXPECT_TRUE(comes_true([&] { return !w.has("tip"); }));
    display_.move(w.middle_of(control));
    EXPECT_TRUE(comes_true([&] { return w.has("tip"); })) << control;
    const auto [at, size] = w.place_of("tip");
    const std::string picture = display_.picture({at.x + 2, at.y + 2}, {size.x - 4, size.y - 4});
    const size_t header = 15;  // of a PPM file
    int least = 255;
    for (size_t i = header; i < picture.size(); ++i)
      least = std::min<int>(least, static_cast<unsigned char>(picture[i]));
    return least;
  };
  EXPECT_NEAR(darkest("threads.spacing:yarn"), darkest("palette.add"), 20);
}

TEST_F(SizeTest, ADraftIsFittedBelowTheMenuBar) {
  settings({{"interface_percent", 150}});
  put(draft_, straight_draft(16, 2));
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_TRUE(comes_true([&] { return !w.has("scroll.picks") && !w.has("scroll.ends"); })) << "a part is out of sight";
}

TEST_F(SizeTest, EverythingIsReachedAtTwiceTheSizeInASmallWindow) {
  settings({{"cloth", true}, {"interface_percent", 200}});
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  display_.resize(900, 600);
  const auto inside = [&](const std::string& control) {
    const auto [at, size] = w.place_of(control);
    return at.x >= 0 && at.y >= 0 && at.x + size.x <= 901 && at.y + size.y <= 601;
  };
  ASSERT_TRUE(comes_true([&] { return w.has("menu:Help") && inside("menu:Help") && inside("inspector:Plan"); }));
  EXPECT_FALSE(w.has("hanging:Flat")) << "the inspector has the place of the cloth";
  display_.key("F4");
  ASSERT_TRUE(comes_true([&] { return w.has("hanging:Flat") && inside("hanging:Flat"); }));
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("dialog:Create"); }));
  display_.key("Return");
  EXPECT_TRUE(comes_true([&] { return !w.has("dialog:Create"); }));
}

TEST_F(SizeTest, TheScreenIsMeasuredByACard) {
  show_cloth();
  Window w(display_, folder_, draft_);
  ASSERT_TRUE(comes_true([&] { return is_settled(w); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(command(w, "rulers"));
  display_.key("shift+d");
  ASSERT_TRUE(comes_true([&] { return w.has("card.corner"); })) << "a screen that was never measured is";
  const Point card = w.place_of("card").first;
  const Point corner = w.middle_of("card.corner");
  const double scale = 5 * 85.6 / (corner.x - card.x);
  display_.drag({corner, {card.x + (corner.x - card.x) * scale, card.y + (corner.y - card.y) * scale}});
  ASSERT_TRUE(comes_true([&] { return std::abs(w.middle_of("card.corner").x - card.x - 5 * 85.6) < 3; }));
  ASSERT_NO_FATAL_FAILURE(press(w, "Save"));
  EXPECT_TRUE(comes_true([&] { return w.has("view.seen_from") && w.has("view.rulers"); }));
  display_.key("shift+d");
  EXPECT_TRUE(comes_true([&] { return !w.has("view.seen_from"); }));
  display_.key("shift+d");
  EXPECT_TRUE(comes_true([&] { return w.has("view.seen_from"); })) << "it is not measured again";
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0);
  const nlohmann::json screens = kept_settings()["screens"];
  ASSERT_EQ(screens.size(), 1U);
  EXPECT_NEAR(screens.begin()->get<double>(), 5, 0.05);
}

TEST_F(SizeTest, AFolderIsBrowsedAndSearched) {
  const fs::path drafts = folder_ / "drafts";
  fs::create_directories(drafts / "within");
  put(drafts / "four.wif", straight_draft(24, 4));
  put(drafts / "within" / "eight.wif", straight_draft(24, 8));
  settings({{"drafts_folder", drafts.string()}});
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.focus();
  ASSERT_NO_FATAL_FAILURE(command(w, "folder of drafts"));
  ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:2") && w.has("folder.read"); }));
  ASSERT_NO_FATAL_FAILURE(click(w, "folder.shafts"));
  ASSERT_NO_FATAL_FAILURE(click(w, "folder.shafts:8-8"));
  ASSERT_TRUE(comes_true([&] { return w.has("gallery:1") && !w.has("gallery:2"); }));
  display_.click(w.middle_of("gallery:1"));
  EXPECT_TRUE(comes_true([&] { return w.live() == bytes_of(drafts / "within" / "eight.wif"); }));
}

}  // namespace
}  // namespace weftlight::gui
