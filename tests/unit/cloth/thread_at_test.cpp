// thread_at() of shaders/threads.glsl: which thread is at a position, for threads of very different spacings.

#include <gtest/gtest.h>

#include "cloth/thread_scene.h"
#include "drafts.h"

namespace weftlight::cloth {

using design::Design;
using draft::Face;

namespace {

constexpr int kFine = 60, kCoarse = 8;

/// Eight ends 20 mm apart in the middle of sixty 0.05 mm apart.
Cloth coarse_among_fine() {
  Design d = design_of(kFine + kCoarse, 8, 0.05f, 0.04f);
  for (size_t e = kFine / 2; e < kFine / 2 + kCoarse; ++e)
    d.draft.warp.spacing_mm[e] = 20, d.draft.warp.thickness_mm[e] = 1;
  return lay_out(d, plain(kFine + kCoarse, 8), Face::kFront, Period::kWholeDraft);
}

int first_past(const std::vector<ThreadBody>& threads, float position) {
  int i = 0;
  while (i + 1 < static_cast<int>(threads.size()) &&
         threads[static_cast<size_t>(i)].centre_mm + 0.5f * threads[static_cast<size_t>(i)].spacing_mm <= position)
    ++i;
  return i;
}

TEST(ThreadAt, FindsFineThreadsAmongCoarseOnes) {
  const Cloth cloth = coarse_among_fine();
  ASSERT_EQ(cloth.ends.size(), static_cast<size_t>(kFine + kCoarse));
  ThreadScene threads(cloth);
  const auto grid = threads.grid();
  int wrong = 0;
  for (const ThreadBody& end : cloth.ends) {
    for (const float fraction : {-0.4f, 0.0f, 0.4f}) {
      const float position = end.centre_mm + fraction * end.spacing_mm;
      wrong += threads.thread_at(grid, 0, position) != first_past(cloth.ends, position);
    }
  }
  EXPECT_EQ(wrong, 0) << "of " << 3 * cloth.ends.size() << " positions";
}

}  // namespace
}  // namespace weftlight::cloth
