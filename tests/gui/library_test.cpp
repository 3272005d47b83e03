// The gallery of drafts, views, accuracy and sections, by real clicks.

#include "on_display.h"

namespace weftlight::gui {

using design::NamedView;
namespace {

namespace fs = std::filesystem;

class LibraryTest : public OnDisplay {
 protected:
  /// Without zenity, so that the window uses its own file dialogs.
  static std::vector<std::string> without_dialogs() { return {"PATH=/nowhere"}; }

  void press(const Window& w, const std::string& control) const {
    ASSERT_TRUE(comes_true([&] { return w.has(control); })) << control << " is not there";
    display_.click(w.middle_of(control));
  }

  /// Three yarns, of which the second becomes active and is painted by the colour bars.
  void activate_second_yarn(const Window& w) const {
    ASSERT_NO_FATAL_FAILURE(press(w, "bars:Yarn"));
    ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Yarns"));
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn.list"));
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn:2"));
    ASSERT_TRUE(comes_true([&] { return !w.has("yarn:2"); }));
  }
  void put_three_yarns() const {
    design::Design d = design_of(straight_draft());
    d.yarns.resize(3, d.yarns[0]);
    for (size_t i = 0; i < d.yarns.size(); ++i) d.yarns[i].name = "Yarn " + std::to_string(i + 1);
    put(draft_, wif::write_new_wif(d));
  }
  /// Adds a fourth yarn while the second is active, undoes that, and paints all ends with the active one.
  template <class Add>
  void undo_of(const Add& add) {
    put_three_yarns();
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    const std::string before = w.live();
    ASSERT_NO_FATAL_FAILURE(activate_second_yarn(w));
    ASSERT_NO_FATAL_FAILURE(add(w));
    ASSERT_TRUE(comes_true([&] { return design_of(w.live()).yarns.size() == 4; })) << "no yarn was added";
    display_.key("ctrl+z");
    ASSERT_TRUE(comes_true([&] { return w.live() == before; })) << "more than one undo step";
    ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Threads"));
    ASSERT_NO_FATAL_FAILURE(press(w, "paint.warp"));
    ASSERT_TRUE(comes_true([&] { return w.live() != before; }));
    EXPECT_EQ(design_of(w.live()).draft.warp.yarn[0], 1) << "another yarn is active than before the undone step";
  }
};

TEST_F(LibraryTest, UndoOfAYarnFromTheLibraryActivatesTheOneBefore) {
  undo_of([this](const Window& w) {
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add"));
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add:library"));
    ASSERT_NO_FATAL_FAILURE(press(w, "yarns.new"));
    ASSERT_TRUE(comes_true([&] { return w.has("yarns.name"); }));
    ASSERT_NO_FATAL_FAILURE(press(w, "dialog:Use in the draft"));
  });
}

TEST_F(LibraryTest, UndoOfAYarnForThreadsActivatesTheOneBefore) {
  undo_of([this](const Window& w) {
    ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Threads"));
    ASSERT_NO_FATAL_FAILURE(press(w, "threads.yarn"));
    ASSERT_NO_FATAL_FAILURE(press(w, "threads.yarn:own"));
  });
}

TEST_F(LibraryTest, UndoOfAReadyYarnActivatesTheOneBefore) {
  undo_of([this](const Window& w) {
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add"));
    ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add:Reeled silk"));
  });
}

TEST_F(LibraryTest, ReadyYarnsAreForTheDraftAndForThreads) {
  put_three_yarns();
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Yarns"));
  ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add"));
  ASSERT_NO_FATAL_FAILURE(press(w, "yarn.add:Woollen yarn"));
  const auto yarn = [&](size_t i) {
    const design::Design d = design_of(w.live());
    return d.yarns.size() > i ? d.yarns[i] : design::Yarn{};
  };
  ASSERT_TRUE(comes_true([&] { return yarn(3).name == "Woollen yarn"; }));
  EXPECT_EQ(yarn(3).fibre, design::Fibre::kWool);
  EXPECT_EQ(yarn(3).plies, 2);
  ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Threads"));
  ASSERT_NO_FATAL_FAILURE(press(w, "threads.yarn"));
  ASSERT_NO_FATAL_FAILURE(press(w, "threads.yarn:Combed cotton"));
  ASSERT_TRUE(comes_true([&] { return yarn(4).name == "Combed cotton"; }));
  EXPECT_EQ(design_of(w.live()).draft.warp.yarn[0], 4) << "all ends have it";
}

TEST_F(LibraryTest, RecentDraftsHaveThumbnails) {
  const fs::path other = folder_ / "other.wif", gone = folder_ / "gone.wif";
  put(other, straight_draft(20, 4));
  settings({{"recent", {gone.string(), other.string(), draft_.string()}}});
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    display_.key("ctrl+shift+o");
    ASSERT_TRUE(comes_true([&] { return w.has("gallery.picture:1") && w.has("gallery.picture:3"); }))
        << "the last opened draft is first; the missing one has no thumbnail";
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
  EXPECT_EQ(kept.find("gone.wif"), std::string::npos) << "it was removed from the list";
  EXPECT_TRUE(fs::exists(folder_ / "cache/weftlight/drafts"));
}

TEST_F(LibraryTest, TheLibraryOpensCopies) {
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

TEST_F(LibraryTest, AnUnreadableEnvironmentImageChangesNothing) {
  show_cloth();
  put(folder_ / "words.hdr", "these are words");
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  display_.click(w.middle_of("inspector:Cloth"));
  ASSERT_NO_FATAL_FAILURE(press(w, "scene.environment"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.path"); }));
  display_.key("ctrl+a");
  display_.type((folder_ / "words.hdr").string());
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return !w.has("dialog.path"); }));
  EXPECT_EQ(w.live(), before);
  display_.key("ctrl+q");
  EXPECT_EQ(w.process().wait(), 0) << "nothing is unsaved";
}

TEST_F(LibraryTest, ViewsOfTheClothAreSavedByName) {
  show_cloth();
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const auto from_menu = [&](const std::string& item) {
    ASSERT_NO_FATAL_FAILURE(press(w, "views"));
    ASSERT_NO_FATAL_FAILURE(press(w, "views." + item));
    ASSERT_TRUE(comes_true([&] { return !w.has("views." + item); }));
  };
  const std::string before = w.live();
  ASSERT_NO_FATAL_FAILURE(from_menu("view.grazing"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).scene.light_elevation == 12; })) << "its light is an edit";
  ASSERT_NO_FATAL_FAILURE(from_menu("view_keep_as"));
  ASSERT_TRUE(comes_true([&] { return w.has("dialog.name"); }));
  display_.type("Gloss");
  display_.key("Return");
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).views.size() == 1; }));
  const NamedView kept = design_of(w.live()).views[0];
  EXPECT_EQ(kept.name, "Gloss");
  EXPECT_TRUE(kept.flat);
  EXPECT_GT(kept.scene.view_azimuth, 60);
  ASSERT_NO_FATAL_FAILURE(from_menu("view.whole"));
  ASSERT_NO_FATAL_FAILURE(from_menu("view.kept:Gloss"));
  ASSERT_NO_FATAL_FAILURE(from_menu("views_change"));
  ASSERT_NO_FATAL_FAILURE(press(w, "names:1"));
  display_.key("ctrl+a");
  display_.type("Slant");
  ASSERT_NO_FATAL_FAILURE(press(w, "dialog:Done"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).views[0].name == "Slant"; }));
  for (int i = 0; i < 3; ++i) display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == before; })) << "three undo steps restore the file";
}

