#include "cloth/coarse_cloth.h"

#include <gtest/gtest.h>

#include "design/repeat.h"
#include "draft/drawdown.h"
#include "weaves/weaves.h"

namespace weftlight::cloth {

using design::Design, design::warp_up_fraction;
using draft::Face, draft::drawdown;
using weaves::Lean, weaves::satin, weaves::twill;

namespace {

double covered_mm(const std::vector<ThreadBody>& threads) {
  double sum = 0;
  for (const ThreadBody& t : threads) sum += static_cast<double>(t.width_mm);
  return sum;
}

TEST(Thinned, FewerThreadsFillTheSameClothAndShowAsMuchOfTheWarp) {
  const Design design = twill({3, 1}, Lean::kRight, {403, 398});
  const Cloth all = lay_out(design, drawdown(design.draft), Face::kFront, Period::kWholeDraft);
  // Four is the weave's own repeat.
  for (const int group : {3, 4, 7}) {
    const Cloth few = coarse_cloth(all, group, group);
    EXPECT_EQ(few.ends.size(), static_cast<size_t>((403 + group - 1) / group));
    EXPECT_EQ(few.up.cols(), static_cast<int>(few.ends.size()));
    EXPECT_EQ(few.up.rows(), static_cast<int>(few.picks.size()));
    EXPECT_EQ(few.width_mm, all.width_mm);
    EXPECT_NEAR(few.ends.back().centre_mm + 0.5f * few.ends.back().spacing_mm, all.width_mm, 1e-3f * all.width_mm);
    EXPECT_NEAR(covered_mm(few.ends), covered_mm(all.ends), 0.01 * covered_mm(all.ends));
    EXPECT_NEAR(warp_up_fraction(few.up), 0.75, 0.02) << group;
  }
}

TEST(Thinned, OneForOneIsTheSame) {
  const Design design = satin(8, 3, Face::kFront, {16, 16});
  const Cloth all = lay_out(design, drawdown(design.draft), Face::kFront, Period::kWholeDraft);
  const Cloth same = coarse_cloth(all, 1, 1);
  EXPECT_EQ(same.up, all.up);
  EXPECT_EQ(same.ends.size(), all.ends.size());
}

}  // namespace
}  // namespace weftlight::cloth
