// Fonts that are installed are found by name.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "../scratch.h"
#include "../variable.h"
#include "platform/installed_fonts.h"
#include "platform/missing_font.h"

namespace weftlight::platform {
namespace {

TEST(Fonts, only_the_requested_family_is_found) {
  const char* const none[] = {"No Such Family 71"};
  EXPECT_EQ(font_file(none), "");
  const char* const some[] = {"No Such Family 71", "Inter", "DejaVu Sans", "Noto Sans"};
  const std::string regular = font_file(some), bold = font_file(some, FontWeight::kSemiBold);
  if (regular.empty()) GTEST_SKIP() << "none of these fonts is installed";
  EXPECT_TRUE(std::filesystem::exists(regular)) << regular;
  EXPECT_NE(regular, bold);
}

TEST(Fonts, a_face_has_the_letters_of_its_language) {
  const FontFace english = font_face_of_language("en");
  if (english.file.empty()) GTEST_SKIP() << "no font is installed";
  EXPECT_TRUE(std::filesystem::exists(english.file)) << english.file;
  EXPECT_GE(english.index, 0);
  EXPECT_EQ(font_face_of_language("xx-none").file, "") << "no font has the letters of no language";
}

TEST(Fonts, of_letters_that_no_font_has_one_is_named_to_install) {
  const Scratch scratch;
  std::ofstream(scratch / "fonts.conf") << "<?xml version=\"1.0\"?><fontconfig></fontconfig>";
  const Variable none("FONTCONFIG_FILE", scratch / "fonts.conf");
  for (const char* language : {"", "en", "de", "pt_BR", "jam"}) EXPECT_EQ(missing_font(language), "") << language;
  if (!font_face_of_language("ja").file.empty()) GTEST_SKIP() << "this system's fonts are not those of fontconfig";
  for (const char* language : {"ja", "ja_JP"})
    EXPECT_NE(missing_font(language).find("fonts-noto-cjk"), std::string::npos) << language;
}

}  // namespace
}  // namespace weftlight::platform
