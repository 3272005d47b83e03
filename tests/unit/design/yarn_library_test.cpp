// Yarns of one's own: the list as a text, and yarns in and out of a draft.

#include "design/yarn_library.h"

#include <gtest/gtest.h>

#include "design/edits.h"
#include "design/fibre.h"
#include "design/yarn_presets.h"

namespace weftlight::design {

using draft::blank_draft;

namespace {

LibraryYarn tuna() {
  LibraryYarn y;
  y.yarn = *with_count(yarn_presets()[4], "Nm 6/2");
  y.yarn.name = "Tuna", y.count = "Nm 6/2";
  y.yarn.lobes.specular_tint = {1, 0.2f, 0};
  y.cone_g = 100, y.price = 7.25f;
  y.colors = {{{0, 0, 1}, "Navy 3751"}, {{1, 1, 1}, ""}};
  y.note = "Borgs; L\xC3\xA4mm = lamb";
  return y;
}

YarnLibrary read(std::string_view text) {
  base::Result<YarnLibrary> library = read_yarn_library(text);
  EXPECT_TRUE(library) << problem_of(library);
  return library.value_or(YarnLibrary{});
}

TEST(YarnLibrary, IsWrittenAndReadAgain) {
  YarnLibrary library;
  library.head = {"# My yarns"};
  for (const Yarn& ready : ready_yarns()) library.yarns.push_back({ready});
  library.yarns.push_back(tuna());
  library.yarns.back().yarn.tex = 0, library.yarns.back().count.clear();
  library.yarns.push_back(tuna());
  library.yarns.back().yarn.dye = {{{12, draft::Rgb{0, 0, 1}, true}, {8, {}, false}}, -3, 2};
  const YarnLibrary again = read(yarn_library_text(library));
  EXPECT_TRUE(again.remarks.empty());
  EXPECT_EQ(again.head, library.head);
  EXPECT_EQ(again.yarns, library.yarns);
}

TEST(YarnLibrary, TextsBecomeOneLineAndColoursEightBits) {
  LibraryYarn y = tuna();
  y.yarn.name = " two\nlines ", y.note = "[Yarn]", y.yarn.lobes.specular_tint = {0.123f, 1, 1};
  const LibraryYarn written = as_written(y);
  EXPECT_EQ(written.yarn.name, "two lines");
  EXPECT_EQ(as_written(written), written);
}

TEST(YarnLibrary, AFewLinesByHandAreEnough) {
  const YarnLibrary library = read(
      "\xEF\xBB\xBF[yarn]\r\nname = Tuna\r\nCount=Nm 2/12\r\nFibre=wool\r\nPrice=7,25\r\n"
      "Cone Weight=100\r\ncolor=#0000ff Navy\r\n\r\n[Yarn]\r\n");
  ASSERT_EQ(library.yarns.size(), 2u);
  const LibraryYarn& y = library.yarns[0];
  EXPECT_EQ(y.yarn.name, "Tuna");
  EXPECT_EQ(y.count, "Nm 2/12") << "as it was written";
  EXPECT_EQ(y.yarn.plies, 2);
  EXPECT_EQ(y.yarn.fibre, Fibre::kWool);
  EXPECT_NEAR(y.yarn.tex, 166.67f, 0.01f);
  EXPECT_FLOAT_EQ(y.price, 7.25f);
  EXPECT_EQ(y.colors, (std::vector<YarnColor>{{{0, 0, 1}, "Navy"}}));
  EXPECT_EQ(library.yarns[1].yarn.fibre, Fibre::kCotton) << "cotton where nothing is said";
  EXPECT_TRUE(library.remarks.empty());
}

TEST(YarnLibrary, AReadyYarnIsBegunWithByItsName) {
  const YarnLibrary library = read(
      "[Yarn]\nName=A\nFibre=woollen yarn\n[Yarn]\nName=B\nFibre=Polyester\n"
      "[Yarn]\nName=C\nFibre=Polyester filament\n[Yarn]\nName=D\nFibre=Wool\n");
  ASSERT_EQ(library.yarns.size(), 4u);
  EXPECT_TRUE(library.remarks.empty());
  const Yarn &woollen = library.yarns[0].yarn, &wool = library.yarns[3].yarn;
  EXPECT_EQ(woollen.fibre, Fibre::kWool);
  EXPECT_GT(woollen.hairiness, wool.hairiness);
  EXPECT_EQ(wool.lobes, ready_yarn(Fibre::kWool).lobes);
  EXPECT_EQ(library.yarns[1].yarn.fibre, Fibre::kPolyester) << "as a list shows the fibre";
  EXPECT_EQ(library.yarns[1].yarn.lobes, library.yarns[2].yarn.lobes);
  EXPECT_NE(yarn_library_text(library).find("Fibre=Polyester filament\n"), std::string::npos) << "as files name it";
}

TEST(YarnLibrary, ACountIsChangedByHand) {
  std::string text = yarn_library_text({{}, {tuna()}, {}});
  EXPECT_EQ(text.find("Tex="), std::string::npos);
  EXPECT_EQ(text.find("Plies="), std::string::npos);
  text.replace(text.find("Nm 6/2"), 6, "Nm 6/3");
  const LibraryYarn y = read(text).yarns.at(0);
  EXPECT_NEAR(y.yarn.tex, 500, 0.01);
  EXPECT_EQ(y.yarn.plies, 3);
  EXPECT_EQ(y.count, "Nm 6/3");
}

TEST(YarnLibrary, WhatCannotBeReadIsSaidAndKept) {
  const std::string text =
      "; mine\n[Yarn]\nName=Odd\nCount=thick\nFibre=Alpaca\nColour=blue\nTwist=left\nTurns=many\n"
      "Shade Card=7\n# a comment\n[Colours]\nPrice=-3\n";
  const YarnLibrary library = read(text);
  ASSERT_EQ(library.yarns.size(), 1u);
  std::vector<int> lines;
  for (const LibraryRemark& remark : library.remarks) lines.push_back(remark.line);
  EXPECT_EQ(lines, (std::vector<int>{4, 5, 6, 7, 8, 9, 12}));
  const std::string again = yarn_library_text(library);
  for (const char* line : {"; mine\n", "Count=thick\n", "Fibre=Alpaca\n", "Colour=blue\n", "Twist=left\n",
                           "Turns=many\n", "Shade Card=7\n", "# a comment\n", "[Colours]\n", "Price=-3\n"})
    EXPECT_NE(again.find(line), std::string::npos) << line;
  EXPECT_EQ(yarn_library_text(read(again)), again);
}

TEST(YarnLibrary, AnotherFileIsRefused) {
  for (const char* text : {"[WIF]\nVersion=1.1\n", "name,count\nTuna,6/2\n", "[Yarn]\nName=\xE4\n"})
    EXPECT_FALSE(read_yarn_library(text)) << text;
  EXPECT_TRUE(read("").yarns.empty());
  EXPECT_TRUE(read("# nothing yet\n").yarns.empty());
  std::string many;
  for (size_t i = 0; i <= kMaxLibraryYarns; ++i) many += "[Yarn]\n";
  EXPECT_FALSE(read_yarn_library(many));
}

TEST(YarnLibrary, AYarnOfTheDraftIsKeptWithColoursAndPrice) {
  Design d;
  d.draft = blank_draft(3, 2, 2, 2);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}, {0, 0, 1}};
  d.yarns = {Yarn{}, tuna().yarn};
  d.draft.warp.yarn = {1, 1, 0}, d.draft.warp.color = {2, 0, 1};
  d.plan = with_purchase(d.plan, {"Tuna", 100, 0, 7.25f});
  const LibraryYarn kept = library_yarn_of(d, 1, 1);
  EXPECT_EQ(kept.yarn, d.yarns[1]);
  EXPECT_EQ(kept.count, "Nm 6/2");
  EXPECT_EQ(kept.colors, (std::vector<YarnColor>{{{0, 0, 0}, ""}, {{0, 0, 1}, ""}}));
  EXPECT_EQ(kept.cone_g, 100);
  EXPECT_EQ(kept.price, 7.25f);
  d.draft.warp.yarn = {0, 0, 0};
  EXPECT_EQ(library_yarn_of(d, 1, 2).colors, (std::vector<YarnColor>{{{0, 0, 1}, ""}})) << "the active colour";
}

