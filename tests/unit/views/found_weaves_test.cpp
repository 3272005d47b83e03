// The order of the weaves that typing finds.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "views/dialogs/dialog_parts.h"

namespace weftlight::views {

using weaves::weave_kinds;

namespace {

std::vector<std::string> found(const std::string& typed) {
  std::vector<std::string> ids;
  for (const int i : found_weaves(typed)) ids.emplace_back(weave_kinds()[static_cast<size_t>(i)].id);
  return ids;
}

bool stands_before(const std::vector<std::string>& list, const std::string& one, const std::string& other) {
  const auto at = std::ranges::find(list, one);
  return at != list.end() && std::ranges::find(at, list.end(), other) != list.end();
}

TEST(FoundWeaves, NamesStandBeforeFamiliesAndDescriptions) {
  EXPECT_EQ(found("satin").front(), "satin");
  EXPECT_EQ(found(" Satin ").front(), "satin");
  EXPECT_EQ(found("tw").front(), "twill") << "names that begin so";
  EXPECT_TRUE(stands_before(found("satin"), "satin", "broken_twill")) << "its description speaks of satin";
  EXPECT_TRUE(stands_before(found("twill"), "undulating_twill", "herringbone")) << "of the family, with another name";
  EXPECT_TRUE(found("no such weave").empty());
}

TEST(FoundWeaves, AllStandInTheirOrderWhereNothingIsTyped) {
  const std::vector<int> all = found_weaves("");
  ASSERT_EQ(all.size(), weave_kinds().size());
  EXPECT_TRUE(std::ranges::is_sorted(all));
}

}  // namespace
}  // namespace weftlight::views
