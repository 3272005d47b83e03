// analyse, diff, join, print, weave, and drafts in other formats.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/json.h"
#include "commands/open_design.h"
#include "files/files.h"
#include "scratch_folder.h"

namespace weftlight::commands {

using base::problem_of, base::read_file, base::write_file_atomically;
using design::Design, design::Yarn;
using draft::Face, draft::blank_draft;
using files::read_image;
using wif::write_new_wif;

namespace {

using WeaverVerbs = ScratchFolder;

std::string said(int (*verb)(const AnalyseOptions&), const AnalyseOptions& options) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(verb(options), kDone);
  return ::testing::internal::GetCapturedStdout();
}

std::string drawdown_of(const std::string& path) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(drawdown_command({path, "", Face::kFront, false}), kDone);
  return ::testing::internal::GetCapturedStdout();
}

TEST_F(WeaverVerbs, analyse_as_json) {
  AnalyseOptions options;
  options.file = fixture_path("twill.wif");
  options.json = true;
  options.float_limit = 1;
  const auto json = nlohmann::json::parse(said(analyse_command, options));
  EXPECT_EQ(json["repeat"]["ends"], 4);
  EXPECT_EQ(json["floats"]["longest"]["warp_front"], 2);
  EXPECT_GT(json["floats"]["count"], 0);
  EXPECT_EQ(json["floats"]["listed"][0]["length"], 2);
  EXPECT_EQ(json["hangs_together"], true);
  EXPECT_EQ(json["fewest"]["shafts"], 4);
  EXPECT_DOUBLE_EQ(json["balance"]["warp_on_top"], 0.5);
  int heddles = 0;
  for (const int shaft : json["heddles"]) heddles += shaft;
  EXPECT_EQ(heddles, json["yarn"]["ends"]);
  options.json = false;
  EXPECT_NE(said(analyse_command, options).find("layers          one connected cloth"), std::string::npos);
}

TEST_F(WeaverVerbs, one_thread_is_told_as_one) {
  WeaveOptions cell{"plain", path("cell.wif"), {}, 1, 1, false};
  ASSERT_EQ(weave_command(cell), kDone);
  AnalyseOptions options;
  options.file = cell.out;
  const std::string report = said(analyse_command, options);
  EXPECT_NE(report.find("repeat          1 end, 1 pick; with colours 1 end, 1 pick\n"), std::string::npos) << report;
  EXPECT_NE(report.find("      1 thread  "), std::string::npos) << report;
  EXPECT_EQ(report.find("1 threads"), std::string::npos) << report;
}

TEST_F(WeaverVerbs, wraps_are_of_the_threads_as_the_file_has_them) {
  std::string text =
      "[WIF]\nVersion=1.1\n[CONTENTS]\nWEAVING=yes\nWARP=yes\nWEFT=yes\nTHREADING=yes\nTIEUP=yes\n"
      "TREADLING=yes\n[WEAVING]\nShafts=2\nTreadles=2\nRising Shed=yes\n"
      "[WARP]\nThreads=2\nUnits=Centimeters\nSpacing=0.1\nThickness=0.1\n"
      "[WEFT]\nThreads=2\nUnits=Centimeters\nSpacing=0.1\nThickness=WEFT\n"
      "[THREADING]\n1=1\n2=2\n[TIEUP]\n1=1\n2=2\n[TREADLING]\n1=1\n2=2\n";
  const auto said_of = [&](const char* weft) {
    std::string file = text;
    file.replace(file.find("WEFT\n[THREADING"), 4, weft);
    AnalyseOptions options;
    options.file = written("thick.wif", file);
    return said(analyse_command, options);
  };
  const std::string even = said_of("0.1");
  EXPECT_NE(even.find("tex, 10.0 wraps per cm, 5.0 ends per cm on the loom\n"), std::string::npos) << even;
  EXPECT_NE(even.find("\nfirm sett       "), std::string::npos) << "no part of the sett as drawn\n" << even;
  EXPECT_EQ(even.find("in the warp"), std::string::npos) << even;
  const std::string thick = said_of("0.2");
  EXPECT_NE(thick.find("in the warp: "), std::string::npos) << thick;
  EXPECT_NE(thick.find("tex, 5.0 wraps per cm"), std::string::npos) << thick;
}

