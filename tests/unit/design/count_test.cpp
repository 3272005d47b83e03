// Yarn counts.

#include "design/count.h"

#include <gtest/gtest.h>

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
  for (const char* text : {"", "tex", "8", "0 tex", "-3 tex", "8//2 Ne", "8/0 Ne", "1e9 tex", "8/2/2 Ne", "nan tex",
                           "3 furlongs", "1e-9 tex", "8/999 Ne"})
    EXPECT_FALSE(tex_from_text(text)) << text;
}

TEST(Count, DiameterOfARoundThread) {
  // As in the yarn presets: Ne 8/2 cotton 0.45 mm, 150 den polyester 0.16 mm.
  EXPECT_NEAR(diameter_from_tex_mm(147.6, 1.52, 0.6), 0.45, 0.005);
  EXPECT_NEAR(diameter_from_tex_mm(16.67, 1.39, 0.6), 0.16, 0.005);
  EXPECT_NEAR(tex_from_diameter(diameter_from_tex_mm(40, 1.5, 0.55), 1.5, 0.55), 40, 1e-9);
}

}  // namespace
}  // namespace weftlight::design
