// The text of a yarn's count in the panel.

#include "views/inspector/count_row.h"

#include <gtest/gtest.h>

#include "../yarns.h"
#include "design/fibre.h"

namespace weftlight::views {

using design::Yarn, design::with_count;

namespace {

TEST(CountRow, HasTheUnitsOfTheTradeAndTheSourceOfTheCount) {
  const Yarn cotton = *with_count(yarn_preset("Cotton"), "Ne 40");
  EXPECT_EQ(count_in_words(cotton), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\n61% of the yarn is fibre");
  Yarn yarn = cotton;
  yarn.diameter_mm *= 2;
  EXPECT_EQ(count_in_words(yarn), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\n15% of the yarn is fibre");
  yarn.diameter_mm /= 4;
  EXPECT_EQ(count_in_words(yarn), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\ntoo much fibre for this thickness");
  yarn = *with_count(cotton, "");
  EXPECT_NE(count_in_words(yarn).find("\ncomputed from the thickness"), std::string::npos);
  yarn.diameter_mm = 0;
  EXPECT_EQ(count_in_words(yarn), "thickness set by the draft");
}

}  // namespace
}  // namespace weftlight::views