TEST_F(WeaverVerbs, the_plan_in_the_file_is_used_everywhere) {
  Design d = wif::read_wif(read_file(fixture_path("twill.wif")).value_or("")).file->design;
  const auto sums = [&](const std::string& name) {
    AnalyseOptions options;
    options.file = path(name), options.json = true;
    const auto json = nlohmann::json::parse(said(analyse_command, options));
    int heddles = 0;
    for (const int shaft : json["heddles"]) heddles += shaft;
    return std::pair(heddles, json["yarn"]["ends"].get<int>());
  };
  ASSERT_TRUE(write_file_atomically(path("drafted.wif"), write_new_wif(d)));
  d.plan.width_mm = 2000, d.plan.length_mm = 3000, d.plan.warp_shrinkage = 0.1f;
  ASSERT_TRUE(write_file_atomically(path("planned.wif"), write_new_wif(d)));
  const auto [drafted, drafted_yarn] = sums("drafted.wif");
  const auto [planned, planned_yarn] = sums("planned.wif");
  EXPECT_EQ(drafted, d.draft.ends());
  EXPECT_GT(planned, drafted) << "the width is that of the file";
  EXPECT_EQ(planned, planned_yarn) << "as many heddles as ends that are bought";
  EXPECT_EQ(drafted, drafted_yarn);
  ASSERT_EQ(run({"print", path("planned.wif"), "-o", path("lists.svg"), "--parts", "heddles"}).code, kDone);
  std::string sheets;
  for (const std::string& name : files())
    if (name.ends_with(".svg")) sheets += read_file(path(name)).value_or("");
  EXPECT_FALSE(sheets.empty());
}

TEST_F(WeaverVerbs, analyse_counts_the_cost) {
  const std::string two = path("two.wif");
  Design d;
  d.draft = blank_draft(10, 10, 2, 2);
  d.yarns = {Yarn{}, Yarn{}};
  d.yarns[0].name = "Cotton", d.yarns[1].name = "Silk = fine";
  d.draft.weft.yarn.assign(10, 1);
  ASSERT_TRUE(write_file_atomically(two, write_new_wif(d)).has_value());
  const auto yarn_of = [&](std::vector<std::string> args) {
    args.insert(args.begin(), {"analyse", two, "--json", "--length", "2000", "--width", "500"});
    const Ran ran = run(args);
    EXPECT_EQ(ran.code, kDone);
    return nlohmann::json::parse(ran.out)["yarn"];
  };
  const auto none = yarn_of({});
  EXPECT_FALSE(none.contains("cost"));
  EXPECT_FALSE(none["buy"][0].contains("cost"));
  const auto one = yarn_of({"--price", "Cotton=40"});
  const auto cotton = one["buy"][one["buy"][0]["yarn"] == "Cotton" ? 0 : 1];
  EXPECT_NEAR(cotton["cost"].get<double>(), 40 * cotton["weight_g"].get<double>() / 1000, 1e-9);
  EXPECT_FALSE(one.contains("cost")) << "the price of the silk is not known";
  const auto both = yarn_of({"--price", "Cotton=40", "--price", "Silk = fine=200.5"});
  EXPECT_NEAR(both["cost"].get<double>(),
              both["needs"][0]["weight_g"].get<double>() / 1000 * 40 +
                  both["needs"][1]["weight_g"].get<double>() / 1000 * 200.5,
              1e-6);
  EXPECT_EQ(yarn_of({"--price", "7"})["cost"], yarn_of({"--price", "Silk = fine=7", "--price", "Cotton=7"})["cost"]);
  EXPECT_NEAR(yarn_of({"--spare", "0.5"})["weight_g"].get<double>(),
              yarn_of({"--spare", "0"})["weight_g"].get<double>() * 1.5, 1e-6);

  const Ran text = run({"analyse", two, "--price", "10"});
  EXPECT_NE(text.out.find("\ncost            0."), std::string::npos) << text.out;
  const Ran unknown = run({"analyse", two, "--price", "Wool=3"});
  EXPECT_EQ(unknown.code, kUsage);
  EXPECT_NE(unknown.said.find("Cotton, Silk = fine"), std::string::npos) << unknown.said;
  for (const char* odd : {"Cotton", "Cotton=", "Cotton=cheap", "Cotton=-1", "nan", "1e9"})
    EXPECT_EQ(run({"analyse", two, "--price", odd}).code, kUsage) << odd;
}

