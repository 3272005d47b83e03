// The kinds of files that a dialog offers.

#include "app/file_filters.h"

#include <gtest/gtest.h>

namespace weftlight::app {

using platform::FileAsk;

namespace {

TEST(FileFilters, every_draft_that_opens_is_offered_first) {
  const auto filters = file_filters(FileAsk::kOpen, ".wif");
  ASSERT_FALSE(filters.empty());
  EXPECT_EQ(filters[0].patterns, "*.wif *.WIF *.wifw *.WIFW *.dtx *.DTX *.wpo *.WPO");
  EXPECT_EQ(filters.back().patterns, "*");
}

TEST(FileFilters, a_file_is_saved_with_its_own_ending) {
  EXPECT_EQ(file_filters(FileAsk::kSave, ".wif")[0].patterns, "*.wif *.WIF *.wifw *.WIFW");
  EXPECT_EQ(file_filters(FileAsk::kSave, ".pdf")[0].patterns, "*.pdf");
  EXPECT_TRUE(file_filters(FileAsk::kFolder, ".wif").empty());
}

}  // namespace
}  // namespace weftlight::app
