// The language of the window: chosen in a menu, kept, and without a trace in what is saved.

#include <gtest/gtest.h>

#include "on_display.h"

namespace weftlight::gui {
namespace {

class LanguageTest : public OnDisplay {
 protected:
  /// Paints, saves, and gives the draft back as it was. The saved bytes.
  std::string painted_and_saved(const Window& w) const {
    const std::string before = bytes_of(draft_);
    paint(w);
    display_.focus();
    display_.key("ctrl+s");
    EXPECT_TRUE(comes_true([&] { return bytes_of(draft_) != before; })) << "not saved";
    return bytes_of(draft_);
  }
  static double width_of_menu(const Window& w) { return w.place_of("menu:Cloth").second.x; }
};

/// Texts of other languages are longer than the English ones.
TEST_F(LanguageTest, LongTextsStayInTheirDialogs) {
  const auto in = [](const char* language) {
    return std::vector<std::string>{"LC_ALL=C.UTF-8", std::string("LANGUAGE=") + language};
  };
  const auto right_of = [](const Window& w, const std::string& control) {
    const auto [at, size] = w.place_of(control);
    return at.x + size.x;
  };
  settings({{"language", "de"}});
  {
    Window w(display_, folder_, draft_, in("de"));
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    display_.key("shift+w");
    ASSERT_TRUE(comes_true([&] { return w.has("sections.none"); }));
    EXPECT_LE(right_of(w, "sections.none"), right_of(w, "sections.page:Treadling"));
  }
  settings({{"language", "fr"}, {"width", 900}, {"height", 600}});
  Window w(display_, folder_, draft_, in("fr"));
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.resize(900, 600);
  display_.key("ctrl+e");
  ASSERT_TRUE(comes_true([&] { return w.has("export.for:raw"); }));
  EXPECT_LE(right_of(w, "export.for:raw"), right_of(w, "export.alpha"));
}

TEST_F(LanguageTest, LongWordsStayInTheButtonsOverTheClothAndInTheLoomView) {
  double english = 0;
  settings({{"cloth", true}, {"language", "en"}});
  {
    Window w(display_, folder_, draft_);
    ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("views"); }));
    english = w.place_of("views").second.x;
  }
  settings({{"cloth", true}, {"language", "de"}});
  Window w(display_, folder_, draft_, {"LC_ALL=C.UTF-8", "LANGUAGE=de"});
  ASSERT_TRUE(comes_true([&] { return w.is_ready() && w.has("views"); }));
  EXPECT_GT(w.place_of("views").second.x, english) << "\"Ansichten\" is wider than \"Views\" and its button";
  display_.resize(900, 600);
  display_.key("F9");
  ASSERT_TRUE(comes_true([&] { return w.has("loom.progress"); }));
  EXPECT_TRUE(comes_true([&] {
    const auto [at, size] = w.place_of("loom.progress");
    return at.x + size.x <= 900 && at.y + size.y <= 600;
  })) << "how much is woven is cut";
}

TEST_F(LanguageTest, ASmallLoomViewHasRoomForALongRowWhereAProgramSpeaks) {
  const std::filesystem::path programs = folder_ / "bin";
  std::filesystem::create_directories(programs);
  put(programs / "spd-say", "#!/bin/sh\n");
  std::filesystem::permissions(programs / "spd-say", std::filesystem::perms::owner_all);
  for (const char* language : {"de", "sv", "es"}) {
    settings({{"language", language}});
    Window w(display_, folder_, draft_,
             {"LC_ALL=C.UTF-8", std::string("LANGUAGE=") + language, "PATH=" + programs.string()});
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); })) << language;
    display_.resize(900, 600);
    display_.key("F9");
    for (const char* control : {"loom.say", "loom.first_pick", "loom.done", "loom.say_steps", "loom.line"})
      EXPECT_TRUE(comes_true([&] {
        if (!w.has(control)) return false;
        const auto [at, size] = w.place_of(control);
        return at.x + size.x <= 900 && at.y + size.y <= 600;
      })) << control
          << " is cut in " << language;
    ASSERT_NO_FATAL_FAILURE(click(w, "loom.done"));
    EXPECT_TRUE(comes_true([&] { return !w.has("loom.done"); })) << language;
  }
}

TEST_F(LanguageTest, ALongNameThatIsCutIsToldByATip) {
  Window w(display_, folder_, draft_, {"LC_ALL=C.UTF-8", "LANGUAGE=de"});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  display_.key("ctrl+n");
  ASSERT_TRUE(comes_true([&] { return w.has("weave.find"); }));
  display_.click(w.middle_of("weave.find"));
  display_.type("Angeheftetes");
  ASSERT_TRUE(comes_true([&] { return w.has("weave:stitched") && !w.has("weave:twill"); }));
  display_.move(w.middle_of("weave:stitched"));
  EXPECT_TRUE(comes_true([&] { return w.has("tip"); })) << "\"Angeheftetes Doppelgewebe\" is not shown whole";
}

TEST_F(LanguageTest, WithoutAFontForItsLettersIsEnglishAndSaysSo) {
  const std::filesystem::path fonts = folder_ / "fonts.conf";
  put(fonts, R"(<?xml version="1.0"?><fontconfig><dir>/usr/share/fonts/opentype/inter</dir></fontconfig>)");
  const auto in = [&](const char* language) {
    return std::vector<std::string>{"LC_ALL=C.UTF-8", std::string("LANGUAGE=") + language,
                                    "FONTCONFIG_FILE=" + fonts.string()};
  };
  double english = 0;
  {
    Window w(display_, folder_, draft_, in("en"));
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    EXPECT_FALSE(w.has("message.refusal"));
    english = width_of_menu(w);
  }
  Window w(display_, folder_, draft_, in("ja"));
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_TRUE(comes_true([&] { return w.has("message.refusal"); })) << "nothing is said of it";
  EXPECT_EQ(width_of_menu(w), english);
}

TEST_F(LanguageTest, IsChosenInAMenuForTheNextStartAndChangesNoFile) {
  double english = 0;
  std::string saved;
  {
    Window w(display_, folder_, draft_, {"LC_ALL=C.UTF-8", "LANGUAGE="});
    ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
    english = width_of_menu(w);
    saved = painted_and_saved(w);
    ASSERT_NO_FATAL_FAILURE(click(w, "menu:Help"));
    ASSERT_NO_FATAL_FAILURE(click(w, "menu.Language"));
    ASSERT_NO_FATAL_FAILURE(click(w, "menu.language.de"));
    ASSERT_TRUE(comes_true([&] { return w.has("message"); })) << "the window does not say when";
    display_.focus();
    display_.key("ctrl+q");
    EXPECT_EQ(w.process().wait(), 0);
  }
  put(draft_, straight_draft());
  Window w(display_, folder_, draft_, {"LC_ALL=C.UTF-8", "LANGUAGE="});
  ASSERT_TRUE(comes_true([&] { return w.is_ready(); }));
  EXPECT_NE(width_of_menu(w), english) << "Gewebe is longer than Cloth";
  EXPECT_EQ(painted_and_saved(w), saved);
}

}  // namespace
}  // namespace weftlight::gui