TEST_F(WeaverVerbs, analyse_plans_a_cloth_in_either_unit) {
  const std::string file = fixture_path("plan.wif");
  const auto kept = nlohmann::json::parse(run({"analyse", file, "--json"}).out);
  EXPECT_EQ(kept["plan"]["pieces"], 3) << "the file's own plan";
  EXPECT_EQ(kept["plan"]["reed"]["sleying"], "1-2");
  int64_t heddles = 0;
  for (const int64_t shaft : kept["heddles"]) heddles += shaft;
  EXPECT_EQ(heddles, kept["yarn"]["ends"]) << "of the planned cloth, as the yarn";
  EXPECT_EQ(kept["plan"]["warping"]["ends"], heddles + 2) << "with floating selvedges";
  int64_t threads = 0;
  for (const auto& need : kept["yarn"]["needs"])
    if (need["system"] == "warp") threads += need["threads"].get<int64_t>();
  EXPECT_EQ(threads, heddles + 2) << "one cloth";
  const std::vector<std::string> asked = {"analyse",   file,       "--width", "20in",    "--length",
                                          "1yd",       "--pieces", "1",       "--reed",  "10/in",
                                          "--sleying", "2",        "--units", "imperial"};
  const Ran text = run(asked);
  EXPECT_EQ(text.code, kDone);
  for (const char* part : {"20.0 in wide, 36.0 in long", "20.0 ends per inch", "10 dents per inch", " yd", " oz"})
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  EXPECT_EQ(text.out.find(" cm"), std::string::npos) << text.out;
  EXPECT_EQ(run({"analyse", file}).out.find(" in wide"), std::string::npos) << "metric unless asked";
  for (const std::vector<std::string>& odd : std::vector<std::vector<std::string>>{
           {"--reed", "40"}, {"--sleying", "x"}, {"--width", "5 miles"}, {"--units", "ells"}, {"--pieces", "0"}}) {
    std::vector<std::string> args = {"analyse", file};
    args.insert(args.end(), odd.begin(), odd.end());
    EXPECT_EQ(run(args).code, kUsage) << odd[0];
  }
}

TEST_F(WeaverVerbs, analyse_heeds_a_sett_beside_a_reed) {
  const auto plan_with = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"analyse", fixture_path("plan.wif"), "--json"});
    return nlohmann::json::parse(run(options).out)["plan"];
  };
  EXPECT_EQ(plan_with({"--reed", "40/10", "--ends-per-cm", "8"})["reed"]["sleying"], "2");
  EXPECT_EQ(plan_with({"--reed", "40/10", "--ends-per-cm", "6"})["reed"]["sleying"], "1-2");
  EXPECT_EQ(plan_with({"--reed", "40/10", "--ends-per-cm", "8", "--sleying", "2"})["reed"]["sleying"], "2");
  const auto without_reed = plan_with({"--ends-per-cm", "17.5"});
  EXPECT_FALSE(without_reed.contains("reed")) << "the file's reed makes another sett";
  EXPECT_NE(without_reed.dump().find("17.5"), std::string::npos) << without_reed.dump();

  const Ran three =
      run({"analyse", fixture_path("plan.wif"), "--reed", "40/10", "--ends-per-cm", "8", "--sleying", "1"});
  EXPECT_EQ(three.code, kUsage);
  EXPECT_NE(three.said.find("--reed 40/10 with --sleying 1 makes 4"), std::string::npos) << three.said;
  const Ran crowded = run({"analyse", fixture_path("plan.wif"), "--reed", "40/10", "--ends-per-cm", "60"});
  EXPECT_EQ(crowded.code, kUsage);
  EXPECT_NE(crowded.said.find("no usual sleying"), std::string::npos) << crowded.said;
}

