// Drafts of other programs and the WIF expected for each, from a folder
// ($WEFTLIGHT_OTHER_FORMATS: dtx/, wpo/, wanted_wif/, bad_dtx/); skipped where it is absent.

#include "wif/other_formats.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "draft/drawdown.h"

namespace weftlight::wif {

using base::read_file;
using design::Design, design::is_consistent;
using draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::drawdown, draft::lifts;

namespace {

std::string formats_dir() {
  const char* dir = std::getenv("WEFTLIGHT_OTHER_FORMATS");
  return dir && std::filesystem::is_directory(std::string(dir) + "/wanted_wif") ? dir : "";
}

std::vector<Rgb> colors_of(const Draft& d, const Threads& threads) {
  std::vector<Rgb> colors;
  for (const int color : threads.color) colors.push_back(d.palette[static_cast<size_t>(color)]);
  return colors;
}

/// A .wpo does not store threads after the last one in use: in the expected draft these must be empty.
Draft without_tail(Draft d, int ends, int picks, const std::string& name) {
  EXPECT_GE(d.ends(), ends) << name;
  EXPECT_GE(d.picks(), picks) << name;
  for (int e = ends; e < d.ends(); ++e) EXPECT_EQ(d.threading.first(e), -1) << name;
  for (int p = picks; p < d.picks(); ++p) EXPECT_EQ(lifts(d).first(p), -1) << name;
  d.warp.resize(ends);
  d.weft.resize(picks);
  d.threading.resize(ends, d.shafts);
  d.treadling.resize(picks, d.treadles);
  d.liftplan.resize(picks, d.shafts);
  return d;
}

void expect_same_draft(const Draft& got, const Draft& wanted, const std::string& name) {
  EXPECT_EQ(got.rising, wanted.rising) << name;
  EXPECT_EQ(got.shed_control, wanted.shed_control) << name;
  EXPECT_EQ(got.shafts, wanted.shafts) << name;
  EXPECT_TRUE(got.threading == wanted.threading) << name;
  if (wanted.shed_control == ShedControl::kTreadling) {
    EXPECT_TRUE(got.tieup == wanted.tieup) << name;
    EXPECT_TRUE(got.treadling == wanted.treadling) << name;
  } else {
    EXPECT_TRUE(got.liftplan == wanted.liftplan) << name;
  }
  EXPECT_TRUE(drawdown(got) == drawdown(wanted)) << name;
  EXPECT_EQ(colors_of(got, got.warp), colors_of(wanted, wanted.warp)) << name;
  EXPECT_EQ(colors_of(got, got.weft), colors_of(wanted, wanted.weft)) << name;
}

TEST(other_formats, every_sample_becomes_its_wif) {
  const std::string dir = formats_dir();
  if (dir.empty()) GTEST_SKIP() << "WEFTLIGHT_OTHER_FORMATS is not a folder with wanted_wif";
  int files = 0;
  for (const char* folder : {"dtx", "wpo"})
    for (const auto& entry : std::filesystem::directory_iterator(dir + "/" + folder)) {
      const std::string name = entry.path().filename().string();
      const WifRead read = read_draft(read_file(entry.path().string()).value_or(""));
      for (const Diagnostic& d : read.diagnostics)
        if (d.severity != Severity::kNote) ADD_FAILURE() << name << ":" << d.line << ": " << d.text;
      ASSERT_TRUE(read.file) << name;
      EXPECT_EQ(read.file->format, folder) << name;
      ASSERT_TRUE(is_consistent(read.file->design)) << name;
      const WifRead wanted =
          read_wif(read_file(dir + "/wanted_wif/" + entry.path().stem().string() + ".wif").value_or(""));
      ASSERT_TRUE(wanted.file) << name;
      Draft want = wanted.file->design.draft;
      const Draft& draft = read.file->design.draft;
      if (std::string(folder) == "wpo") want = without_tail(std::move(want), draft.ends(), draft.picks(), name);
      expect_same_draft(draft, want, name);
      if (std::string(folder) == "dtx") {
        const Design &got = read.file->design, &like = wanted.file->design;
        EXPECT_EQ(got.title, like.title) << name;
        EXPECT_EQ(got.notes, like.notes) << name;
        for (size_t i = 0; i < got.draft.warp.spacing_mm.size(); ++i)
          EXPECT_NEAR(got.draft.warp.spacing_mm[i], like.draft.warp.spacing_mm[i], 1e-4f) << name;
        for (size_t i = 0; i < got.draft.weft.spacing_mm.size(); ++i)
          EXPECT_NEAR(got.draft.weft.spacing_mm[i], like.draft.weft.spacing_mm[i], 1e-4f) << name;
      }
      EXPECT_EQ(read_wif(read.file->bytes).file->design, read.file->design) << name << ": as a new WIF";
      ++files;
    }
  EXPECT_GE(files, 12);
}

TEST(other_formats, bad_files_are_rejected_or_read_with_a_warning) {
  const std::string dir = formats_dir();
  if (dir.empty()) GTEST_SKIP() << "WEFTLIGHT_OTHER_FORMATS is not a folder with wanted_wif";
  for (const auto& entry : std::filesystem::directory_iterator(dir + "/bad_dtx")) {
    const std::string name = entry.path().filename().string();
    const WifRead read = read_draft(read_file(entry.path().string()).value_or(""));
    int said = 0;
    for (const Diagnostic& d : read.diagnostics) {
      if (d.severity == Severity::kNote) continue;
      ++said;
      EXPECT_FALSE(d.text.empty() || d.remedy.empty()) << name;
      std::printf("%s: %s:%d: %s; %s\n", read.file ? "read" : "refused", name.c_str(), d.line, d.text.c_str(),
                  d.remedy.c_str());
    }
    EXPECT_GT(said, 0) << name;
  }
}

}  // namespace
}  // namespace weftlight::wif