TEST_F(LibraryTest, ThePictureIsLimitedByErrorOrByTime) {
  show_cloth();
  settings({{"inspector_tab", 2}});
  {
    Window w(display_, folder_, draft_, without_dialogs());
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    ASSERT_NO_FATAL_FAILURE(press(w, "inspector:Cloth"));
    ASSERT_TRUE(comes_true([&] { return w.has("look.tolerance"); }));
    ASSERT_NO_FATAL_FAILURE(press(w, "look.by:By time"));
    ASSERT_TRUE(comes_true([&] { return w.has("look.budget_ms") && !w.has("look.tolerance"); }));
    const auto [at, size] = w.place_of("look.budget_ms");
    display_.click({at.x + size.x * 0.6, at.y + size.y / 2});
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
  const auto kept = nlohmann::json::parse(bytes_of(folder_ / "config/weftlight/settings.json"));
  EXPECT_TRUE(kept["by_time"].get<bool>());
  EXPECT_NE(kept["picture_ms"].get<double>(), 60) << "the click moved the slider";
}

TEST_F(LibraryTest, ThreadsAreAssembledFromSections) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  const std::string before = w.live();
  display_.key("shift+w");
  ASSERT_TRUE(comes_true([&] { return w.has("sections.last"); }));
  const auto type_into = [&](const std::string& control, const std::string& text) {
    display_.click(w.middle_of(control));
    display_.key("ctrl+a");
    display_.type(text);
    display_.key("Tab");
  };
  type_into("sections.last", "8");
  ASSERT_NO_FATAL_FAILURE(press(w, "sections.take"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).warp_assembly.sections.size() == 1; }));
  EXPECT_EQ(design_of(w.live()).draft.ends(), 24) << "without an order the threads are unchanged";
  type_into("sections.first", "1");
  type_into("sections.last", "3");
  ASSERT_NO_FATAL_FAILURE(press(w, "sections.take"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).warp_assembly.sections.size() == 2; }));
  type_into("sections.order", "A 2x, (B A) 3x");
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 49; })) << "the draft follows";
  ASSERT_NO_FATAL_FAILURE(press(w, "sections.out:1"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).warp_assembly.order == "(B A) 3x"; }));
  EXPECT_EQ(design_of(w.live()).draft.ends(), 33);
  ASSERT_NO_FATAL_FAILURE(press(w, "dialog:Apply"));
  ASSERT_TRUE(comes_true([&] { return !w.has("sections.order"); }));
  display_.key("ctrl+z");
  EXPECT_TRUE(comes_true([&] { return w.live() == before; })) << "one undo step";
}

TEST_F(LibraryTest, AFaultyOrderKeepsTheSectionsOnThePage) {
  Window w(display_, folder_, draft_, without_dialogs());
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("shift+w");
  ASSERT_NO_FATAL_FAILURE(press(w, "sections.take"));
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).warp_assembly.sections.size() == 1; }));
  display_.click(w.middle_of("sections.order"));
  display_.type("A 2x, B");
  display_.key("Tab");
  display_.click(w.middle_of("dialog:Apply"));
  ASSERT_TRUE(w.has("sections.order")) << "the page with the section is gone";
  display_.click(w.middle_of("sections.order"));
  display_.key("ctrl+a");
  display_.type("A 2x");
  ASSERT_TRUE(comes_true([&] { return design_of(w.live()).draft.ends() == 48; }));
  display_.click(w.middle_of("dialog:Apply"));
  EXPECT_TRUE(comes_true([&] { return !w.has("sections.order"); }));
  EXPECT_EQ(design_of(w.live()).warp_assembly.order, "A 2x");
}

}  // namespace
}  // namespace weftlight::gui
