// The languages that a user can choose, and how far each is.

#include "base/languages.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "../catalogue.h"
#include "../scratch_fixture.h"
#include "base/translated.h"

namespace weftlight::base {
namespace {

TEST(Languages, names_lead_nowhere_else) {
  for (const char* name : {"de", "pt_BR", "sr@latin", "zh-Hans"}) EXPECT_TRUE(is_language_name(name)) << name;
  for (const char* name : {"", "../de", "de/x", ".de", "-de", "d e"}) EXPECT_FALSE(is_language_name(name)) << name;
}

TEST(Translated, only_a_figure_that_is_shown_as_1_is_one) {
  EXPECT_STREQ(tr_n("{count} texel", "{count} texels", "1"), "{count} texel");
  for (const char* shown : {"0.6667", "1.5", "0", "11"})
    EXPECT_STREQ(tr_n("{count} texel", "{count} texels", shown), "{count} texels") << shown;
}

class InstalledLanguages : public ScratchTest {
 protected:
  void add(const std::string& code, int texts) const {
    std::vector<std::pair<std::string, std::string>> all{{"", "Content-Type: text/plain; charset=UTF-8\n"}};
    for (int i = 0; i < texts; ++i) all.emplace_back("text " + std::to_string(i), "words");
    std::filesystem::create_directories(dir_ / code / "LC_MESSAGES");
    written(code + "/LC_MESSAGES/weftlight.mo", catalogue_of(all));
  }
};

TEST_F(InstalledLanguages, have_their_own_names_and_say_how_far_they_are) {
  add("en", 200), add("sv", 200), add("de", 199), add("tlh", 50);
  written("de/notes.txt", "");
  std::filesystem::create_directories(dir_ / "fr");
  std::string all;
  for (const Language& each : installed_languages(dir_.string())) all += shown_name(each) + "; ";
  EXPECT_EQ(all, "English; Deutsch (unfinished, 99%); Svenska; tlh (unfinished, 25%); ");
}

TEST_F(InstalledLanguages, are_found_by_longer_names) {
  add("de", 3), add("pt_BR", 3);
  const std::string folder = dir_.string();
  for (const char* name : {"en", "en_GB", "C", "de", "de_AT", "de_AT.UTF-8", "de@latin", "pt_BR", "pt_BR.UTF-8"})
    EXPECT_TRUE(has_language(folder, name)) << name;
  for (const char* name : {"", "klingon", "pt", "d", "deu", "../de", "fr_FR"})
    EXPECT_FALSE(has_language(folder, name)) << name;
}

TEST_F(InstalledLanguages, are_english_alone_without_catalogues) {
  written("de", "no folder");
  for (const std::string& folder : {dir_.string(), path("none")}) {
    ASSERT_EQ(installed_languages(folder).size(), 1U);
    EXPECT_EQ(installed_languages(folder)[0].code, "en");
  }
  std::filesystem::create_directories(dir_ / "fi/LC_MESSAGES");
  written("fi/LC_MESSAGES/weftlight.mo", "damaged");
  EXPECT_EQ(installed_languages(dir_.string()).size(), 1U);
}

}  // namespace
}  // namespace weftlight::base
