// .dtx and .wpo written here by hand.

#include "wif/other_formats.h"

#include <gtest/gtest.h>

#include "draft/drawdown.h"

namespace weftlight::wif {

using design::Design, design::is_consistent;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::drawdown;

namespace {

const std::string kDtx =
    "@@StartDTX\r\n%%version 1\r\n\r\n@@Description\r\nFour ends\r\n@@Contents\r\nInfo\r\n@@Imprint\r\nPCW 4\r\n"
    "@@Info\r\n%%shafts 3\r\n%%treadles 2\r\n%%ends 4\r\n%%picks 3\r\n@@Threading\r\n1 2\r\n3 0\r\n"
    "@@Tieup\r\n01\r\n01\r\n10\r\n@@Treadling\r\n%%compound\r\n1 1, 2 0\r\n"
    "@@Color Palet\r\n255,0,0\r\n0,0,255\r\n@@Warp Colors\r\n0 1 0 1\r\n@@Weft Colors\r\n1 1 0\r\n"
    "@@Warp Spacing\r\n4 2\r\n@@Notes\r\nOne\r\nTwo\r\n@@EndDTX\r\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string error_of(const WifRead& read) {
  for (const Diagnostic& d : read.diagnostics)
    if (d.severity == Severity::kError) return std::to_string(d.line) + ": " + d.text;
  return "";
}

TEST(Dtx, EverythingInASmallFile) {
  const WifRead read = read_draft(kDtx);
  ASSERT_TRUE(read.file) << error_of(read);
  const Design& design = read.file->design;
  const Draft& d = design.draft;
  EXPECT_EQ(read.file->format, "dtx");
  EXPECT_EQ(design.title, "Four ends");
  EXPECT_EQ(design.notes, (std::vector<std::string>{"One", "Two"}));
  EXPECT_EQ(d.shafts, 3);
  EXPECT_EQ(d.treadles, 2);
  EXPECT_TRUE(d.threading.get(0, 0) && d.threading.get(2, 2));
  EXPECT_EQ(d.threading.first(3), -1);
  EXPECT_TRUE(d.tieup.get(0, 0) && d.tieup.get(1, 1) && d.tieup.get(1, 2)) << "the last line is shaft 1";
  EXPECT_TRUE(d.treadling.get(0, 0) && d.treadling.get(1, 0) && d.treadling.get(1, 1));
  EXPECT_EQ(d.treadling.first(2), -1);
  EXPECT_EQ(d.warp.color, (std::vector<int>{0, 1, 0, 1}));
  EXPECT_NEAR(d.warp.spacing_mm[1], 1.06f, 1e-5f);
  EXPECT_NEAR(d.warp.spacing_mm[3], 2.12f, 1e-5f);
  EXPECT_NEAR(d.weft.spacing_mm[0], 2.12f, 1e-5f) << "four steps by default";
}

TEST(Dtx, ErrorsNameTheirLine) {
  EXPECT_EQ(error_of(read_draft(replaced(kDtx, "1 1, 2 0", "1 1, 7 0"))),
            "24: pick 2 names treadle 7, and there are 2");
  EXPECT_EQ(error_of(read_draft(replaced(kDtx, "1 2\r\n3 0", "1 x\r\n3 0"))), "16: 'x' is not a shaft");
  EXPECT_EQ(error_of(read_draft(replaced(kDtx, "@@Tieup", "@@Gone"))), "0: there is neither @@Tieup nor @@Liftplan");
  EXPECT_EQ(error_of(read_draft("@@Info\n")), "1: the file does not begin with @@StartDTX");
  EXPECT_NE(error_of(read_draft(replaced(kDtx, "%%shafts 3", "%%shafts 99999999"))), "");
}

TEST(Dtx, AMissingColourIsAWarning) {
  const WifRead read = read_draft(replaced(kDtx, "1 1 0\r\n@@Warp S", "1 9 0\r\n@@Warp S"));
  ASSERT_TRUE(read.file);
  EXPECT_EQ(read.file->design.draft.weft.color, (std::vector<int>{1, 0, 0}));
  EXPECT_FALSE(read.diagnostics.empty());
}

/// Two ends, three picks or none, two shafts; `kind` 100, 101 or 102.
std::string wpo(int kind, bool sinking = false, bool picks = true) {
  const auto list = [](std::initializer_list<int> bytes) {
    std::string out{0, static_cast<char>(bytes.size())};
    for (const int b : bytes) out += static_cast<char>(b);
    return out;
  };
  std::string bytes{123, 7, static_cast<char>(kind), 10, 2, 2, 0, static_cast<char>(sinking), 1, 10, 5};
  bytes.append(2, '\0');
  bytes += std::string{0, 2, 0, 3};
  bytes.append(7, '\0');
  bytes += list({1, 2}) + list({0, 1, 1}) + list({1, 1, 0});
  if (kind != 100) bytes += std::string{1, 2};
  if (!picks) bytes += list({});
  else if (kind == 100) bytes += std::string{0, 3, 1, 2, 3};
  else if (kind == 101) bytes += list({1, 2, 0});
  else bytes += std::string{0, 3, 1, 3, 0};
  bytes.append(66, '\0');
  return bytes + std::string{2, static_cast<char>(255), 0, 0, 0, 0, static_cast<char>(255)};
}

TEST(Wpo, OfEveryKind) {
  for (const int kind : {100, 101, 102}) {
    const WifRead read = read_draft(wpo(kind));
    ASSERT_TRUE(read.file) << error_of(read);
    const Draft& d = read.file->design.draft;
    EXPECT_EQ(d.shed_control, kind == 100 ? ShedControl::kLiftplan : ShedControl::kTreadling);
    EXPECT_EQ(d.ends(), 2);
    EXPECT_EQ(d.picks(), 3);
    EXPECT_EQ(d.palette[1], (Rgb{0, 0, 1}));
    EXPECT_EQ(d.weft.color, (std::vector<int>{1, 1, 0}));
    EXPECT_NEAR(d.warp.spacing_mm[0], 2.54f, 1e-5f);
    const BitMatrix cells = drawdown(d);
    EXPECT_TRUE(cells.get(0, 0) && !cells.get(0, 1));
    EXPECT_EQ(cells.get(1, 0), kind == 102) << kind;
    EXPECT_TRUE(cells.get(1, 1));
  }
  EXPECT_FALSE(read_draft(wpo(101, true)).file->design.draft.rising);
}

TEST(Wpo, WithoutPicksIsRefused) {
  for (const int kind : {100, 101, 102})
    EXPECT_EQ(error_of(read_draft(wpo(kind, false, false))), "0: the draft has no picks");
}

TEST(Wpo, TruncatedFilesAreRejectedOrReadWithoutColours) {
  const std::string whole = wpo(102);
  for (size_t size = 3; size < whole.size(); ++size) {
    const WifRead read = read_wpo(whole.substr(0, size));
    if (read.file) {
      EXPECT_TRUE(is_consistent(read.file->design)) << size;
    } else {
      EXPECT_NE(error_of(read), "") << size;
    }
  }
  std::string later = whole;
  later[1] = 8;
  EXPECT_EQ(error_of(read_draft(later)), "0: version 8 of .wpo is not known");
}

TEST(Format, IsDetectedFromTheFirstBytes) {
  EXPECT_EQ(format_of("[WIF]\n"), DraftFormat::kWif);
  EXPECT_EQ(format_of(""), DraftFormat::kWif);
  EXPECT_EQ(format_of("{\n"), DraftFormat::kWif);
  EXPECT_EQ(format_of("\r\n@@StartDTX"), DraftFormat::kDtx);
  EXPECT_EQ(format_of(wpo(100)), DraftFormat::kWpo);
}

}  // namespace
}  // namespace weftlight::wif
