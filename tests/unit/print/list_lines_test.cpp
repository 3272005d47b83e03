// Lines of the printed lists: colours by number, repeats, the table of sleyings.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "design/edits.h"
#include "print/lines.h"
#include "print/pen.h"
#include "print/print.h"

namespace weftlight::print {

using design::Design, design::with_size;

namespace {

/// A straight draw, all of colour 0 in the warp and 1 in the weft.
Design straight(int threads, int shafts) {
  Design d = with_size(Design{}, threads, threads, shafts, shafts);
  d.draft.threading = draft::BitMatrix(threads, shafts), d.draft.treadling = draft::BitMatrix(threads, shafts);
  for (int i = 0; i < threads; ++i)
    d.draft.threading.set(i, i % shafts, true), d.draft.treadling.set(i, i % shafts, true);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}, {0.2f, 0.4f, 0.6f}};
  d.draft.warp.color.assign(static_cast<size_t>(threads), 0);
  d.draft.weft.color.assign(static_cast<size_t>(threads), 1);
  for (draft::Threads* t : {&d.draft.warp, &d.draft.weft}) t->yarn.assign(static_cast<size_t>(threads), 0);
  return d;
}

PrintOptions with_parts(const PrintParts& parts) {
  PrintOptions o;
  o.parts = parts;
  return o;
}
constexpr PrintParts kLists{.grids = false, .heddles = false, .yarn = false, .swatch = false, .plan = false};
constexpr PrintParts kListsAndPlan{.grids = false, .heddles = false, .yarn = false, .swatch = false};
constexpr PrintParts kAllLists{.grids = false, .swatch = false};

/// "1-4: 1 2 3 4", "[2] 24" for 24 threads of the second colour; with the short dash of a file.
std::string text_of(const ListLine& line) {
  std::string text = line.head;
  for (size_t at; (at = text.find("\xE2\x80\x93")) != std::string::npos;) text.replace(at, 3, "-");
  if (!line.words.empty()) text.append(":");
  for (const Word& word : line.words) {
    if (word.color >= 0) text.append(" [").append(number_of_color(word.color)).append("]");
    text.append(" ").append(word.text);
  }
  return text;
}

using Texts = std::vector<std::string>;

/// Lines below a heading; none if there is no such list.
Texts list_under(const Design& design, const PrintParts& parts, const std::string& heading) {
  const std::vector<ListLine> lines = list_lines(design, design.draft, with_parts(parts));
  auto at = std::ranges::find_if(lines, [&](const ListLine& l) { return l.heading() && l.head == heading; });
  Texts texts;
  if (at == lines.end()) return texts;
  for (++at; at != lines.end() && !at->heading(); ++at) texts.push_back(text_of(*at));
  return texts;
}

TEST(ListLines, AStraightDrawIsListedOnce) {
  EXPECT_EQ(list_under(straight(276, 4), kLists, "Threading, shaft of each end"),
            (Texts{"1-4: 1 2 3 4", ": repeat all 69 times"}));
  EXPECT_EQ(list_under(straight(50, 4), kLists, "Treadling, treadle of each pick"),
            (Texts{"1-4: 1 2 3 4", ": repeat all 12 times", ": then", "49-50: 1 2"}));
  EXPECT_EQ(list_under(straight(8, 4), kLists, "Threading, shaft of each end"), (Texts{"1-8: 1 2 3 4 1 2 3 4"}))
      << "no shorter";
}

TEST(ListLines, ColoursAreNumberedAndTheirRepeatsFolded) {
  Design d = straight(120, 4);
  for (size_t i = 0; i < 120; ++i) d.draft.weft.color[i] = i % 2 == 0 ? 1 : 2;
  EXPECT_EQ(list_under(d, kLists, "Weft colours"), (Texts{"1-2: [2] 1 [3] 1", ": repeat all 60 times"}));
  EXPECT_EQ(list_under(d, kLists, "Warp colours"), (Texts{"1-120: [1] 120"}));
}

TEST(ListLines, EachColourIsNamedOnce) {
  Design d = straight(24, 4);
  d.draft.weft.color[5] = 2;
  d.yarns.resize(1);
  d.yarns.front().name = "Cotton";
  const Texts named{"#000000: [1] Cotton", "#FFFFFF: [2] Cotton", "#336699: [3] Cotton"};
  EXPECT_EQ(list_under(d, kLists, "Colours"), named);
  EXPECT_EQ(list_under(d, kListsAndPlan, "Colours"), named);
  EXPECT_EQ(list_under(d, kAllLists, "Colours"), Texts{}) << "the yarns to buy name them";
  const Texts bought = list_under(d, kAllLists, "Yarn to buy");
  for (const char* start : {"#000000: [1] ", "#FFFFFF: [2] ", "#336699: [3] "})
    EXPECT_TRUE(std::ranges::any_of(bought, [&](const std::string& t) { return t.starts_with(start); })) << start;
}

