// Each rule of the reader, on a file written for it.

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>

#include "draft/drawdown.h"
#include "lines.h"

namespace weftlight::wif {

using design::Design;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::drawdown, draft::kFromYarn;

namespace {

std::vector<std::string> cloth(const Draft& draft) {
  std::vector<std::string> lines;
  const BitMatrix cells = drawdown(draft);
  for (int pick = 0; pick < cells.rows(); ++pick) {
    lines.emplace_back();
    for (int end = 0; end < cells.cols(); ++end) lines.back() += cells.get(pick, end) ? '1' : '0';
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(read, twill_is_a_twill) {
  const WifFile file = opened(fixture("twill.wif"));
  const Draft& draft = file.design.draft;
  EXPECT_EQ(cloth(draft),
            (Lines{"11001100", "01100110", "00110011", "10011001", "11001100", "01100110", "00110011", "10011001"}));
  EXPECT_EQ(file.design.title, "Two and two twill");
  EXPECT_EQ(file.design.author, "A weaver");
  EXPECT_EQ(file.source_program, "Weftlight");
  EXPECT_EQ(file.design.notes, (Lines{"Sley two a dent.", "", "Wash warm."}));
  EXPECT_EQ(draft.palette.size(), 3u);
  EXPECT_EQ(draft.warp.color[4], 2);
  EXPECT_FLOAT_EQ(draft.warp.spacing_mm[0], 2.12f);
  EXPECT_FLOAT_EQ(draft.weft.thickness_mm[7], 2.0f);
}

TEST(read, every_line_end_gives_the_same_design) {
  const Design design = opened(fixture("twill.wif")).design;
  for (const char* name : {"twill_lf.wif", "twill_cr.wif", "mixed_ends.wif", "no_last_end.wif", "no_wif_header.wif"}) {
    EXPECT_TRUE(opened(fixture(name)).design == design) << name;
  }
}

TEST(read, sinking_shed_is_the_complement_of_the_tieup) {
  const WifFile file = opened(fixture("sinking.wif"));
  EXPECT_FALSE(file.design.draft.rising);
  EXPECT_EQ(cloth(file.design.draft)[0], "00110011");
}

TEST(read, ends_on_no_shaft_or_two_and_picks_of_no_treadle_or_two) {
  const WifFile file = opened(fixture("heddles.wif"));
  const Lines lines = cloth(file.design.draft);
  EXPECT_EQ(lines[0], "01111111");  // nothing is lowered; end 1 is on no shaft
  EXPECT_EQ(lines[1], "00001000");  // treadles 2 and 3 lower 2, 3, 4
  EXPECT_EQ(lines[3], "00100110");  // 1 and 4 are lowered, so end 2 (shafts 2 and 4) is down
}

TEST(read, untidy_file) {
  const WifRead read = read_wif(fixture("untidy.wif"));
  ASSERT_TRUE(read.file);
  const Design& design = read.file->design;
  EXPECT_EQ(read.file->source_program, "Hand ; not a comment");
  EXPECT_EQ(design.draft.ends(), 4);
  EXPECT_EQ(cloth(design.draft), (Lines{"1010", "1100", "1100", "0010"}));
  EXPECT_EQ(design.draft.palette, (std::vector<Rgb>{{1, 1, 1}, {0, 0, 0}}));
  EXPECT_TRUE(says(read, 36, "twice"));
  EXPECT_TRUE(says(read, 30, "not listed"));
}

TEST(read, tieup_and_liftplan) {
  EXPECT_FALSE(says(read_wif(fixture("both_agree.wif")), 92, "liftplan differs"));
  const WifRead differ = read_wif(fixture("both_differ.wif"));
  ASSERT_TRUE(differ.file);
  EXPECT_EQ(differ.file->design.draft.shed_control, ShedControl::kTreadling);
  bool named = false;
  for (const Diagnostic& d : differ.diagnostics) named = named || d.text.find("first at pick 2") != std::string::npos;
  EXPECT_TRUE(named);
  EXPECT_EQ(opened(fixture("liftplan.wif")).design.draft.shed_control, ShedControl::kLiftplan);
}

TEST(read, luminescence) {
  const WifFile file = opened(fixture("luminescence.wif"));
  const Draft& draft = file.design.draft;
  EXPECT_EQ(cloth(draft), (Lines{"1010", "0101", "0101", "1010"}));
  EXPECT_EQ(draft.warp.color, (std::vector<int>{0, 1, 0, 1}));
  EXPECT_EQ(draft.weft.color, (std::vector<int>{1, 1, 0, 0}));
  EXPECT_NEAR(static_cast<double>(draft.warp.spacing_mm[0]), 80 * 25.4 / 720, 1e-6);
}

TEST(read, counted_from_zero) {
  const Design design = opened(fixture("zero_based.wif")).design;
  EXPECT_EQ(cloth(design.draft), (Lines{"101", "010", "101"}));
  EXPECT_EQ(design.draft.warp.color, (std::vector<int>{0, 2, 0}));
  EXPECT_EQ(design.draft.weft.color, (std::vector<int>{1, 1, 1}));
  EXPECT_EQ(design.notes, (Lines{"first", "second"}));
}

TEST(read, a_row_0_beside_all_treadles_is_not_one_of_them) {
  const Draft draft = opened(
                          "[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=2\n[WEFT]\nThreads=1\n"
                          "[THREADING]\n1=1\n2=2\n[TIEUP]\n0=1\n1=1\n2=2\n[TREADLING]\n1=2\n")
                          .design.draft;
  EXPECT_EQ(draft.treadles, 2);
  EXPECT_EQ(cloth(draft), (Lines{"01"}));
}

TEST(read, measures_zooms_symbols_and_range) {
  const WifRead read = read_wif(fixture("measures.wif"));
  ASSERT_TRUE(read.file);
  const Draft& draft = read.file->design.draft;
  const float unit = static_cast<float>(25.4 / 720);
  EXPECT_FLOAT_EQ(draft.warp.spacing_mm[0], 80 * unit);
  EXPECT_FLOAT_EQ(draft.warp.spacing_mm[1], 40 * unit);
  EXPECT_FLOAT_EQ(draft.warp.spacing_mm[2], 160 * unit);
  EXPECT_FLOAT_EQ(draft.weft.spacing_mm[0], 1.27f);
  EXPECT_EQ(draft.weft.thickness_mm[0], kFromYarn);
  EXPECT_FLOAT_EQ(draft.weft.thickness_mm[1], 1.016f);
  EXPECT_FLOAT_EQ(draft.weft.thickness_mm[3], 2.54f);
  EXPECT_EQ(draft.palette[0], (Rgb{0, 0.5f, 1}));
  EXPECT_EQ(read.file->warp_symbols, (Lines{"X", "#", " ", "é"}));
  EXPECT_EQ(read.file->weft_symbols, (Lines{"o", "o", "o", "o"}));
}

TEST(read, two_color_draft_without_a_table) {
  const Draft draft = opened(fixture("two_color.wif")).design.draft;
  EXPECT_EQ(draft.palette, (std::vector<Rgb>{{1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(draft.warp.color[1], 0);
  EXPECT_EQ(draft.weft.color[1], 1);
}

TEST(read, encodings) {
  for (const char* name : {"latin1.wif", "utf8_bom.wif"}) {
    const Design design = opened(fixture(name)).design;
    EXPECT_EQ(design.title, "Körper für Ärmel") << name;
    EXPECT_EQ(design.notes[0], "Café “crème”") << name;
  }
  EXPECT_EQ(opened(fixture("utf8.wif")).design.author, "織る人");
}

TEST(read, missing_data_is_reported_with_its_line) {
  const WifRead read = read_wif(fixture("gaps.wif"));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.draft.shafts, 4);
  EXPECT_EQ(read.file->design.draft.treadles, 6);
  EXPECT_TRUE(says(read, 54, "shaft 4"));
  EXPECT_TRUE(says(read, 33, "Rising Shed"));
  EXPECT_TRUE(says(read, 33, "Treadles"));
  EXPECT_TRUE(says(read, 38, "color 9"));
  EXPECT_TRUE(says(read, 39, "Units"));
  EXPECT_TRUE(says(read, 0, "Range"));
}

TEST(read, rejects_what_is_not_a_draft) {
  const std::string rest = "[WARP]\nThreads=2\n[WEFT]\nThreads=";
  for (const std::string& bytes : {std::string(), std::string("hello"), std::string("\xFF\xFE[\0W\0", 6), rest + "0\n",
                                   rest + "100001\n", std::string("[WARP]\nThreads=99999\n[WEFT]\nThreads=99999\n"),
                                   rest + "2\n[WEAVING]\nShafts=5000\n", rest + "2\n[WEAVING]\nTreadles=5000\n"}) {
    const WifRead read = read_wif(bytes);
    EXPECT_FALSE(read.file) << bytes;
    ASSERT_FALSE(read.diagnostics.empty()) << bytes;
    bool error = false;
    for (const Diagnostic& d : read.diagnostics) error = error || (d.severity == Severity::kError && !d.remedy.empty());
    EXPECT_TRUE(error) << bytes;
  }
}

TEST(read, utf_16_is_named_in_either_order_of_its_bytes) {
  for (const char* mark : {"\xFF\xFE", "\xFE\xFF"}) {
    const WifRead read = read_wif(std::string(mark) + "[\n");
    EXPECT_FALSE(read.file);
    EXPECT_TRUE(says(read, 1, "UTF-16"));
  }
}

TEST(read, the_colour_that_is_taken_for_a_missing_one_is_named) {
  const WifRead read = read_wif(
      "[WARP]\nThreads=2\n[WEFT]\nThreads=2\n[COLOR PALETTE]\nRange=0,255\n[COLOR TABLE]\n1=0,0,0\n2=9,9,9\n"
      "[WARP COLORS]\n1=9\n");
  ASSERT_TRUE(read.file);
  const auto named = std::ranges::find_if(read.diagnostics, [](const Diagnostic& d) { return d.line == 11; });
  ASSERT_NE(named, read.diagnostics.end());
  EXPECT_EQ(named->remedy, "color 2 was used; correct one of them");
}

TEST(read, irregular_lines_are_reported) {
  const WifRead read = read_wif(fixture("odd_lines.wif"));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->source_program, "Weftlight") << "the first of two counts";
  EXPECT_EQ(read.file->design.draft.treadles, 4);
  EXPECT_EQ(cloth(read.file->design.draft), (Lines{"1100", "0110", "0011", "1001"}));
  EXPECT_EQ(read.file->design.notes, (Lines{"One", "Two"}));
  EXPECT_TRUE(says(read, 1, "comes before [WIF]"));
  EXPECT_TRUE(says(read, 2, "'a line of nobody's' comes before the first heading"));
  EXPECT_TRUE(says(read, 3, "[CONTENTS] comes before [WIF]"));
  EXPECT_TRUE(says(read, 12, "Weaving appears twice in [CONTENTS], with the value of line 4"));
  EXPECT_TRUE(says(read, 17, "Source Program appears twice in [WIF], with different values"));
  EXPECT_TRUE(says(read, 20, "'written by hand' in [TEXT] has no ="));
  EXPECT_TRUE(says(read, 25, "Shafts appears twice in [WEAVING], with the value of line 22"));
  EXPECT_TRUE(says(read, 26, "Treadles appears twice in [WEAVING], with different values"));
  EXPECT_TRUE(says(read, 29, "'Threads 8' in [WARP] has no ="));
  EXPECT_TRUE(says(read, 35, "[THREADING] line 2 appears twice, with different values"));
  EXPECT_TRUE(says(read, 36, "'3 3' in [THREADING] has no ="));
  EXPECT_TRUE(says(read, 39, "[THREADING] line 4 appears twice, with the same value"));
  EXPECT_TRUE(says(read, 45, "'4 4' in [TIEUP] has no = (and 1 more like it: line 46)"));
  EXPECT_TRUE(says(read, 54, "in [NOTES] has no ="));
}

TEST(read, similar_warnings_are_merged) {
  std::string bytes = "[WARP]\nThreads=1\n[WEFT]\nThreads=1\n[THREADING]\n";
  for (int i = 1; i < 1000; ++i) bytes += std::to_string(i) + "=1\n";
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  EXPECT_LT(read.diagnostics.size(), 20u);
  EXPECT_TRUE(says(read, 7, "997 more"));
}

TEST(read, a_long_tail_of_unused_threads_is_reported) {
  const WifRead read = read_wif("[WARP]\nThreads=1200\n[WEFT]\nThreads=3\n[THREADING]\n1=1\n2=2\n");
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.draft.ends(), 1200);
  EXPECT_TRUE(says(read, 1, "first 2 of 1200 ends"));
}

TEST(read, lists_that_end_before_the_last_thread_are_reported) {
  const std::string head = "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2\nTreadles=2\n[WARP]\nThreads=6\n",
                    rest =
                        "[WEFT]\nThreads=4\nColor=2\n[COLOR PALETTE]\nRange=0,255\n[COLOR TABLE]\n1=0,0,0\n2=9,9,9\n"
                        "[THREADING]\n1=1\n2=2\n3=1\n4=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n3=1\n"
                        "[WARP COLORS]\n1=1\n2=2\n[WEFT COLORS]\n1=1\n";
  const WifRead read = read_wif(head + rest);
  EXPECT_TRUE(says(read, 20, "[THREADING] ends with line 4, but there are 6 threads"));
  EXPECT_TRUE(says(read, 27, "[TREADLING] ends with line 3, but there are 4 threads"));
  EXPECT_TRUE(says(read, 30, "[WARP COLORS] ends with line 2, but there are 6 threads"));
  EXPECT_FALSE(says(read, 32, "[WEFT COLORS] ends")) << "Color= gives the others theirs";
  EXPECT_FALSE(says(read_wif(head + "Color=1\n" + rest), 31, "[WARP COLORS] ends"));
  EXPECT_EQ(write_wif(*read.file, read.file->design), head + rest) << "nothing is mended unasked";
  EXPECT_FALSE(says(read_wif(head + "[THREADING]\n0=1\n5=2\n" + rest.substr(0, rest.find("[THREADING]"))), 10,
                    "[THREADING] ends"))
      << "counted from 0";
}

// Time for such files: tests/bench (read_sections, read_yarns).
TEST(read, fifty_thousand_sections_are_kept_unchanged) {
  constexpr int kSections = 50000;
  const std::string twill = fixture("twill.wif");
  std::string bytes = twill;
  for (int i = 0; i < kSections; ++i)
    bytes += "[PRIVATE X " + std::to_string(i) + "]\r\nA=" + std::to_string(i) + "\r\n";
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file);
  EXPECT_TRUE(read.file->design == opened(twill).design);
  EXPECT_LE(read.diagnostics.size(), 1u);  // one for all sections missing in [CONTENTS]
  EXPECT_EQ(write_wif(*read.file, read.file->design), bytes);
  Design edited = read.file->design;
  edited.title = "Another";
  const std::string after = write_wif(*read.file, edited);
  EXPECT_EQ(after.substr(after.find("[PRIVATE X 0]")), bytes.substr(bytes.find("[PRIVATE X 0]")));
  EXPECT_TRUE(opened(after).design == edited);
}

// Yarns beyond 4096 were lost, of which a draft may have more.
TEST(read, as_many_yarns_as_stated_but_no_more_than_a_draft_may_have) {
  constexpr int kNamed = 5000;
  for (const auto& [stated, read] : {std::pair(kNamed, kNamed), std::pair(2'000'000'000, draft::kMaxColors)}) {
    std::string bytes = fixture("twill.wif") + "[PRIVATE WEFTLIGHT YARNS]\r\nYarns=" + std::to_string(stated) + "\r\n";
    for (int i = 1; i <= kNamed; ++i) bytes += std::to_string(i) + " Name=Y" + std::to_string(i) + "\r\n";
    const WifFile file = opened(bytes);
    ASSERT_EQ(file.design.yarns.size(), static_cast<size_t>(read)) << stated;
    EXPECT_EQ(file.design.yarns[kNamed - 1].name, "Y5000");
    EXPECT_EQ(write_wif(file, file.design), bytes) << stated;
  }
}

TEST(read, a_wrong_value_is_told_with_its_thread) {
  const auto told = [](const std::string& from, const std::string& to) {
    std::string bytes = fixture("twill.wif");
    const size_t at = bytes.find(from);
    if (at == std::string::npos) return "there is no " + from;
    bytes.replace(at, from.size(), to);
    std::string all;
    for (const Diagnostic& d : read_wif(bytes).diagnostics) all += d.text + "\n";
    return all;
  };
  EXPECT_EQ(told("[THREADING]\r\n1=1\r\n", "[THREADING]\r\n1=first\r\n"),
            "[THREADING] end 1: 'first' is not the number of a shaft\n");
  EXPECT_EQ(told("[THREADING]\r\n1=1\r\n", "[THREADING]\r\n1=1, x ,3\r\n"),
            "[THREADING] end 1: 'x' is not the number of a shaft\n");
  EXPECT_EQ(told("[THREADING]\r\n1=1\r\n", "[THREADING]\r\n1=-7\r\n"), "[THREADING] end 1 names shaft -7\n");
  EXPECT_EQ(told("[TIEUP]\r\n1=1,", "[TIEUP]\r\n1=one,"), "[TIEUP] treadle 1: 'one' is not the number of a shaft\n");
  EXPECT_EQ(told("[TREADLING]\r\n1=", "[TREADLING]\r\n1=left "),
            "[TREADLING] pick 1: 'left 1' is not the number of a treadle\n");
  const std::string thick = told("[WARP]\r\n", "[WARP THICKNESS]\r\n3=thick\r\n[WARP]\r\n");
  EXPECT_NE(thick.find("[WARP THICKNESS] 3=: 'thick' is not a usable number\n"), std::string::npos) << thick;
  EXPECT_EQ(told("[THREADING]\r\n1=1\r\n", "[THREADING]\r\n1=1, ; the first\r\n"), "");
}

TEST(read, the_locale_does_not_matter) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_NUMERIC, name)) break;
  }
  const WifFile file = opened(fixture("twill.wif"));
  EXPECT_FLOAT_EQ(file.design.draft.warp.spacing_mm[0], 2.12f);
  EXPECT_NE(write_new_wif(file.design).find("Spacing=0.212\r\n"), std::string::npos);
  std::setlocale(LC_NUMERIC, before.c_str());
}

}  // namespace
}  // namespace weftlight::wif
