#include "ui/ruler.h"

#include <gtest/gtest.h>

namespace weftlight::ui {
namespace {

std::vector<std::string> numbers(const RulerStretch& stretch) {
  std::vector<std::string> out;
  for (const RulerMark& mark : ruler_marks(stretch))
    if (!mark.text.empty()) out.push_back(mark.text);
  return out;
}

TEST(Ruler, CountsCentimetresAndTheirTenths) {
  const RulerStretch inch_screen{0, 35, 3.78, 34, 3.5};  // 96 dpi
  EXPECT_EQ(numbers(inch_screen), (std::vector<std::string>{"0", "1", "2", "3"}));
  const std::vector<RulerMark> marks = ruler_marks(inch_screen);
  EXPECT_EQ(marks.size(), 36U);
  EXPECT_NEAR(marks[7].mm, 7, 1e-9);
}

TEST(Ruler, CountsInchesAndTheirFractions) {
  EXPECT_EQ(numbers({0, 60, 3.78, 34, 4, true}), (std::vector<std::string>{"0", "1/2", "1", "1 1/2", "2"}));
  EXPECT_EQ(numbers({0, 60, 1.5, 34, 4, true}), (std::vector<std::string>{"0", "1", "2"}));
}

TEST(Ruler, NumbersNeverTouchAndNeverEnd) {
  for (const bool imperial : {false, true})
    for (double scale = 1e-7; scale < 1e4; scale *= 1.7) {
      const RulerStretch s{-500 / scale, 500 / scale, scale, 34, 4, imperial};
      const std::vector<RulerMark> marks = ruler_marks(s);
      EXPECT_LT(marks.size(), 260U) << scale;
      double last = -1e18;
      for (const RulerMark& mark : marks) {
        if (mark.text.empty()) continue;
        EXPECT_GE((mark.mm - last) * scale, 33.9) << scale;
        last = mark.mm;
      }
    }
}

TEST(Ruler, HasNoMarksWithoutLength) {
  EXPECT_TRUE(ruler_marks({3, 3, 4}).empty());
  EXPECT_TRUE(ruler_marks({0, 10, 0}).empty());
  EXPECT_TRUE(ruler_marks({0, -1, 4}).empty());
}

}  // namespace
}  // namespace weftlight::ui