TEST_F(WeaverVerbs, diff_of_a_file_with_itself_and_another) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(diff_command({fixture_path("twill.wif"), fixture_path("twill.wif")}), kDone);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "the drafts are the same\n");
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(diff_command({fixture_path("twill.wif"), fixture_path("sinking.wif")}), kDone);
  EXPECT_NE(::testing::internal::GetCapturedStdout().find("shed"), std::string::npos);
  EXPECT_EQ(diff_command({fixture_path("twill.wif"), path("none.wif")}), kBadInput);
}

TEST_F(WeaverVerbs, the_extension_of_print_selects_the_format) {
  EXPECT_EQ(print_command({fixture_path("twill.wif"), path("a.pdf"), {}}), kDone);
  EXPECT_TRUE(read_file(path("a.pdf")).value_or("").starts_with("%PDF"));
  EXPECT_EQ(print_command({fixture_path("twill.wif"), path("a.svg"), {print::kLetter, 5}}), kDone);
  EXPECT_NE(read_file(path("a-1.svg")).value_or("").find("<svg"), std::string::npos);
  EXPECT_EQ(run({"print", fixture_path("twill.wif"), "-o", path("a.docx")}).code, kUsage);
  EXPECT_EQ(print_command({path("none.wif"), path("b.pdf"), {}}), kBadInput);
  EXPECT_EQ(print_command({fixture_path("twill.wif"), path("no/folder/b.pdf"), {}}), kNotWritten);
}

TEST_F(WeaverVerbs, print_takes_parts_and_papers) {
  const std::string twill = fixture_path("twill.wif");
  const auto media_box = [](const std::string& pdf) {
    const size_t at = pdf.find("/MediaBox");
    return pdf.substr(at, pdf.find(']', at) - at);
  };
  ASSERT_EQ(run({"print", twill, "-o", path("all.pdf")}).code, kDone);
  ASSERT_EQ(run({"print", twill, "-o", path("draft.pdf"), "--parts", "draft", "--paper", "a3", "--across"}).code,
            kDone);
  EXPECT_NE(media_box(read_file(path("draft.pdf")).value_or("")).find("1190.5"), std::string::npos) << "420 mm wide";
  ASSERT_EQ(run({"print", twill, "-o", path("draft.svg"), "--parts", "draft", "--end1", "right"}).code, kDone);
  EXPECT_TRUE(std::filesystem::exists(path("draft.svg"))) << "the draft alone is one sheet";
  ASSERT_EQ(run({"print", twill, "-o", path("some.svg"), "--parts", "draft,heddles,swatch", "--heavy", "0"}).code,
            kDone);
  EXPECT_TRUE(std::filesystem::exists(path("some-2.svg"))) << "a sheet with the others";
  ASSERT_EQ(run({"print", twill, "-o", path("s.png"), "--parts", "draft", "--paper", "a5", "--dpi", "50"}).code, kDone);
  EXPECT_EQ(read_image(path("s.png"))->width, 291) << "148 mm";
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--parts", "drawdown"}, {"--paper", "a0"}, {"--end1", "top"}, {"--dpi", "5"}}) {
    std::vector<std::string> args{"print", twill, "-o", path("no.pdf")};
    args.insert(args.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run(args).code, kUsage) << wrong[0] << " " << wrong[1];
  }
  EXPECT_FALSE(std::filesystem::exists(path("no.pdf")));
}

