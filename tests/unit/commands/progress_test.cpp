// Progress of slow commands, on a terminal and for programs, and what --help says.

#include <CLI/CLI.hpp>
#include <sstream>

#include "base/json.h"
#include "commands/option_checks.h"
#include "commands/progress_line.h"
#include "commands/verbs.h"
#include "scratch_folder.h"

namespace weftlight::commands {
namespace {

using nlohmann::json;

TEST(Progress, TheTimeLeftComesFromTheWorkDoneNotFromWhatWasSkipped) {
  double now = 100;
  ProgressMeter meter(ProgressForm::kNone, 4, [&] { return now; });
  EXPECT_FALSE(meter.state().seconds_left);
  meter.skip(0, "a"), meter.skip(1, "b");
  now = 110;
  EXPECT_FALSE(meter.state().seconds_left) << "nothing was made yet";
  meter.set(2, 0.5, "c");
  EXPECT_EQ(meter.state().done, 2);
  EXPECT_NEAR(meter.state().fraction, 0.625, 1e-9);
  EXPECT_NEAR(*meter.state().seconds_left, 30, 1e-9) << "half of one in 10 s, one and a half are left";
  meter.set(2, 1, "c"), meter.set(3, 1, "d");
  EXPECT_EQ(meter.state().done, 4);
  EXPECT_NEAR(*meter.state().seconds_left, 0, 1e-9);
}

TEST(Progress, WhatComesOnceSaysNothingAboutTheRest) {
  double now = 0;
  ProgressMeter meter(ProgressForm::kNone, 1, [&] { return now; });
  now = 40;  // the shaders are compiled
  meter.begin(), meter.set(0, 0.01, "a");
  now = 50;
  meter.set(0, 0.5, "a");
  EXPECT_NEAR(*meter.state().seconds_left, 10, 1e-9);
}

TEST(Progress, TextsSayHowManyAndHowLong) {
  EXPECT_EQ(progress_text({2, 9, 0.316, 130.0, "denim"}), "2 of 9 done, 31%, 3 min left: denim");
  EXPECT_EQ(progress_text({0, 1, 0.5, {}, ""}), "50%");
  EXPECT_EQ(time_text(0.2), "1 s");
  EXPECT_EQ(time_text(119), "119 s");
  EXPECT_EQ(time_text(7800), "2 h 10 min");
  const json line = json::parse(progress_json({2, 9, 0.316, 130.0, "denim"}));
  EXPECT_EQ(line["progress"]["done"], 2);
  EXPECT_EQ(line["progress"]["count"], 9);
  EXPECT_EQ(line["progress"]["seconds_left"], 130.0);
  EXPECT_TRUE(json::parse(progress_json({0, 1, 0, {}, "\xff"}))["progress"]["seconds_left"].is_null());
}

class ExportProgress : public ScratchFolder {
 protected:
  Ran exported(std::vector<std::string> more) const {
    std::vector<std::string> args{
        "export", fixture_path("twill.wif"), "-o", path("sets"), "--target", "raw,u3m", "--size", "16"};
    args.insert(args.end(), more.begin(), more.end());
    return run(args);
  }
};

TEST_F(ExportProgress, JsonHasALineForEachReport) {
  const Ran ran = exported({"--progress", "json"});
  EXPECT_EQ(ran.code, kDone) << ran.said;
  std::istringstream lines(ran.said);
  std::vector<json> reports;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("{")) reports.push_back(json::parse(line)["progress"]);
  ASSERT_GE(reports.size(), 3u) << ran.said;
  for (size_t i = 1; i < reports.size(); ++i) EXPECT_GE(reports[i]["fraction"], reports[i - 1]["fraction"]);
  EXPECT_EQ(reports.back()["done"], 2);
  EXPECT_EQ(reports.back()["count"], 2);
  EXPECT_EQ(reports.back()["fraction"], 1);
}

TEST_F(ExportProgress, QuietPrintsProblemsOnly) {
  const Ran ran = exported({"--quiet"});
  EXPECT_EQ(ran.code, kDone);
  EXPECT_EQ(ran.said + ran.out, "");
  EXPECT_NE(run({"export", path("none.wif"), "-o", path("sets"), "--quiet"}).said, "");
  EXPECT_EQ(exported({"--quiet", "--progress", "json"}).code, kUsage);
}

TEST(Help, NamesTheDefaultOfEveryOptionWithAValueThatIsNotRequired) {
  for (const std::span<const Verb> verbs : {draft_verbs(), cloth_verbs()}) {
    for (const Verb& verb : verbs) {
      CLI::App app;
      verb.add_options(app);
      for (const CLI::Option* option : app.get_options()) {
        if (option->get_required() || option->get_positional() || option->get_items_expected_max() == 0) continue;
        if (option->get_group().empty()) continue;  // an earlier name, not shown
        const std::string text = option->get_description();
        const bool says =
            text.find("default:") != std::string::npos || text.find("required unless") != std::string::npos;
        EXPECT_TRUE(says) << verb.name << " " << option->get_name() << ": " << text;
      }
    }
  }
}

}  // namespace
}  // namespace weftlight::commands
