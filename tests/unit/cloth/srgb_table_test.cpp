// The tables of the sRGB curve are the curve.

#include "cloth/srgb_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "design/srgb.h"

namespace weftlight::cloth {

using design::srgb_decoded;
using design::srgb_encoded;

namespace {

TEST(SrgbTable, every_byte_comes_back) {
  const SrgbTable& table = SrgbTable::get();
  for (int byte = 0; byte < 256; ++byte) {
    const float linear = table.decoded(static_cast<uint8_t>(byte));
    EXPECT_EQ(table.encoded_byte(linear), byte);
    EXPECT_FLOAT_EQ(linear, srgb_decoded(static_cast<float>(byte) / 255.0f));
  }
}

TEST(SrgbTable, is_within_a_tenth_of_a_byte_of_the_curve) {
  const SrgbTable& table = SrgbTable::get();
  for (int i = 0; i <= 100000; ++i) {
    const float linear = static_cast<float>(i) / 100000;
    EXPECT_NEAR(table.encoded(linear), srgb_encoded(linear), 0.0004f) << linear;
    EXPECT_NEAR(table.encoded_byte(linear), 255 * srgb_encoded(linear), 0.6f) << linear;
  }
  EXPECT_FLOAT_EQ(table.encoded(2.0f), 1.0f);
  EXPECT_EQ(table.encoded_byte(-1.0f), 0);
}

TEST(SrgbTable, what_is_no_number_is_black) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(SrgbTable::get().encoded(nan), 0.0f);
  EXPECT_EQ(SrgbTable::get().encoded_byte(nan), 0);
}

}  // namespace
}  // namespace weftlight::cloth
