// The plan of a cloth in a file: saved, and there again.

#include <gtest/gtest.h>

#include "lines.h"
#include "wif/wif.h"

namespace weftlight::wif {

using design::ClothPlan, design::Design, design::with_purchase;

namespace {

ClothPlan towel() {
  ClothPlan plan;
  plan.width_mm = 500, plan.length_mm = 700, plan.pieces = 3, plan.fringe_mm = 20, plan.loom_waste_mm = 750;
  plan.warp_take_up = 0.1f, plan.weft_take_up = 0.05f, plan.warp_shrinkage = 0.12f, plan.weft_shrinkage = 0.1f;
  plan.spare = 0.03f, plan.ends_per_cm = 9.5f, plan.picks_per_cm = 8;
  plan.reed = {12, true}, plan.sleying = {1, 1, 2};
  plan.floating_selvedges = true, plan.bout_mm = 51, plan.raddle_mm = 12.5f;
  plan = with_purchase(plan, {"Linen = 16/2; l\xC3\xA4nk", 250, 0, 12.5f});
  return with_purchase(plan, {"Silk", 0, 840, 0});
}

TEST(plan, is_there_again_when_the_file_is_opened_again) {
  const WifFile file = opened(fixture("twill.wif"));
  Design planned = file.design;
  planned.plan = towel();
  for (const std::string& bytes : {write_wif(file, planned), write_new_wif(planned)}) {
    EXPECT_TRUE(opened(bytes).design.plan == towel()) << bytes;
    EXPECT_TRUE(opened(bytes).design == planned);
  }
}

TEST(plan, is_changed_in_its_lines) {
  const WifFile file = opened(fixture("plan.wif"));
  EXPECT_EQ(file.design.plan.sleying, (std::vector<int>{1, 2}));
  Design now = file.design;
  now.plan.sleying = {2, 2, 3};
  now.plan = with_purchase(now.plan, {"Cotton", 0, 840, 9});
  const std::string bytes = write_wif(file, now);
  EXPECT_TRUE(opened(bytes).design == now) << bytes;
  const LineDiff diff = line_diff(file.bytes, bytes);
  EXPECT_EQ(diff.removed.size(), 3u) << "sleying, weight of the cone, price";
  EXPECT_EQ(diff.added.size(), 4u) << "and its length";
}

TEST(plan, only_what_differs_from_the_default_is_written) {
  const WifFile file = opened(fixture("twill.wif"));
  Design planned = file.design;
  planned.plan.loom_waste_mm = 750;
  const std::string bytes = write_wif(file, planned);
  const size_t at = bytes.find("[PRIVATE WEFTLIGHT PLAN]");
  ASSERT_NE(at, std::string::npos);
  EXPECT_NE(bytes.find("Loom Waste=750", at), std::string::npos);
  EXPECT_EQ(bytes.find("Shrinkage", at), std::string::npos);
  EXPECT_EQ(write_wif(opened(bytes), file.design).find("PLAN"), std::string::npos) << "the default is no section";
  EXPECT_EQ(write_plain_wif(planned).find("PRIVATE"), std::string::npos);
}

TEST(plan, of_odd_values_is_the_default_with_a_remark) {
  const WifFile file = opened(fixture("twill.wif"));
  Design planned = file.design;
  planned.plan.width_mm = 500, planned.plan.sleying = {1, 1, 2};
  std::string bytes = write_wif(file, planned);
  bytes.replace(bytes.find("1-1-2"), 5, "x-1-2");
  const WifRead read = read_wif(bytes);
  ASSERT_TRUE(read.file.has_value());
  EXPECT_EQ(read.file->design.plan.sleying, std::vector<int>{1});
  EXPECT_EQ(read.file->design.plan.width_mm, 500);
  EXPECT_FALSE(read.diagnostics.empty());
}

}  // namespace
}  // namespace weftlight::wif
