// Printed drafts: number and content of the sheets, and extreme drafts.

#include "print/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "design/edits.h"
#include "print/sheets.h"
#include "weaves/weaves.h"

namespace weftlight::print {

using base::problem_of;
using design::Design, design::to_liftplan, design::with_purchase, design::with_size;
using draft::BitMatrix, draft::Rgb, draft::ShedControl, draft::Threads;
using weaves::overshot;

namespace {

Design overshot_design(int ends, int picks) {
  Design d = overshot({0, 1, 2, 3, 2, 1}, 4, {ends, picks});
  d.title = "Rose \xC3\xA4";
  return d;
}

TEST(Print, APdfOfASmallDraftIsADraftSheetAndLists) {
  const base::Result<Printed> p = printed(overshot_design(40, 40), PrintFormat::kPdf, {});
  ASSERT_EQ(problem_of(p), "");
  ASSERT_EQ(p->files.size(), 1u);
  EXPECT_TRUE(p->files[0].starts_with("%PDF"));
  EXPECT_EQ(p->sheets, 2);
}

TEST(Print, SvgAndPngAreOneFilePerSheet) {
  const base::Result<Printed> svg = printed(overshot_design(40, 40), PrintFormat::kSvg, {});
  ASSERT_EQ(problem_of(svg), "");
  ASSERT_EQ(svg->files.size(), static_cast<size_t>(svg->sheets));
  EXPECT_NE(svg->files[0].find("<svg"), std::string::npos);
  EXPECT_NE(svg->files[0].find("210mm"), std::string::npos) << "the size of the paper";
  PrintOptions coarse;
  coarse.png_dpi = 40;
  const base::Result<Printed> png = printed(overshot_design(40, 40), PrintFormat::kPng, coarse);
  ASSERT_EQ(problem_of(png), "");
  ASSERT_EQ(png->files.size(), static_cast<size_t>(png->sheets));
  EXPECT_EQ(png->files[0].substr(1, 3), "PNG");
}

TEST(Print, ALargeScaleTakesMoreSheetsAndTooManyAreRejected) {
  PrintOptions large;
  large.cell_mm = 5;
  const int one = printed(overshot_design(96, 96), PrintFormat::kPdf, {})->sheets;
  EXPECT_GT(printed(overshot_design(96, 96), PrintFormat::kPdf, large)->sheets, one);
  large.cell_mm = 20;
  const base::Result<Printed> refused = printed(overshot_design(900, 900), PrintFormat::kPdf, large);
  EXPECT_NE(problem_of(refused).find("choose a smaller scale"), std::string::npos);
}

TEST(Print, ExtremeDraftsPrint) {
  Design d = with_size(Design{}, 1, 1, 1, 1);
  EXPECT_EQ(problem_of(printed(d, PrintFormat::kPdf, {})), "");
  d = to_liftplan(overshot_design(30, 30));
  d.draft.warp.spacing_mm[3] = 0;
  PrintOptions letter;
  letter.paper = kLetter;
  letter.end1_right = true;
  letter.heavy_lines = 0;
  EXPECT_EQ(problem_of(printed(d, PrintFormat::kPdf, letter)), "");
  EXPECT_EQ(problem_of(printed(with_size(Design{}, 40, 40, 300, 40), PrintFormat::kPdf, {})), "")
      << "more shafts than a sheet";
}

TEST(Print, OnlySelectedPartsArePrinted) {
  const Design d = overshot_design(40, 40);
  PrintOptions o;
  o.parts = {true, false, false, false, false, false};
  EXPECT_EQ(printed(d, PrintFormat::kPdf, o)->sheets, 1) << "the grids alone";
  o.parts = {false, false, false, false, true, false};
  EXPECT_EQ(printed(d, PrintFormat::kPdf, o)->sheets, 1) << "the swatch alone";
  o.parts = {false, true, true, true, false, true};
  EXPECT_EQ(problem_of(printed(d, PrintFormat::kPdf, o)), "");
  o.parts = {false, false, false, false, false, false};
  EXPECT_EQ(problem_of(printed(d, PrintFormat::kPdf, o)), "nothing was selected for printing");
}

TEST(Print, ThePlannedClothAndTheNameArePrinted) {
  Design d = overshot_design(40, 40);
  d.title.clear();
  PrintOptions o, planned;
  const auto sheet = [&d](const PrintOptions& options) { return picture_of_sheet(d, options, 0, 2)->pixels; };
  // Each part says something of the plan: yarn, heddles, the plan itself.
  for (bool PrintParts::*part : {&PrintParts::yarn, &PrintParts::heddles, &PrintParts::plan}) {
    o.parts = {false, false, false, false, false, false};
    o.parts.*part = true;
    const std::vector<uint32_t> before = sheet(o);
    d.plan.width_mm = 2500;
    EXPECT_NE(sheet(o), before);
    d.plan.width_mm = 0;
    EXPECT_EQ(sheet(o), before);
  }
  o.parts = {false, false, false, true, false, false};
  const std::vector<uint32_t> metric = sheet(o);
  planned.parts = o.parts, planned.units = Units::kImperial;
  EXPECT_NE(sheet(planned), metric) << "yards and ounces";
  d.plan = with_purchase(d.plan, {d.yarns[0].name, 250, 0, 40});
  EXPECT_NE(sheet(o), metric) << "its cost";
  o.parts = {true, false, false, false, false, false};
  PrintOptions named = o;
  named.name = "towel";
  EXPECT_NE(sheet(named), sheet(o));
  d.title = "Towel";
  EXPECT_EQ(sheet(named), sheet(o)) << "its title is printed instead";
}

TEST(Print, PreviewOfASheet) {
  const Design d = overshot_design(96, 96);
  PrintOptions o;
  o.cell_mm = 5;
  const SheetPicture first = picture_of_sheet(d, o, 0, 2).value();
  EXPECT_EQ(first.sheets, printed(d, PrintFormat::kPdf, o)->sheets);
  EXPECT_EQ(first.width, 420);
  EXPECT_EQ(first.height, 594);
  ASSERT_EQ(first.pixels.size(), 420u * 594u);
  EXPECT_EQ(first.pixels.front(), 0xffffffffu) << "white margin";
  EXPECT_GT(std::count(first.pixels.begin(), first.pixels.end(), first.pixels.front()), 420 * 100);
  EXPECT_NE(first.pixels, picture_of_sheet(d, o, 1, 2)->pixels);
  EXPECT_EQ(picture_of_sheet(d, o, 999, 2)->sheet, first.sheets - 1) << "clamped to the last sheet";
  o.cell_mm = 20;
  EXPECT_NE(problem_of(picture_of_sheet(overshot_design(900, 900), o, 0, 2)), "");
}

TEST(Print, Pick1IsAtTheTopOrAtTheBottom) {
  // Of two picks all of warp and all of weft, the darker one is the first.
  Design d = with_size(Design{}, 8, 8, 2, 2);
  d.draft.palette = {{0, 0, 0}, {1, 1, 1}};
  for (int i = 0; i < 8; ++i) {
    d.draft.warp.color[static_cast<size_t>(i)] = 0;
    d.draft.weft.color[static_cast<size_t>(i)] = i < 4 ? 0 : 1;
  }
  PrintOptions o;
  o.parts = {true, false, false, false, false, false};
  o.cell_mm = 5;
  o.heavy_lines = 0;
  const SheetPicture down = picture_of_sheet(d, o, 0, 2).value();
  o.pick1_bottom = true;
  const SheetPicture up = picture_of_sheet(d, o, 0, 2).value();
  ASSERT_EQ(down.pixels.size(), up.pixels.size());
  // The colour bar of the weft: its dark half is first or last.
  const auto dark_above = [](const SheetPicture& s) {
    int64_t sum = 0, all = 0;
    for (int y = 0; y < s.height; ++y)
      for (int x = 0; x < s.width; ++x)
        if (s.pixels[static_cast<size_t>(y) * static_cast<size_t>(s.width) + static_cast<size_t>(x)] == 0xff000000u)
          sum += y, ++all;
    return static_cast<double>(sum) / static_cast<double>(std::max<int64_t>(all, 1));
  };
  EXPECT_LT(dark_above(down) + 20, dark_above(up)) << "at least ten millimetres lower";
}

TEST(Print, TheGridsAreArrangedAsInTheWindow) {
  // The palette is white, so that only marks are dark, not the bars and the drawdown.
  Design d = overshot_design(12, 12);
  for (Rgb& c : d.draft.palette) c = {1, 1, 1};
  PrintOptions o;
  o.parts = {true, false, false, false, false, false};
  o.cell_mm = 5;
  o.heavy_lines = 0;
  const auto marks = [&](const PrintOptions& asked) {
    const SheetPicture s = picture_of_sheet(d, asked, 0, 2).value();
    double x = 0, y = 0, all = 0;
    for (int row = 60; row < s.height; ++row)  // below the title
      for (int column = 0; column < s.width; ++column) {
        const size_t at = static_cast<size_t>(row) * static_cast<size_t>(s.width) + static_cast<size_t>(column);
        if (((s.pixels[at] >> 8) & 255) < 90) x += column, y += row, ++all;
      }
    return std::pair{x / std::max(all, 1.0), y / std::max(all, 1.0)};
  };
  const auto [right_x, above_y] = marks(o);
  o.end1_right = false;
  const auto [left_x, same_y] = marks(o);
  EXPECT_LT(std::abs(right_x - left_x), 20) << "the treadling is on the right in both cases";
  EXPECT_NEAR(same_y, above_y, 2);
  o.threading_below = true;
  EXPECT_GT(marks(o).second, above_y + 30) << "threading and tie-up below the drawdown";
}

/// Shares of red, green and blue among the pixels of the swatch.
std::array<double, 3> swatch_shares(const Design& design) {
  PrintOptions o;
  o.parts = {false, false, false, false, true, false};
  const SheetPicture s = picture_of_sheet(design, o, 0, 10).value();
  std::array<double, 3> count{};
  for (int y = 220; y < 780; ++y)  // the swatch lies from 20 mm to 80 mm
    for (int x = 150; x < 1950; ++x) {
      const uint32_t c = s.pixels[static_cast<size_t>(y) * static_cast<size_t>(s.width) + static_cast<size_t>(x)];
      const std::array<uint32_t, 3> rgb{c & 255, c >> 8 & 255, c >> 16 & 255};
      for (size_t i = 0; i < 3; ++i) count[i] += rgb[i] > 90 && rgb[(i + 1) % 3] < 60 && rgb[(i + 2) % 3] < 60 ? 1 : 0;
    }
  for (double& n : count) n /= 560.0 * 1800.0;
  return count;
}

TEST(Print, TheSwatchOfADoubleWeaveShowsItsFace) {
  // Two layers of plain weave, thread by thread in turn: the upper one red over green, the lower one blue.
  Design d = with_size(Design{}, 8, 8, 8, 8);
  d.draft.shed_control = ShedControl::kLiftplan;
  d.draft.threading = BitMatrix(8, 8), d.draft.liftplan = BitMatrix(8, 8);
  d.draft.palette = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int i = 0; i < 8; ++i) {
    d.draft.threading.set(i, i, true);
    d.draft.warp.color[static_cast<size_t>(i)] = i % 2 == 0 ? 0 : 2;
    d.draft.weft.color[static_cast<size_t>(i)] = i % 2 == 0 ? 1 : 2;
    for (int e = 0; e < 8; ++e) d.draft.liftplan.set(i, e, e % 2 != i % 2 ? e % 2 == 0 : (e / 2 + i / 2) % 2 == 0);
  }
  const auto [red, green, blue] = swatch_shares(d);
  EXPECT_LT(blue, 0.03) << "the lower layer";
  EXPECT_GT(red, 0.35);
  EXPECT_GT(green, 0.35);
}

TEST(Print, TheSwatchOfAClothWithoutGapsShowsNoPaper) {
  // Ends that fill their room, at places whose last bits differ.
  Design d = overshot_design(66, 66);
  d.draft.warp.spacing_mm.assign(66, 0.85f);
  d.draft.warp.thickness_mm.assign(66, 1);
  const std::vector<uint32_t> pixels = swatch_pixels(d, draft::drawdown(d.draft), {}, 2000, 100, 11.8);
  EXPECT_EQ(std::ranges::count(pixels, 0xffffffu), 0);
}

TEST(Print, TheSwatchOfAnOpenClothShowsThePaper) {
  Design d = with_size(Design{}, 4, 4, 2, 2);
  d.draft.palette = {{1, 0, 0}, {0, 0, 1}};
  d.draft.warp.color.assign(4, 0), d.draft.weft.color.assign(4, 1);
  for (Threads* threads : {&d.draft.warp, &d.draft.weft})
    threads->spacing_mm.assign(4, 1.5f), threads->thickness_mm.assign(4, 0.5f);
  const auto [red, green, blue] = swatch_shares(d);
  EXPECT_GT(red + blue, 0.3);
  EXPECT_LT(red + blue, 0.75) << "half the room of a thread and more is a gap";
}

TEST(Print, TheSwatchShowsThreadsThatWashingMoved) {
  // Ends that weave as pairs lie together, with gaps between the pairs.
  Design d = with_size(Design{}, 24, 24, 2, 2);
  for (Threads* threads : {&d.draft.warp, &d.draft.weft})
    threads->spacing_mm.assign(24, 1.0f), threads->thickness_mm.assign(24, threads == &d.draft.warp ? 0.4f : 0.2f);
  draft::BitMatrix cells(24, 24);
  for (int p = 0; p < 24; ++p)
    for (int e = 0; e < 24; ++e) cells.set(p, e, (e / 2 + p) % 2 == 0);
  PrintOptions o;
  o.end1_right = false;
  const int width = 480;  // 20 pixels an end; a row between two picks
  const std::vector<uint32_t> pixels = swatch_pixels(d, cells, o, width, 1, 20);
  const auto paper_between = [&](int end) {  // this one and the next
    const auto first = pixels.begin() + end * 20 + 10;
    return std::count(first, first + 20, 0xffffffu);
  };
  EXPECT_LT(paper_between(8), 8);
  EXPECT_GT(paper_between(9), 12);
}

TEST(Print, OneRepeatAndARangeOfSheets) {
  PrintOptions o;
  o.cell_mm = 4;
  o.parts = {true, false, false, false, false, false};
  const Design d = overshot_design(480, 480);
  const int all = printed(d, PrintFormat::kPdf, o)->sheets;
  ASSERT_GT(all, 3);
  o.first_sheet = 2, o.last_sheet = 3;
  EXPECT_EQ(printed(d, PrintFormat::kPdf, o)->sheets, 2);
  o.last_sheet = 0;
  EXPECT_EQ(printed(d, PrintFormat::kPdf, o)->sheets, all - 1);
  o.first_sheet = all + 1;
  EXPECT_NE(problem_of(printed(d, PrintFormat::kPdf, o)).find("there is no sheet"), std::string::npos);
  o.first_sheet = 3, o.last_sheet = 2;
  EXPECT_NE(problem_of(printed(d, PrintFormat::kPdf, o)).find("3, comes after"), std::string::npos);
  o.last_sheet = 0;
  o.first_sheet = 1;
  o.one_repeat = true;
  EXPECT_LT(printed(d, PrintFormat::kPdf, o)->sheets, all);
}

TEST(Print, SheetsOfSeveralFilesAreNumbered) {
  EXPECT_EQ(sheet_file("a/b.svg", 0, 1), "a/b.svg");
  EXPECT_EQ(sheet_file("a/b.svg", 2, 3), "a/b-3.svg");
}

}  // namespace
}  // namespace weftlight::print