TEST_F(WeaverVerbs, weave_keeps_its_parameters_in_the_file) {
  EXPECT_EQ(weave_command({"twill", path("t.wif"), {"ratio=3/1"}, 8, 8, false}), kDone);
  const OpenedDesign opened = open_design(path("t.wif"));
  ASSERT_TRUE(opened.ok);
  ASSERT_EQ(opened.design.weaves.size(), 1u);
  EXPECT_EQ(opened.design.weaves[0].weave, "twill");
  EXPECT_EQ(opened.design.draft.shafts, 4);
  EXPECT_EQ(weave_command({"twill", path("t.wif"), {"color=red"}, 8, 8, false}), kUsage);
  EXPECT_EQ(weave_command({"nonsense", path("t.wif"), {}, 8, 8, false}), kUsage);
  EXPECT_EQ(weave_command({"twill", "", {}, 8, 8, false}), kUsage);
}

TEST_F(WeaverVerbs, weave_says_what_is_wrong_and_what_there_is) {
  const auto refused = [&](std::vector<std::string> args) {
    args.insert(args.begin(), "weave");
    const Ran ran = run(std::move(args));
    EXPECT_EQ(ran.code, kUsage) << ran.said;
    return ran.said;
  };
  EXPECT_NE(refused({}).find("give the id of a weave"), std::string::npos);
  EXPECT_NE(refused({"twil", "-o", path("t.wif")}).find("no weave is called 'twil'; did you mean 'twill'?"),
            std::string::npos);
  EXPECT_NE(refused({"zzzz", "-o", path("t.wif")}).find("'zzzz'; see weftlight weave --list"), std::string::npos);
  EXPECT_NE(refused({"twill", "-o", path("t.wif"), "--set", "ratio"}).find("as --set ratio=VALUE"), std::string::npos);
  EXPECT_NE(refused({"twill", "-o", path("t.wif"), "--set", "color=red"}).find("no such parameter; it has ratio"),
            std::string::npos);
}

TEST_F(WeaverVerbs, print_refuses_sheets_that_there_are_not) {
  const std::string twill = fixture_path("twill.wif");
  for (const std::vector<std::string>& sheets :
       {std::vector<std::string>{"--first-sheet", "300"}, {"--first-sheet", "2", "--last-sheet", "1"}}) {
    std::vector<std::string> args{"print", twill, "-o", path("no.pdf")};
    args.insert(args.end(), sheets.begin(), sheets.end());
    EXPECT_EQ(run(args).code, kUsage) << sheets[1];
  }
  EXPECT_FALSE(std::filesystem::exists(path("no.pdf")));
}

TEST_F(WeaverVerbs, weave_warns_of_a_repeat_that_is_cut) {
  const Ran cut =
      run({"weave", "sett", "-o", path("cut.wif"), "--set", "sett=R20 K20 G40", "--ends", "60", "--picks", "80"});
  EXPECT_EQ(cut.code, kDone);
  EXPECT_NE(cut.said.find("cut.wif: warning: The repeat has 80 ends and 80 picks, and there is room for 60 by 80"),
            std::string::npos)
      << cut.said;
  EXPECT_EQ(
      run({"weave", "sett", "-o", path("whole.wif"), "--set", "sett=R20 K20 G20", "--ends", "60", "--picks", "60"})
          .said,
      "");
}

TEST_F(WeaverVerbs, join_puts_two_drafts_in_one_cloth) {
  ASSERT_EQ(weave_command({"plain", path("a.wif"), {}, 8, 8, false}), kDone);
  ASSERT_EQ(weave_command({"twill", path("b.wif"), {}, 8, 8, false}), kDone);
  EXPECT_EQ(join_command({path("a.wif"), path("b.wif"), path("c.wif"), "1:2", "", ""}), kDone);
  const OpenedDesign made = open_design(path("c.wif"));
  ASSERT_TRUE(made.ok);
  EXPECT_EQ(made.design.draft.ends(), 24);
  EXPECT_EQ(made.design.draft.picks(), 8);
  EXPECT_EQ(join_command({path("a.wif"), path("b.wif"), path("d.wif"), "", "", ""}), kUsage);
  EXPECT_EQ(join_command({path("a.wif"), path("b.wif"), path("d.wif"), "1:1", "1:1", ""}), kUsage);
  EXPECT_EQ(join_command({path("a.wif"), path("b.wif"), path("d.wif"), "0:1", "", ""}), kUsage);
  EXPECT_EQ(join_command({path("a.wif"), path("none.wif"), path("d.wif"), "1:1", "", ""}), kBadInput);
  EXPECT_FALSE(std::filesystem::exists(path("d.wif")));
}

