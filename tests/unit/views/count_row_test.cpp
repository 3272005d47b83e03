// What the panel says of a yarn's count.

#include "views/inspector/count_row.h"

#include <gtest/gtest.h>

#include "../yarns.h"
#include "draft/fibre.h"

namespace weftlight::views {
namespace {

TEST(CountRow, SaysTheUnitsOfTheTradeAndWhereTheCountIsFrom) {
  const Yarn cotton = *with_count(yarn_preset("Cotton"), "Ne 40");
  EXPECT_EQ(count_in_words(cotton), "Ne 40.0, Nm 67.7, 133 den\n61 % of it is fibre");
  Yarn yarn = cotton;
  yarn.diameter_mm *= 2;
  EXPECT_EQ(count_in_words(yarn), "Ne 40.0, Nm 67.7, 133 den\n15 % of it is fibre");
  yarn.diameter_mm /= 4;
  EXPECT_EQ(count_in_words(yarn), "Ne 40.0, Nm 67.7, 133 den\nmore than fits in its thickness");
  yarn = *with_count(cotton, "");
  EXPECT_NE(count_in_words(yarn).find("\nfollows the thickness"), std::string::npos);
  yarn.diameter_mm = 0;
  EXPECT_EQ(count_in_words(yarn), "as thick as the draft says");
}

}  // namespace
}  // namespace weftlight::views
