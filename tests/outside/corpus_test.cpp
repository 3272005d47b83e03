// Files of other programs, compared with the results of an independent reader. WEFTLIGHT_WIF_CORPUS names the folder,
// which is not part of this project.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "design/design.h"
#include "draft/drawdown.h"
#include "sha256.h"
#include "wif/wif.h"

namespace weftlight::wif {

using base::read_file;
using design::Design, design::is_consistent;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::Threads, draft::drawdown;

namespace {

struct Facts {
  std::string file;
  std::map<std::string, std::string> value;  // by column
  bool genuine() const { return file.starts_with("genuine/"); }
};

std::string corpus_dir() {
  const char* dir = std::getenv("WEFTLIGHT_WIF_CORPUS");
  return dir && std::filesystem::is_regular_file(std::string(dir) + "/INDEX.tsv") ? dir : "";
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream in(line);
  for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
  return cells;
}

std::vector<Facts> read_index(const std::string& dir) {
  std::stringstream in(read_file(dir + "/INDEX.tsv").value_or(""));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> columns = split(line);
  std::vector<Facts> all;
  while (std::getline(in, line)) {
    Facts facts;
    const std::vector<std::string> cells = split(line);
    for (size_t i = 0; i < cells.size() && i < columns.size(); ++i) facts.value[columns[i]] = cells[i];
    facts.file = facts.value["file"];
    all.push_back(std::move(facts));
  }
  return all;
}

std::string short_hash(const std::string& text) { return sha256_hex(text).substr(0, 16); }

std::string drawdown_text(const BitMatrix& cells) {
  std::string text;
  for (int pick = 0; pick < cells.rows(); ++pick) {
    if (pick > 0) text += '\n';
    for (int end = 0; end < cells.cols(); ++end) text += cells.get(pick, end) ? '1' : '0';
  }
  return text;
}

std::string color_text(const Draft& draft, const Threads& threads) {
  std::string text;
  const auto byte = [](float channel) {
    return std::to_string(static_cast<int>(std::floor(static_cast<double>(channel) * 255 + 0.5)));
  };
  for (const int index : threads.color) {
    const Rgb& c = draft.palette[static_cast<size_t>(index)];
    if (!text.empty()) text += ';';
    text += byte(c.r) + "," + byte(c.g) + "," + byte(c.b);
  }
  return text;
}

std::map<std::string, std::string> facts_of(const WifFile& file) {
  const Draft& draft = file.design.draft;
  return {{"ends", std::to_string(draft.ends())},
          {"picks", std::to_string(draft.picks())},
          {"shafts", std::to_string(draft.shafts)},
          {"rising", draft.rising ? "1" : "0"},
          {"source_program", file.source_program},
          {"warp_up_cells", std::to_string(drawdown(draft).count())},
          {"drawdown_sha256_16", short_hash(drawdown_text(drawdown(draft)))},
          {"warp_rgb_sha256_16", short_hash(color_text(draft, draft.warp))},
          {"weft_rgb_sha256_16", short_hash(color_text(draft, draft.weft))}};
}

void expect_facts(const Facts& expected, const WifFile& file) {
  for (const auto& [column, found] : facts_of(file)) {
    const std::string& recorded = expected.value.at(column);
    // The independent reader gives no colours if a thread names a colour that is not in the table.
    if (column.find("_rgb_") != std::string::npos && (recorded == "partial" || recorded == "none")) continue;
    if (column == "source_program" && recorded == "?") {
      EXPECT_EQ(found, "") << expected.file;
      continue;
    }
    EXPECT_EQ(found, recorded) << expected.file << ": " << column;
  }
}

/// A new file keeps the whole design, a plain file the cloth.
void expect_other_forms(const std::string& name, const Design& design) {
  const WifRead made = read_wif(write_new_wif(design));
  ASSERT_TRUE(made.file) << name;
  EXPECT_TRUE(made.file->design == design) << name;
  const BitMatrix cells = drawdown(design.draft);
  for (const PlainShedControl shed_control :
       {PlainShedControl::kAsIs, PlainShedControl::kLiftplan, PlainShedControl::kTreadling}) {
    const WifRead plain = read_wif(write_plain_wif(design, shed_control));
    ASSERT_TRUE(plain.file) << name;
    EXPECT_TRUE(drawdown(plain.file->design.draft) == cells) << name;
  }
}

size_t differing_lines(const std::string& a, const std::string& b) {
  std::stringstream in_a(a), in_b(b);
  size_t count = 0;
  for (std::string line_a, line_b; std::getline(in_a, line_a) && std::getline(in_b, line_b);) count += line_a != line_b;
  return count;
}

/// Another threading of the first end changes one line, if the file lists that end, and reads back.
void expect_small_edit(const std::string& name, const WifFile& file) {
  Design now = file.design;
  const bool on = now.draft.threading.get(0, 0);
  now.draft.threading.set(0, 0, !on);
  const std::string bytes = write_wif(file, now);
  const WifRead again = read_wif(bytes);
  ASSERT_TRUE(again.file) << name;
  EXPECT_TRUE(again.file->design == now) << name;
  if (file.design.draft.threading.first(0) >= 0) {
    EXPECT_EQ(differing_lines(file.bytes, bytes), 1u) << name;
  }
}

/// An error that says what is wrong and what to do.
void expect_clear_refusal(const std::string& file, const std::vector<Diagnostic>& diagnostics) {
  const auto error = std::find_if(diagnostics.begin(), diagnostics.end(),
                                  [](const Diagnostic& d) { return d.severity == Severity::kError; });
  ASSERT_NE(error, diagnostics.end()) << file;
  EXPECT_FALSE(error->text.empty() || error->remedy.empty()) << file;
  std::printf("refused: %s:%d: %s; %s\n", file.c_str(), error->line, error->text.c_str(), error->remedy.c_str());
}

TEST(corpus, every_file_matches_or_is_rejected) {
  const std::string dir = corpus_dir();
  if (dir.empty()) GTEST_SKIP() << "WEFTLIGHT_WIF_CORPUS is not a folder with an INDEX.tsv";
  const std::vector<Facts> index = read_index(dir);
  ASSERT_GT(index.size(), 100u);
  int refused = 0;
  for (const Facts& facts : index) {
    const auto bytes = read_file(dir + "/" + facts.file);
    ASSERT_TRUE(bytes) << problem_of(bytes);
    const WifRead read = read_wif(*bytes);
    if (!read.file) {
      EXPECT_FALSE(facts.genuine()) << facts.file;
      expect_clear_refusal(facts.file, read.diagnostics);
      ++refused;
      continue;
    }
    ASSERT_TRUE(is_consistent(read.file->design)) << facts.file;
    expect_facts(facts, *read.file);
    EXPECT_TRUE(write_wif(*read.file, read.file->design) == *bytes) << facts.file;
    expect_other_forms(facts.file, read.file->design);
    expect_small_edit(facts.file, *read.file);
  }
  std::printf("%zu files, %d refused\n", index.size(), refused);
}

}  // namespace
}  // namespace weftlight::wif
