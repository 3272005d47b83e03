// Texts in the chosen language, by gettext. In a process of its own: the language is that of the whole program.

#include "platform/language.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>

#include "../catalogue.h"
#include "../scratch.h"
#include "platform/catalogue.h"

namespace weftlight::platform {
namespace {

std::string all_texts() {
  return std::string(translated("Open")) + "|" + translated("menu", "Open") + "|" + translated("menu", "Close") + "|" +
         translated("one end", "many ends", 1) + "|" + translated("one end", "many ends", 5) + "|" + translated("") +
         "|" + translated("Not in it") + "|" + catalogue_language();
}

class Language : public ::testing::Test {
 protected:
  Language() {
    const std::filesystem::path messages = scratch_ / "sv/LC_MESSAGES";
    std::filesystem::create_directories(messages);
    std::ofstream(messages / "weftlight.mo", std::ios::binary) << catalogue_of(
        {{"", "Content-Type: text/plain; charset=UTF-8\nLanguage: sv\nPlural-Forms: nplurals=2; plural=(n != 1);\n"},
         {"Open", "\xC3\x96ppna"},
         {"menu\004Open", "\xC3\x96ppen"},
         {std::string("one end\0many ends", 17), std::string("en tr\xC3\xA5"
                                                             "d\0flera",
                                                             14)}});
  }
  const Scratch scratch_{"language"};
};

TEST_F(Language, IsTheChosenOneOrEnglish) {
  const std::string folder = scratch_ / ".";
  const auto says = [&folder](const std::string& language) {
    EXPECT_EXIT(
        {
          use_language(language, folder);
          std::fprintf(stderr, "%s", all_texts().c_str());
          std::exit(0);
        },
        ::testing::ExitedWithCode(0),
        language == "sv" ? "\xC3\x96ppna.\xC3\x96ppen.Close.en tr\xC3\xA5"
                           "d.flera..Not in it.sv"
                         : "Open.Open.Close.one end.many ends..Not in it.");
  };
  says("sv");
  says("zz");
}

}  // namespace
}  // namespace weftlight::platform
