// --language before and after the verb: the texts come from the catalogue in $WEFTLIGHT_LANGUAGES.

#include <sys/wait.h>

#include <cstdint>
#include <cstdlib>
#include <utility>

#include "paths.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::read_file;

namespace {

constexpr const char* kEnglish = "Print the counts, floats, repeat and warnings of a draft";
constexpr const char* kGerman = "Fadenzahlen, Flottungen, Rapport und Warnungen einer Patrone";
constexpr const char* kRequired = "{option} is required ({what})";
constexpr const char* kRequiredInGerman = "{option} fehlt ({what})";

/// A catalogue of gettext (.mo) with the texts, sorted by the key; the first key is empty, for the header.
std::string catalogue_of(const std::vector<std::pair<std::string, std::string>>& texts) {
  const auto word = [](uint32_t value) { return std::string(reinterpret_cast<const char*>(&value), sizeof value); };
  const auto count = static_cast<uint32_t>(texts.size());
  constexpr uint32_t kHeader = 28;
  std::string keys, values, strings;
  const uint32_t first = kHeader + count * 16;
  const auto add = [&](std::string& table, const std::string& text) {
    table += word(static_cast<uint32_t>(text.size())) + word(first + static_cast<uint32_t>(strings.size()));
    strings += text + '\0';
  };
  for (const auto& [key, value] : texts) add(keys, key), add(values, value);
  return word(0x950412de) + word(0) + word(count) + word(kHeader) + word(kHeader + count * 8) + word(0) +
         word(kHeader + count * 16) + keys + values + strings;
}

class Language : public ScratchFolder {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(path("languages/de/LC_MESSAGES"));
    written("languages/de/LC_MESSAGES/weftlight.mo", catalogue_of({{"", "Content-Type: text/plain; charset=UTF-8\n"},
                                                                   {kEnglish, kGerman},
                                                                   {kRequired, kRequiredInGerman}}));
  }
  /// What `weftlight ARGS` writes, where it ends with this code.
  std::string printed(const std::string& args, int code = kDone) {
    const std::string line = "WEFTLIGHT_LANGUAGES='" + path("languages") + "' LC_ALL=C.UTF-8 LANGUAGE= '" +
                             WEFTLIGHT_BINARY "' " + args + " >'" + path("out") + "' 2>&1";
    const int status = std::system(line.c_str());
    EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, code) << line;
    return read_file(path("out")).value_or("");
  }
};

TEST_F(Language, comes_from_the_option_before_or_after_the_verb) {
  for (const char* args :
       {"--language de info --help", "info --language de --help", "info --help --language=de", "--language=de --help"})
    EXPECT_NE(printed(args).find(kGerman), std::string::npos) << args << "\n" << printed(args);
}

TEST_F(Language, is_that_of_what_is_wrong_with_the_arguments) {
  EXPECT_NE(printed("--language de info", kUsage).find("weftlight info: FILE fehlt ("), std::string::npos);
  EXPECT_NE(printed("info", kUsage).find("weftlight info: FILE is required ("), std::string::npos);
}

TEST_F(Language, is_english_without_the_option_or_without_a_catalogue) {
  for (const char* args : {"info --help", "info --language fr --help"})
    EXPECT_NE(printed(args).find(kEnglish), std::string::npos) << args << "\n" << printed(args);
}

TEST_F(Language, changes_nothing_that_a_verb_does) {
  const std::string draft = fixture_path("twill.wif");
  const Ran plain = run({"info", "--json", draft});
  EXPECT_EQ(run({"--language", "de", "info", "--json", draft}).out, plain.out);
  EXPECT_EQ(run({"info", "--json", draft, "--language=de"}).out, plain.out);
  EXPECT_EQ(run({"--language", "de"}).code, -1) << "the editor opens";
  EXPECT_EQ(run({"--language", "de", "rendr"}).code, kUsage);
}

TEST_F(Language, that_is_not_a_name_is_bad_usage) {
  const std::string draft = fixture_path("twill.wif");
  for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{
           {"--language", "../de", "info", draft}, {"info", draft, "--language"}, {"info", draft, "--language", ""}})
    EXPECT_EQ(run(args).code, kUsage) << ::testing::PrintToString(args);
}

}  // namespace
}  // namespace weftlight::commands
