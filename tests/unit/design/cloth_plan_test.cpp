// The plan of a cloth: its limits, sleyings as text, and how yarns are bought.

#include "design/cloth_plan.h"

#include <gtest/gtest.h>

#include <limits>

#include "design/edits.h"

namespace weftlight::design {
namespace {

TEST(ClothPlan, NumbersAreLimitedAndWhatIsNoSleyingIsTheUsualOne) {
  ClothPlan wild;
  wild.width_mm = -4, wild.warp_shrinkage = 7, wild.spare = std::numeric_limits<float>::quiet_NaN();
  wild.pieces = -2, wild.bout_mm = 0, wild.sleying = {0, 0};
  wild.purchases = {{"b", 1, 0, 0}, {"a", 0, 0, -3}, {"b", 2, 0, 0}};
  const ClothPlan plan = clamped(wild);
  EXPECT_EQ(plan.width_mm, 0);
  EXPECT_EQ(plan.warp_shrinkage, kMaxShrinkage);
  EXPECT_EQ(plan.spare, ClothPlan{}.spare);
  EXPECT_EQ(plan.pieces, 1);
  EXPECT_GT(plan.bout_mm, 0);
  EXPECT_EQ(plan.sleying, std::vector<int>{1});
  EXPECT_EQ(plan.purchases, (std::vector<YarnPurchase>{{"b", 1, 0, 0}})) << "the first of a name, and no empty one";
  EXPECT_EQ(clamped(plan), plan);
}

TEST(ClothPlan, SleyingsAsText) {
  EXPECT_EQ(sleying_text({1, 1, 2}), "1-1-2");
  EXPECT_EQ(sleying_from_text("1-1-2"), (std::vector<int>{1, 1, 2}));
  EXPECT_EQ(sleying_from_text(" 2 "), std::vector<int>{2});
  EXPECT_EQ(sleying_from_text("0, 1"), (std::vector<int>{0, 1}));
  for (const char* wrong : {"", "0", "a", "1-x", "99", "-"}) EXPECT_TRUE(sleying_from_text(wrong).empty()) << wrong;
  EXPECT_TRUE(sleying_from_text(std::string(1000, '1') + "-").empty());
  EXPECT_DOUBLE_EQ(ends_per_dent({1, 1, 2}), 4.0 / 3);
}

TEST(ClothPlan, APurchaseStaysWithItsYarn) {
  Design d;
  d.yarns = {Yarn{}, Yarn{}};
  d.yarns[0].name = "Linen";
  d.yarns[1].name = "Silk";
  d.plan = with_purchase(d.plan, {"Linen", 250, 0, 12});
  Yarn renamed = d.yarns[0];
  renamed.name = "Line linen";
  d = with_yarn(d, 0, renamed);
  EXPECT_EQ(purchase_of(d.plan, "Line linen").price, 12);
  EXPECT_EQ(purchase_of(d.plan, "Linen").price, 0);
  EXPECT_EQ(d.plan.purchases.size(), 1u);
  d.plan = with_purchase(d.plan, {"Line linen", 0, 0, 0});
  EXPECT_TRUE(d.plan.purchases.empty()) << "nothing is known of it";
}

}  // namespace
}  // namespace weftlight::design