TEST(ListLines, TheNumberOfAColourIsPrinted) {
  Design d = straight(24, 4);
  d.draft.palette = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  PrintOptions o = with_parts(kLists);
  const std::vector<uint32_t> first = picture_of_sheet(d, o, 0, 4)->pixels;
  d.draft.warp.color.assign(24, 2);
  d.draft.weft.color.assign(24, 2);
  EXPECT_NE(picture_of_sheet(d, o, 0, 4)->pixels, first) << "squares of one colour";
}

TEST(ListLines, TheWarpIsListedOnceWhereThePlanHasIt) {
  Design d = straight(24, 4);
  EXPECT_EQ(list_under(d, kListsAndPlan, "Warp colour order"), (Texts{": [1] 24"}));
  EXPECT_EQ(list_under(d, kListsAndPlan, "Warp colours"), Texts{});
  d.plan.width_mm = 500;
  EXPECT_EQ(list_under(d, kListsAndPlan, "Warp colours"), (Texts{"1-24: [1] 24"}))
      << "the cloth is wider than the draft";
}

TEST(ListLines, RunsOfManyDigitsTakeMoreLines) {
  Design d = straight(6000, 4);
  for (size_t i = 0; i < 6000; ++i) d.draft.weft.color[i] = i < 1000 ? 2 : static_cast<int>(i / 1000 % 2);
  const Texts lines = list_under(d, kLists, "Weft colours");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].substr(0, 10), "4001-6000:") << "four runs of four digits fill a line";
}

TEST(ListLines, TheReedsOfTheTableDoNotTouch) {
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, 8, 8);
  cairo_t* context = cairo_create(image);
  cairo_font_options_t* as_on_paper = cairo_font_options_create();  // widths are not rounded to whole units
  cairo_font_options_set_hint_metrics(as_on_paper, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, as_on_paper);
  cairo_font_options_destroy(as_on_paper);
  const Pen pen(context);
  int words = 0;
  for (const double spacing : {0.3, 0.5, 0.8, 1.5}) {
    Design d = straight(24, 4);
    d.draft.warp.spacing_mm.assign(24, static_cast<float>(spacing));
    for (const Paper& paper : {kA4, Paper{148, 210}}) {
      PrintOptions o = with_parts(kAllLists);
      o.paper = paper;
      for (const ListLine& line : list_lines(d, d.draft, o)) {
        if (line.pitch_mm <= 0) continue;
        EXPECT_LE(kHeadWidth + line.pitch_mm * static_cast<double>(line.words.size()),
                  (paper.width_mm - 2 * kMargin - 8) / 2);
        for (const Word& word : line.words) {
          EXPECT_LT(pen.width_of(kTableSize, word.text) + 1, line.pitch_mm) << word.text;
          ++words;
        }
      }
    }
  }
  EXPECT_GT(words, 0);
  cairo_destroy(context);
  cairo_surface_destroy(image);
}

TEST(ListLines, ATableThatGoesOnHasItsHeadAgain) {
  std::vector<ListLine> lines{{"Sleying", {}}, {"Reed", {{"60/10"}}, 11, true}};
  for (int i = 1; i <= 20; ++i) lines.push_back({std::to_string(i), {{"6.0"}}, 11});
  size_t next = 0;
  const std::vector<ListLine> first = lines_of_column(lines, next, 45);
  ASSERT_EQ(first.size(), 10u);
  const std::vector<ListLine> second = lines_of_column(lines, next, 45);
  ASSERT_EQ(second.size(), 10u);
  EXPECT_EQ(second[0].head, "Reed");
  EXPECT_EQ(second[1].head, "9");
}

TEST(ListLines, AHeadingStaysWithItsLines) {
  const std::vector<ListLine> lines{{"A", {}}, {"", {{"1"}}}, {"", {{"2"}}}, {"B", {}}, {"", {{"3"}}}};
  size_t next = 0;
  EXPECT_EQ(lines_of_column(lines, next, 5 * 4.5).size(), 3u);
  next = 0;
  EXPECT_EQ(lines_of_column(lines, next, 6 * 4.5).size(), 5u) << "the last list has one line";
}

}  // namespace
}  // namespace weftlight::print
