// Numbers as the user's language writes them.

#include "base/decimals.h"

#include <gtest/gtest.h>

#include "base/text.h"

namespace weftlight::base {
namespace {

template <class... Values>
std::string with_comma(const char* pattern, Values&&... values) {
  return filled_with_point(pattern, fmt::make_format_args(values...), ',');
}

TEST(Decimals, a_language_chooses_the_point_of_floats) {
  EXPECT_EQ(with_comma("{width:.1f} x {height:.2f} mm", arg("width", 1.25), arg("height", 3.0f)), "1,2 x 3,00 mm");
  EXPECT_EQ(with_comma("{change:+.1f}% of {dents:.4g}", arg("change", 2.5), arg("dents", 12.5)), "+2,5% of 12,5");
  EXPECT_EQ(with_comma("{big:.0f}", arg("big", 12345678.0)), "12345678") << "digits are not grouped";
}

TEST(Decimals, leave_other_fields_alone) {
  EXPECT_EQ(with_comma("{file}, {count:>4}, {{target}}", arg("file", "a.1.wif"), arg("count", 7)),
            "a.1.wif,    7, {target}");
  EXPECT_THROW(with_comma("no field {", arg("unused", 1.5)), fmt::format_error);
}

TEST(Decimals, are_points_in_english) {
  EXPECT_EQ(decimal_point(), '.');
  EXPECT_EQ(fill("{width:.1f} mm", arg("width", 2.5)), "2.5 mm");
  EXPECT_EQ(with_decimal_point("2.5 mm"), "2.5 mm");
}

}  // namespace
}  // namespace weftlight::base