TEST(YarnLibrary, TheSameYarnIsKeptOnce) {
  LibraryYarn bare{tuna().yarn, "Nm 6/2"};
  bare.colors = {{{1, 0, 0}, "Red"}, {{0, 0, 1}, ""}};
  LibraryYarn anna = tuna(), thin = tuna();
  anna.yarn.name = "anna", thin.yarn = *with_count(thin.yarn, "Nm 12/2"), thin.count = "Nm 12/2";
  const std::vector<LibraryYarn> all =
      with_library_yarn(with_library_yarn(with_library_yarn({tuna()}, bare), thin), anna);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].yarn.name, "anna") << "in the order of the names";
  EXPECT_EQ(all[1].price, 7.25f) << "there was no new one";
  EXPECT_EQ(all[1].note, tuna().note);
  EXPECT_EQ(all[1].colors, (std::vector<YarnColor>{{{0, 0, 1}, "Navy 3751"}, {{1, 1, 1}, ""}, {{1, 0, 0}, "Red"}}));
  EXPECT_EQ(all[2].count, "Nm 12/2");
}

TEST(YarnLibrary, ADraftHoldsWhatItUses) {
  Design d;
  d.draft = blank_draft(3, 2, 2, 2);
  const UsedYarn used = with_yarn_from(d, tuna(), 0);
  EXPECT_TRUE(is_consistent(used.design));
  EXPECT_EQ(used.design.yarns.at(static_cast<size_t>(used.yarn)), clamped(tuna().yarn));
  EXPECT_EQ(used.design.draft.palette.at(static_cast<size_t>(used.color)), (Rgb{0, 0, 1}));
  EXPECT_EQ(purchase_of(used.design.plan, "Tuna").price, 7.25f);
  const UsedYarn again = with_yarn_from(used.design, tuna(), 0);
  EXPECT_EQ(again.design, used.design) << "it is there already";
  EXPECT_EQ(again.yarn, used.yarn);
  EXPECT_EQ(with_yarn_from(d, tuna(), 9).color, -1);
}

TEST(YarnLibrary, IsSearchedByWords) {
  for (const char* typed : {"", "tuna", " TUN 6/2", "wool", "navy", "borgs lamb"})
    EXPECT_TRUE(matches(tuna(), typed)) << typed;
  for (const char* typed : {"silk", "tuna red"}) EXPECT_FALSE(matches(tuna(), typed)) << typed;
}

TEST(YarnLibrary, TwoByteOrderMarksDoNotBecomeText) {
  const auto read = read_yarn_library("\xEF\xBB\xBF\xEF\xBB\xBFWools\n[Yarn]\nName=Tuna\nCount=Nm 2/12\nFibre=Wool\n");
  ASSERT_TRUE(read);
  const auto again = read_yarn_library(yarn_library_text(*read));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->head, read->head);
}

}  // namespace
}  // namespace weftlight::design
