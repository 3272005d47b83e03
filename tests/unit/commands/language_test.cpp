// --language before and after the verb: the texts come from the catalogue in $WEFTLIGHT_LANGUAGES.

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "../catalogue.h"
#include "base/languages.h"
#include "base/resources.h"
#include "paths.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::read_file;

namespace {

constexpr const char* kEnglish = "Print the counts, floats, repeat and warnings of a draft";
constexpr const char* kGerman = "Fadenzahlen, Flottungen, Rapport und Warnungen einer Patrone";
constexpr const char* kRequired = "{option} is required ({what})";
constexpr const char* kRequiredInGerman = "{option} fehlt ({what})";

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

TEST_F(Language, is_english_without_the_option_or_if_asked_for) {
  for (const char* args : {"info --help", "info --language en_GB --help"})
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

TEST_F(Language, that_is_not_installed_is_bad_usage_and_the_installed_ones_are_listed) {
  const std::string draft = "'" + fixture_path("twill.wif") + "'";
  for (const std::string& args : {std::string("--language klingon"), "--language=klingon " + draft,
                                  "info --language klingon " + draft, "--language klingon info " + draft}) {
    const std::string said = printed(args, kUsage);
    EXPECT_NE(said.find("there is no language 'klingon'; the languages are en (English), de (Deutsch)"),
              std::string::npos)
        << args << "\n"
        << said;
  }
}

std::string in_quotes(const std::string& path) {
  std::string quoted("'");
  return quoted.append(path).append("'");
}

/// The catalogues of the build, not one of this test.
class EachLanguage : public ScratchFolder {
 protected:
  /// Runs the program in a language; a system that counts with commas changes nothing either.
  void speak(const std::string& language, const std::string& args) {
    std::string line("env -u WEFTLIGHT_LANGUAGES LC_ALL=C.UTF-8 LANGUAGE= '" WEFTLIGHT_BINARY "' --language ");
    line.append(language).append(" ").append(args);
    line.append(" >").append(in_quotes(path("out"))).append(" 2>").append(in_quotes(path("said")));
    EXPECT_EQ(std::system(line.c_str()), 0) << line << "\n" << read_file(path("said")).value_or("");
  }
  /// Everything that the program writes for other programs, one after the other.
  std::string written_in(const std::string& language) {
    std::string all;
    const std::string draft = in_quotes(fixture_path("twill.wif"));
    const std::string wif = path(language + ".wif");
    speak(language, "weave point_twill --ends 20 --picks 20 -o " + in_quotes(wif));
    all += read_file(wif).value_or("no draft");
    speak(language, "analyse --json " + draft);
    return all + read_file(path("out")).value_or("no report");
  }
};

TEST_F(EachLanguage, writes_the_same_bytes_for_other_programs) {
  const std::vector<base::Language> languages = base::installed_languages(base::languages_dir());
  ASSERT_GE(languages.size(), 3U) << "English, German and Dutch at least";
  const std::string english = written_in("en");
  EXPECT_NE(english.find('.'), std::string::npos) << "the test needs a number with a fraction";
  for (const base::Language& each : languages) EXPECT_EQ(written_in(each.code), english) << each.code;
}

TEST_F(EachLanguage, shows_numbers_as_it_writes_them) {
  const std::string draft = in_quotes(fixture_path("twill.wif"));
  speak("en", "analyse " + draft);
  const std::string english = read_file(path("out")).value_or("");
  speak("de", "analyse " + draft);
  const std::string german = read_file(path("out")).value_or("");
  EXPECT_NE(english.find(" 0.50"), std::string::npos) << english;
  EXPECT_NE(german.find(" 0,50"), std::string::npos) << german;
}

}  // namespace
}  // namespace weftlight::commands