TEST_F(WeaverVerbs, another_programs_draft_becomes_a_wif) {
  const std::string dtx =
      "@@StartDTX\n@@Info\n%%shafts 2\n@@Threading\n1 2 1 2\n@@Tieup\n01\n10\n@@Treadling\n1 2\n@@EndDTX\n";
  ASSERT_EQ(problem_of(write_file_atomically(path("plain.dtx"), dtx)), "");
  EXPECT_EQ(drawdown_of(path("plain.dtx")), "1010\n0101\n");
  EXPECT_EQ(convert_command({path("plain.dtx"), path("plain.wif"), false, ConvertShedControl::kAsIs}), kDone);
  EXPECT_TRUE(read_file(path("plain.wif")).value_or("").starts_with("[WIF]"));
  EXPECT_EQ(drawdown_of(path("plain.wif")), "1010\n0101\n");
}

TEST_F(WeaverVerbs, a_picture_of_points_gives_the_same_drawdown) {
  const std::string cloth = drawdown_of(fixture_path("twill.wif"));
  for (const char* name : {"points.png", "points.tif"}) {
    EXPECT_EQ(drawdown_command({fixture_path("twill.wif"), path(name), Face::kFront, true}), kDone);
    EXPECT_EQ(drawdown_of(path(name)), cloth) << name;
  }
  ASSERT_EQ(problem_of(write_file_atomically(path("bad.png"), "no picture")), "");
  EXPECT_FALSE(open_design(path("bad.png")).ok);
}

TEST_F(WeaverVerbs, a_picture_becomes_weaves_with_bounded_floats) {
  files::Image photo{120, 80, 3, {}};
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x)
      for (const int period : {17, 29, 41})
        photo.texels.push_back(0.5f +
                               0.5f * std::sin(static_cast<float>(x * x / 30 + y * 3) / static_cast<float>(period)));
  ASSERT_EQ(problem_of(files::write_image(path("photo.png"), photo, files::PixelType::kU8)), "");
  const auto info = [&](const char* draft) { return nlohmann::json::parse(run({"info", path(draft), "--json"}).out); };
  const auto longest = [&](const char* draft) {
    const auto found = nlohmann::json::parse(run({"analyse", path(draft), "--json"}).out)["floats"]["longest"];
    int most = 0;
    for (const auto& [face, length] : found.items()) most = std::max(most, length.get<int>());
    return most;
  };
  ASSERT_EQ(run({"convert", path("photo.png"), path("as_is.wif")}).code, kDone);
  EXPECT_EQ(info("as_is.wif")["ends"], 120);
  EXPECT_LE(longest("as_is.wif"), 7);
  ASSERT_EQ(
      run({"convert", path("photo.png"), path("small.wif"), "--ends", "60", "--colors", "4", "--floats", "3"}).code,
      kDone);
  EXPECT_EQ(info("small.wif")["ends"], 60);
  EXPECT_EQ(info("small.wif")["picks"], 40) << "it keeps its proportions";
  EXPECT_LE(longest("small.wif"), 3);
  EXPECT_EQ(run({"convert", fixture_path("twill.wif"), path("no.wif"), "--colors", "4"}).code, kUsage);
  EXPECT_EQ(run({"convert", path("photo.png"), path("no.wif"), "--colors", "1"}).code, kUsage);
  EXPECT_EQ(run({"convert", path("photo.png"), path("no.wif"), "--floats", "0"}).code, kUsage);
  EXPECT_FALSE(std::filesystem::exists(path("no.wif")));
}

}  // namespace
}  // namespace weftlight::commands
