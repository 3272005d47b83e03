// The text of a yarn's count in the panel.

#include "views/inspector/count_row.h"

#include <gtest/gtest.h>

#include "../straight_draft.h"
#include "../yarns.h"
#include "design/fibre.h"

namespace weftlight::views {

using design::Yarn, design::with_count;

namespace {

TEST(CountRow, HasTheUnitsOfTheTradeAndTheSourceOfTheCount) {
  const Yarn cotton = *with_count(yarn_preset("Cotton"), "Ne 40");
  EXPECT_EQ(count_in_words(cotton), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\n46% of the yarn is fibre");
  Yarn yarn = cotton;
  yarn.diameter_mm *= 2;
  EXPECT_EQ(count_in_words(yarn), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\n11% of the yarn is fibre");
  yarn.diameter_mm /= 4;
  EXPECT_EQ(count_in_words(yarn), "14.8 tex; Ne 40.0, Nm 67.7, 133 den\ntoo much fibre for this thickness");
  yarn = *with_count(cotton, "");
  EXPECT_NE(count_in_words(yarn).find("\ncomputed from the thickness"), std::string::npos);
  EXPECT_NE(count_in_words(yarn).find(" tex; Ne "), std::string::npos) << "the field has it in Ne";
  yarn.diameter_mm = 0;
  EXPECT_EQ(count_in_words(yarn), "thickness set by the draft");
}

TEST(CountRow, TellsTheCountOfTheDraftsThreads) {
  design::Design d = straight_draft(4);
  EXPECT_EQ(count_in_draft(d, 0), "") << "they are as thick as the yarn";
  d.yarns[0] = *with_count(yarn_preset("Cotton"), "100 tex");
  const float thick = d.yarns[0].diameter_mm;
  d.draft.warp.thickness_mm.assign(4, 2 * thick);
  EXPECT_TRUE(count_in_draft(d, 0).ends_with(" mm, 400 tex")) << count_in_draft(d, 0);
  EXPECT_TRUE(count_in_draft(d, 0).starts_with("Ends: ")) << count_in_draft(d, 0);
  d.draft.weft.thickness_mm.assign(4, 0.5f * thick);
  EXPECT_NE(count_in_draft(d, 0).find("\nPicks: "), std::string::npos);
  d.yarns.emplace_back();
  EXPECT_EQ(count_in_draft(d, 1), "") << "it has no threads";
}

}  // namespace
}  // namespace weftlight::views
