// Yarn counts.

#include "design/count.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace weftlight::design {
namespace {

TEST(Count, UnitsOfTheTrade) {
  EXPECT_NEAR(tex_of(1, CountUnit::kNe), 590.54, 0.01);
  EXPECT_NEAR(tex_of(20, CountUnit::kNe), 29.53, 0.01);
  EXPECT_NEAR(tex_of(30, CountUnit::kNm), 33.333, 0.001);
  EXPECT_NEAR(tex_of(150, CountUnit::kDenier), 16.667, 0.001);
  EXPECT_NEAR(tex_of(1, CountUnit::kLea), 1653.5, 0.1);
  EXPECT_EQ(tex_of(25, CountUnit::kTex), 25);
  for (const CountUnit unit : {CountUnit::kTex, CountUnit::kDenier, CountUnit::kNm, CountUnit::kNe, CountUnit::kLea})
    for (const double count : {0.5, 7.0, 120.0}) EXPECT_NEAR(count_of(tex_of(count, unit), unit), count, 1e-9);
}

TEST(Count, IsReadFromItsUsualNotation) {
  EXPECT_NEAR(tex_from_text("Ne 8/2").value_or(0), 147.6, 0.1);
  EXPECT_NEAR(tex_from_text("8/2 Ne").value_or(0), 147.6, 0.1);
  EXPECT_NEAR(tex_from_text("Nm30/2").value_or(0), 66.67, 0.01);
  EXPECT_NEAR(tex_from_text("75 den").value_or(0), 8.333, 0.001);
  EXPECT_NEAR(tex_from_text("33.3 tex").value_or(0), 33.3, 1e-9);
  EXPECT_NEAR(tex_from_text(" 16 lea ").value_or(0), 103.3, 0.1);
  EXPECT_EQ(read_count("Ne 16/2").value().plies, 2);
  EXPECT_EQ(read_count("30 tex").value().plies, 0) << "not said";
  EXPECT_NEAR(tex_from_text("Nm 2/28").value_or(0), 71.43, 0.01) << "plies first, as worsted is sold";
  EXPECT_EQ(read_count("2/28 Nm").value().plies, 2);
  EXPECT_EQ(read_count("Ne 3/2").value().plies, 2);
  EXPECT_EQ(read_count("Ne 12/15").value().plies, 15) << "seine twine";
  EXPECT_EQ(read_count("Ne 8").value().plies, 1);
  for (const char* text : {"8/2.5 Ne", "", "tex", "8", "0 tex", "-3 tex", "8//2 Ne", "8/0 Ne", "1e9 tex", "8/2/2 Ne",
                           "nan tex", "3 furlongs", "1e-9 tex", "8/999 Ne"})
    EXPECT_FALSE(tex_from_text(text)) << text;
}

TEST(Count, ComesBackAsItWasTyped) {
  const std::pair<const char*, CountUnit> typed[] = {
      {"Ne 16/2", CountUnit::kNe},  {"Ne 16/2", CountUnit::kNm},   {"Nm 28/2", CountUnit::kNm},
      {"Nm 5.6", CountUnit::kNm},   {"16/2 lea", CountUnit::kLea}, {"150 den", CountUnit::kDenier},
      {"30 tex", CountUnit::kNe},   {"Ne 3/2", CountUnit::kNe},    {"Ne 5/6", CountUnit::kNe},
      {"Nm 7.5/2", CountUnit::kNm}, {"Nm 20/2", CountUnit::kNm},   {"Ne 12/15", CountUnit::kNe},
      {"1200 tex", CountUnit::kNe}, {"0.5 tex", CountUnit::kTex}};
  for (const auto& [text, usual] : typed) {
    const WrittenCount count = read_count(text).value_or(WrittenCount{});
    const double kept = std::round(count.tex * 1000) / 1000;  // as a yarn keeps it
    EXPECT_EQ(count_text(kept, count.plies, usual), text);
  }
  EXPECT_EQ(count_text(147.6, 2, CountUnit::kNe), "Ne 8/2") << "rounded in the file";
  EXPECT_EQ(count_text(73.2913, 1, CountUnit::kTex), "73.3 tex") << "no label";
}

TEST(Count, OfFilamentIsInDenierAndOfSpunYarnIsNot) {
  EXPECT_EQ(count_text(16.7, 1, CountUnit::kDenier), "150 den") << "not 99 lea";
  EXPECT_EQ(count_text(33.3, 1, CountUnit::kDenier), "300 den");
  EXPECT_EQ(count_text(501 / 9.0, 1, CountUnit::kDenier), "501 den") << "as it was typed";
  EXPECT_EQ(count_text(182.2, 2, CountUnit::kNe), "Ne 6.48/2") << "not 1640 den";
  EXPECT_EQ(about_count_text(179.1, 2, CountUnit::kNe), "Ne 6.6/2");
  EXPECT_EQ(about_count_text(33.3, 1, CountUnit::kDenier), "300 den");
}

TEST(Count, DiameterOfARoundThread) {
  // As in the yarn presets: Ne 8/2 cotton 0.45 mm, 150 den polyester 0.16 mm.
  EXPECT_NEAR(diameter_from_tex_mm(147.6, 1.52, 0.6), 0.45, 0.005);
  EXPECT_NEAR(diameter_from_tex_mm(16.67, 1.39, 0.6), 0.16, 0.005);
  EXPECT_NEAR(tex_from_diameter(diameter_from_tex_mm(40, 1.5, 0.55), 1.5, 0.55), 40, 1e-9);
}

}  // namespace
}  // namespace weftlight::design
