// An edit changes only the lines that it concerns.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "design/edits.h"
#include "draft/drawdown.h"
#include "lines.h"

namespace weftlight::wif {

using design::Design, design::Yarn, design::to_liftplan, design::to_treadling, design::with_liftplan,
    design::with_rising, design::with_size, design::with_thread_color, design::with_thread_spacing,
    design::with_thread_thickness, design::with_threading, design::with_tieup, design::with_treadling;
using draft::System, draft::drawdown, draft::kFromYarn;

namespace {

using Lines = std::vector<std::string>;

/// The lines an edit changes; checks that the result reads as the edited design.
LineDiff diff_of(const std::string& name, const std::function<void(Design&)>& edit) {
  const WifFile file = opened(fixture(name));
  Design now = file.design;
  edit(now);
  const std::string bytes = write_wif(file, now);
  EXPECT_TRUE(opened(bytes).design == now) << name << "\n" << bytes;
  return line_diff(file.bytes, bytes);
}

void expect_change(const LineDiff& diff, const Lines& removed, const Lines& added) {
  EXPECT_EQ(diff.removed, removed);
  EXPECT_EQ(diff.added, added);
}

TEST(edit, none_gives_the_same_bytes) {
  for (const std::string& name : fixture_names()) {
    const std::string bytes = fixture(name);
    const WifFile file = opened(bytes);
    EXPECT_EQ(write_wif(file, file.design), bytes) << name;
  }
}

TEST(edit, threading) {
  expect_change(diff_of("twill.wif", [](Design& d) { d = with_threading(d, 2, 0, true); }), {"3=3\r\n"}, {"3=1\r\n"});
  // Spacing around "=", several shafts, and both lines of a repeated key.
  expect_change(diff_of("untidy.wif", [](Design& d) { d.draft.threading.set(0, 2, true); }), {"1 = 1\n"},
                {"1 = 1,3\n"});
  expect_change(diff_of("untidy.wif", [](Design& d) { d = with_threading(d, 1, 3, true); }), {"2 = 2\n", "2 = 3\n"},
                {"2 = 4\n", "2 = 4\n"});
  expect_change(diff_of("untidy.wif", [](Design& d) { d = with_threading(d, 3, 3, true); }), {"4 =\n"}, {"4 =4\n"});
  expect_change(diff_of("luminescence.wif", [](Design& d) { d = with_threading(d, 0, 1, true); }), {"0=1\n"},
                {"0=2\n"});
}

TEST(edit, lines_without_a_key_stay) {
  const auto diff = [](const std::function<void(Design&)>& edit) { return diff_of("odd_lines.wif", edit); };
  expect_change(diff([](Design& d) { d = with_threading(d, 2, 0, true); }), {"3=3\r\n"}, {"3=1\r\n"});
  expect_change(diff([](Design& d) { d.notes.clear(); }), {"1=One\r\n", "2=Two\r\n"}, {});
  expect_change(diff([](Design& d) { d.title = "Other"; }), {"Title=Odd lines\r\n"}, {"Title=Other\r\n"});
  expect_change(diff([](Design& d) { d.title.clear(); }), {"Title=Odd lines\r\n"}, {});
}

TEST(edit, a_comment_behind_a_number_stays) {
  expect_change(diff_of("untidy.wif", [](Design& d) { d = with_treadling(d, 3, 0, true); }), {"4 = 4   ; a pick\n"},
                {"4 = 1   ; a pick\n"});
  expect_change(diff_of("untidy.wif", [](Design& d) { d = with_treadling(d, 3, 3, false); }), {"4 = 4   ; a pick\n"},
                {"4 = 0   ; a pick\n"});
}

TEST(edit, tieup_updates_the_liftplan_of_the_file) {
  expect_change(diff_of("twill.wif", [](Design& d) { d = with_tieup(d, 0, 2, true); }), {"1=1,2\r\n"}, {"1=1,2,3\r\n"});
  expect_change(diff_of("both_agree.wif", [](Design& d) { d = with_tieup(d, 0, 2, true); }),
                {"1=1,2\r\n", "1=1,2\r\n", "5=1,2\r\n"}, {"1=1,2,3\r\n", "1=1,2,3\r\n", "5=1,2,3\r\n"});
}

TEST(edit, treadles_counted_from_zero) {
  expect_change(diff_of("zero_based.wif", [](Design& d) { d = with_treadling(d, 1, 0, true); }), {"1=1\n"}, {"1=0\n"});
  expect_change(diff_of("zero_based.wif", [](Design& d) { d = with_treadling(d, 1, 1, false); }), {"1=1\n"}, {"1=\n"});
}

TEST(edit, liftplan) {
  expect_change(diff_of("liftplan.wif", [](Design& d) { d = with_liftplan(d, 5, 1, true); }), {"6=0\r\n"}, {"6=2\r\n"});
}

TEST(edit, text) {
  expect_change(diff_of("twill.wif", [](Design& d) { d.title = "Herringbone; my own"; }),
                {"Title=Two and two twill\r\n"}, {"Title=Herringbone; my own\r\n"});
  expect_change(diff_of("twill.wif", [](Design& d) { d.author.clear(); }), {"Author=A weaver\r\n"}, {});
  expect_change(diff_of("twill.wif", [](Design& d) { d.notes[1] = "Beat gently."; }), {"2=\r\n"},
                {"2=Beat gently.\r\n"});
  expect_change(diff_of("no_last_end.wif", [](Design& d) { d.notes.push_back("Full it."); }), {"3=Wash warm."},
                {"3=Wash warm.\r\n", "4=Full it."});
  expect_change(diff_of("luminescence.wif", [](Design& d) { d.title = "Steps"; }), {}, {"Title=Steps\n"});
}

TEST(edit, a_new_section_is_listed_in_contents) {
  expect_change(diff_of("liftplan.wif", [](Design& d) { d.title = "Point"; }), {},
                {"TEXT=true\r\n", "\r\n", "[TEXT]\r\n", "Title=Point\r\n"});
}

TEST(edit, a_new_section_that_contents_denies_is_listed) {
  std::string bytes = fixture("liftplan.wif");
  const std::string head = "[CONTENTS]\r\n";
  bytes.insert(bytes.find(head) + head.size(), "TEXT=false\r\n");
  const WifFile file = opened(bytes);
  Design now = file.design;
  now.title = "Point";
  expect_change(line_diff(file.bytes, write_wif(file, now)), {"TEXT=false\r\n"},
                {"TEXT=true\r\n", "\r\n", "[TEXT]\r\n", "Title=Point\r\n"});
}

TEST(edit, text_in_the_encoding_of_the_file) {
  expect_change(diff_of("latin1.wif", [](Design& d) { d.author = "Zoë"; }), {"Author=A weaver\r\n"},
                {"Author=Zo\xEB\r\n"});
  // A character that Latin-1 lacks converts the file to UTF-8; nothing else changes.
  const LineDiff diff = diff_of("latin1.wif", [](Design& d) { d.author = "織る人"; });
  expect_change(diff,
                {"Title=K\xF6rper f\xFCr \xC4rmel\r\n", "Author=A weaver\r\n",
                 "1=Caf\xE9 \x93"
                 "cr\xE8me\x94\r\n"},
                {"Title=Körper für Ärmel\r\n", "Author=織る人\r\n", "1=Café “crème”\r\n"});
  // Latin-1 bytes that happen to be UTF-8 would be read as such.
  diff_of("latin1.wif", [](Design& d) {
    d.title = "Ã©";
    d.notes.clear();
  });
}

TEST(edit, text_in_another_encoding_is_converted_whole) {
  const WifFile file =
      opened("[WARP]\nThreads=1\nUnits=cent\xEDmetros\nSpacing=1\n[WEFT]\nThreads=1\n[TREADLING]\n1=3\n[TIEUP]\n1=1\n");
  Design now = to_liftplan(file.design);
  now.title = "織る";
  EXPECT_TRUE(opened(write_wif(file, now)).design == now);
}

TEST(edit, text_that_one_line_cannot_hold) {
  const LineDiff diff = diff_of("twill.wif", [](Design& d) { d.title = "One\nTwo \\ three "; });
  EXPECT_EQ(diff.removed, (Lines{"Title=Two and two twill\r\n"}));
  EXPECT_EQ(diff.added[0], "PRIVATE WEFTLIGHT TEXT=true\r\n");
  EXPECT_EQ(diff.added[1], "Title=One Two \\ three\r\n");
}

TEST(edit, a_title_changed_by_another_program_is_kept) {
  const WifFile file = opened(fixture("twill.wif"));
  Design now = file.design;
  now.title = "One\nTwo";
  std::string bytes = write_wif(file, now);
  bytes.replace(bytes.find("Title=One Two"), 13, "Title=Theirs");
  EXPECT_EQ(opened(bytes).design.title, "Theirs");
}

TEST(edit, colors) {
  expect_change(diff_of("twill.wif", [](Design& d) { d = with_thread_color(d, System::kWeft, 3, 0); }), {"4=2\r\n"},
                {"4=1\r\n"});
  // In the file's own Range: 20..1200.
  expect_change(diff_of("measures.wif",
                        [](Design& d) {
                          d.draft.palette[0] = {1, 0, 0.5f};
                        }),
                {"1=20,610,1200\r\n"}, {"1=1200,20,610\r\n"});
  expect_change(diff_of("untidy.wif",
                        [](Design& d) {
                          d.draft.palette.push_back({0, 1, 0});
                        }),
                {"entries = 2\n"}, {"3 = 0,999,0\n", "entries = 3\n"});
  // One colour for a whole system without rows becomes its default; one thread gets a row.
  expect_change(
      diff_of("liftplan.wif", [](Design& d) { std::fill(d.draft.warp.color.begin(), d.draft.warp.color.end(), 0); }),
      {"Color=2\r\n"}, {"Color=1\r\n"});
  expect_change(diff_of("liftplan.wif", [](Design& d) { d = with_thread_color(d, System::kWarp, 2, 0); }), {},
                {"WARP COLORS=true\r\n", "\r\n", "[WARP COLORS]\r\n", "3=1\r\n"});
  expect_change(diff_of("luminescence.wif", [](Design& d) { d = with_thread_color(d, System::kWeft, 0, 0); }),
                {"1=2\n"}, {"1=1\n"});
}

TEST(edit, a_color_between_the_steps_of_range_is_kept_exactly) {
  const LineDiff diff = diff_of("twill.wif", [](Design& d) { d.draft.palette[1] = {0.1f, 0.2f, 0.3f}; });
  EXPECT_EQ(diff.removed, (Lines{"2=0,0,128\r\n"}));
  EXPECT_EQ(diff.added, (Lines{"PRIVATE WEFTLIGHT COLORS=true\r\n", "2=26,51,77\r\n", "\r\n",
                               "[PRIVATE WEFTLIGHT COLORS]\r\n", "2=0.1,0.2,0.3\r\n"}));
}

TEST(edit, measures_in_the_files_own_units) {
  expect_change(
      diff_of("twill.wif",
              [](Design& d) { std::fill(d.draft.warp.spacing_mm.begin(), d.draft.warp.spacing_mm.end(), 2.5f); }),
      {"Spacing=.212\r\n"}, {"Spacing=0.25\r\n"});
  expect_change(diff_of("twill.wif", [](Design& d) { d = with_thread_thickness(d, System::kWeft, 1, 4.0f); }), {},
                {"WEFT THICKNESS=true\r\n", "\r\n", "[WEFT THICKNESS]\r\n", "2=0.4\r\n"});
  expect_change(diff_of("measures.wif", [](Design& d) { d = with_thread_thickness(d, System::kWeft, 3, 5.08f); }),
                {"4=.1\r\n"}, {"4=0.2\r\n"});
  expect_change(diff_of("measures.wif", [](Design& d) { d = with_thread_spacing(d, System::kWarp, 0, 2.54f); }), {},
                {"1=72\r\n"});
  // From the yarn, where the file has a default.
  expect_change(diff_of("measures.wif", [](Design& d) { d = with_thread_spacing(d, System::kWarp, 1, kFromYarn); }),
                {"2=40\r\n"}, {"2=0\r\n"});
}

TEST(edit, a_new_file_has_units_where_it_has_measures) {
  Design design = opened(fixture("twill.wif")).design;
  for (draft::Threads* threads : {&design.draft.warp, &design.draft.weft}) {
    std::ranges::fill(threads->spacing_mm, kFromYarn);
    std::ranges::fill(threads->thickness_mm, kFromYarn);
  }
  EXPECT_EQ(write_new_wif(design).find("Units="), std::string::npos);
  Design spaced = design;
  spaced.draft.warp.spacing_mm[1] = 3;
  EXPECT_NE(write_new_wif(spaced).find("Units="), std::string::npos);
  EXPECT_EQ(opened(write_new_wif(spaced)).design.draft.warp.spacing_mm[1], 3);
  Design thick = design;
  thick.draft.weft.thickness_mm[2] = 4;
  EXPECT_NE(write_new_wif(thick).find("Units="), std::string::npos);
  EXPECT_EQ(opened(write_new_wif(thick)).design.draft.weft.thickness_mm[2], 4);
}

TEST(edit, size) {
  const LineDiff more = diff_of("twill.wif", [](Design& d) { d = with_size(d, 9, 8, 4, 4); });
  EXPECT_EQ(more.removed, (Lines{"Threads=8\r\n"}));
  EXPECT_EQ(more.added.size(), 3u);  // the count, the threading and the colour of end 9
  const LineDiff fewer = diff_of("twill.wif", [](Design& d) { d = with_size(d, 8, 6, 4, 4); });
  EXPECT_EQ(fewer.removed, (Lines{"Threads=8\r\n", "7=3\r\n", "8=4\r\n", "7=2\r\n", "8=2\r\n"}));
  EXPECT_EQ(fewer.added, (Lines{"Threads=6\r\n"}));
  expect_change(diff_of("twill.wif", [](Design& d) { d = with_size(d, 8, 8, 4, 5); }), {"Treadles=4\r\n"},
                {"Treadles=5\r\n", "5=0\r\n"});
  // Rows of other tables are removed with their threads.
  const LineDiff symbols = diff_of("measures.wif", [](Design& d) { d = with_size(d, 3, 4, 2, 2); });
  EXPECT_EQ(symbols.removed, (Lines{"Threads=4\r\n", "4=2\r\n", "4=4\r\n"}));
}

TEST(edit, rising_in_the_dialect_of_the_file) {
  expect_change(diff_of("untidy.wif", [](Design& d) { d = with_rising(d, false); }), {"rising shed = yes\n"},
                {"rising shed = no\n"});
  expect_change(diff_of("measures.wif", [](Design& d) { d = with_rising(d, false); }), {"Rising Shed=on\r\n"},
                {"Rising Shed=off\r\n"});
}

TEST(edit, shed_control) {
  for (const char* name : {"twill.wif", "both_agree.wif", "heddles.wif", "untidy.wif", "zero_based.wif"}) {
    const WifFile file = opened(fixture(name));
    const Design lifted = to_liftplan(file.design);
    const WifFile again = opened(write_wif(file, lifted));
    EXPECT_TRUE(again.design == lifted) << name;
    EXPECT_TRUE(drawdown(again.design.draft) == drawdown(file.design.draft)) << name;
    const Design treadled = to_treadling(again.design);
    EXPECT_TRUE(opened(write_wif(again, treadled)).design == treadled) << name;
  }
}

TEST(edit, unknown_lines_survive_a_change_of_shed_control) {
  const WifFile file = opened(fixture("untidy.wif"));
  const std::string bytes = write_wif(file, to_liftplan(file.design));
  for (const char* kept :
       {"; A comment before all\n", "free text\n Key = kept\n;\n", "[MY OWN]\nanything at all\n", "; straight\n"}) {
    EXPECT_NE(bytes.find(kept), std::string::npos) << kept;
  }
}

TEST(edit, what_wif_cannot_hold) {
  const LineDiff diff = diff_of("twill.wif", [](Design& d) {
    Yarn wool;
    wool.name = "Wool, Shetland";
    wool.diameter_mm = 0.7f;
    wool.lobes.specular_tint = {0.9f, 0.8f, 0.7f};
    d.yarns.push_back(wool);
    d.draft.warp.yarn[3] = 1;
    d.look.exposure_ev = 0.5f;
    d.scene.mesh = "skirt";
  });
  EXPECT_TRUE(diff.removed.empty());
  for (const char* line : {"PRIVATE WEFTLIGHT YARNS=true\r\n", "2 Diameter=0.7\r\n", "2 Tint=0.9,0.8,0.7\r\n",
                           "4=2\r\n", "Exposure=0.5\r\n", "Mesh=skirt\r\n"}) {
    EXPECT_NE(std::find(diff.added.begin(), diff.added.end(), line), diff.added.end()) << line;
  }
}

TEST(edit, a_count_is_one_line_and_only_where_it_is_set) {
  WifFile file = opened(fixture("twill.wif"));
  Design two = file.design;
  two.yarns.resize(2);
  two.yarns[1].name = "Chambray";
  const std::string old = write_wif(file, two);
  EXPECT_EQ(old.find("Tex="), std::string::npos) << "older files have no count";
  file = opened(old);
  EXPECT_EQ(write_wif(file, file.design), old);
  Design counted = file.design;
  counted.yarns[1].tex = 14.76f;
  const std::string with_count = write_wif(file, counted);
  expect_change(line_diff(old, with_count), {}, {"2 Tex=14.76\r\n"});
  const WifFile again = opened(with_count);
  EXPECT_EQ(again.design, counted);
  EXPECT_EQ(write_wif(again, file.design), old) << "unset again";
}

TEST(edit, defaults_remove_the_private_sections) {
  const WifFile file = opened(fixture("twill.wif"));
  Design now = file.design;
  now.look.exposure_ev = 1;
  now.scene.view_distance = 2;
  const WifFile edited = opened(write_wif(file, now));
  EXPECT_EQ(write_wif(edited, file.design).find("WEFTLIGHT "), std::string::npos);
  EXPECT_TRUE(opened(write_wif(edited, file.design)).design == file.design);
}

TEST(edit, mixed_line_ends_stay) {
  const LineDiff diff = diff_of("mixed_ends.wif", [](Design& d) { d = with_threading(d, 2, 0, true); });
  ASSERT_EQ(diff.removed.size(), 1u);
  ASSERT_EQ(diff.added.size(), 1u);
  EXPECT_EQ(diff.removed[0].substr(3), diff.added[0].substr(3));
  expect_change(diff_of("twill_cr.wif", [](Design& d) { d = with_threading(d, 2, 0, true); }), {"3=3\r"}, {"3=1\r"});
}

TEST(edit, gaps_are_filled_only_where_needed) {
  expect_change(diff_of("gaps.wif", [](Design& d) { d.title = "Mended"; }), {"Title=Two and two twill\r\n"},
                {"Title=Mended\r\n"});
  diff_of("gaps.wif", [](Design& d) { d = with_size(d, 8, 8, 5, 7); });
  diff_of("gaps.wif", [](Design& d) { d = with_size(d, 8, 8, 4, 2); });
}

}  // namespace
}  // namespace weftlight::wif
