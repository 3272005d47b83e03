// Catalogues where there is no gettext: the same texts and forms of plurals as gettext finds.

#include "platform/without_gettext/compiled_catalogue.h"

#include <gtest/gtest.h>

#include <string>

#include "../catalogue.h"

namespace weftlight::platform {
namespace {

using std::string_literals::operator""s;

std::string said(const char* text) { return text != nullptr ? text : "nothing"; }

TEST(CompiledCatalogueTest, the_rules_of_plurals_are_those_of_c) {
  const auto forms = [](const char* rule) {
    std::string all;
    for (const uint64_t count : {0, 1, 2, 5, 11, 21, 22, 112})
      all += std::to_string(plural_form(rule, count).value_or(9));
    return all;
  };
  EXPECT_EQ(forms("(n != 1)"), "10111111");
  EXPECT_EQ(forms("n>1"), "00111111");
  EXPECT_EQ(forms("0"), "00000000");
  // Russian's, as gettext's manual gives it.
  EXPECT_EQ(forms("n%10==1 && n%100!=11 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2"), "20122012");
  EXPECT_EQ(plural_form("1 + n * 2 - n / 3", 7), 13u);
  EXPECT_EQ(plural_form("n / 0 + n % 0", 7), 0u);
  for (const char* none : {"", "n ==", "(n", "n n", "m", "?:"}) EXPECT_FALSE(plural_form(none, 1)) << none;
  EXPECT_FALSE(plural_form(std::string(100000, '('), 1));
  EXPECT_FALSE(plural_form(std::string(100000, '!'), 1));
}

TEST(CompiledCatalogueTest, texts_are_found_with_contexts_and_forms) {
  const CompiledCatalogue catalogue(catalogue_of({{"", "Language: sv\nPlural-Forms: nplurals=2; plural=(n != 1);\n"},
                                                  {"Open", "\xC3\x96ppna"},
                                                  {"menu\004Open", "\xC3\x96ppen"},
                                                  {"{n} pick\0{n} picks"s, "{n} inslag\0{n} inslagen"s}}));
  EXPECT_EQ(catalogue.field("Language"), "sv");
  EXPECT_EQ(catalogue.field("Lang"), "");
  EXPECT_EQ(said(catalogue.text("Open")), "\xC3\x96ppna");
  EXPECT_EQ(said(catalogue.text("menu\004Open")), "\xC3\x96ppen");
  EXPECT_EQ(said(catalogue.text("{n} pick", 1)), "{n} inslag");
  EXPECT_EQ(said(catalogue.text("{n} pick", 3)), "{n} inslagen");
  EXPECT_EQ(said(catalogue.text("Close")), "nothing");
  EXPECT_EQ(said(catalogue.text("Close", 2)), "nothing");
}

TEST(CompiledCatalogueTest, a_damaged_one_loses_what_is_damaged) {
  const std::string whole = catalogue_of({{"", "Language: sv\n"}, {"a", "b"}, {"c", "d"}});
  for (size_t length = 0; length < whole.size(); ++length) {
    const CompiledCatalogue cut(whole.substr(0, length));
    EXPECT_EQ(said(cut.text("c")), "nothing") << length;
  }
  EXPECT_EQ(said(CompiledCatalogue(whole).text("c")), "d");
}

}  // namespace
}  // namespace weftlight::platform
