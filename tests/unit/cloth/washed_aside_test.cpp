// Threads that washing draws sideways.

#include "cloth/washed_aside.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cloth/centre_step.h"
#include "cloth/thickness.h"
#include "drafts.h"
#include "weaves/table.h"

namespace weftlight::cloth {

using draft::Face, draft::drawdown;

namespace {

Design woven(const char* weave, int threads, float spacing_mm, float thickness_mm) {
  const weaves::WeaveKind& kind = *weaves::find_weave(weave);
  Design d = weaves::new_draft(kind, weaves::complete_values(kind, {}), {threads, threads}).design;
  for (auto* of : {&d.draft.warp, &d.draft.weft}) {
    of->spacing_mm.assign(of->color.size(), spacing_mm);
    of->thickness_mm.assign(of->color.size(), thickness_mm);
  }
  return d;
}

/// Mock leno in groups of three.
Design canvas() { return woven("canvas", 24, 1.0f, 0.5f); }

Cloth cloth_of(const Design& d, Face face = Face::kFront) {
  return lay_out(d, drawdown(d.draft), face, Period::kWholeDraft);
}

/// Between the centres of a thread and the next where they cross another.
float apart(const Cloth& cloth, System system, int thread, int crossing) {
  const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
  return threads[0].spacing_mm + aside_at(cloth, system, thread + 1, crossing) -
         aside_at(cloth, system, thread, crossing);
}

TEST(WashedAside, CanvasGathersInGroupsWithHolesBetweenThem) {
  const Cloth cloth = cloth_of(canvas());
  ASSERT_FALSE(cloth.warp_aside_mm.empty());
  for (const System system : {System::kWarp, System::kWeft}) {
    float widest = 0, narrowest = 9;
    for (int i = 0; i < 24; ++i) {
      for (int c = 0; c < 24; ++c) {
        widest = std::max(widest, apart(cloth, system, i, c));
        narrowest = std::min(narrowest, apart(cloth, system, i, c));
      }
    }
    EXPECT_GT(widest, 1.4f);
    EXPECT_LT(narrowest, 0.8f);
  }
}

TEST(WashedAside, PlainWeaveTwillsAndSatinsStayStraight) {
  const Design d = design_of(40, 40, 1.0f, 0.4f);
  for (const BitMatrix& cells : {plain(40, 40), twill(40, 40), satin(40, 40)})
    EXPECT_TRUE(lay_out(d, cells, Face::kFront, Period::kWholeDraft).warp_aside_mm.empty());
}

TEST(WashedAside, EndsThatWeaveAsPairsLieTogether) {
  const Design d = design_of(40, 40, 1.0f, 0.4f);
  const BitMatrix pairs = cells_of(40, 40, [](int e, int p) { return (e / 2 + p) % 2 == 0; });
  const Cloth cloth = lay_out(d, pairs, Face::kFront, Period::kWholeDraft);
  for (int e = 0; e < 40; ++e) {
    if (e % 2 == 0) EXPECT_LT(apart(cloth, System::kWarp, e, 7), 0.8f);
    else EXPECT_GT(apart(cloth, System::kWarp, e, 7), 1.2f);
    EXPECT_EQ(aside_at(cloth, System::kWeft, e, 7), 0);
  }
}

TEST(WashedAside, ThreadsThatTouchAndClothOffTheLoomStayStraight) {
  EXPECT_TRUE(cloth_of(woven("canvas", 24, 0.5f, 0.5f)).warp_aside_mm.empty());
  Design d = canvas();
  d.finish.washed = 0;
  EXPECT_TRUE(cloth_of(d).warp_aside_mm.empty());
  d.finish.washed = 0.5f;
  EXPECT_NEAR(furthest_aside(cloth_of(d)), 0.5f * furthest_aside(cloth_of(canvas())), 0.12f);
}

TEST(WashedAside, NoThreadLeavesHalfItsRoomOrMeetsItsNeighbour) {
  for (const char* weave : {"canvas", "huck", "bronson_lace", "ms_and_os", "deflected", "honeycomb"}) {
    const Cloth cloth = cloth_of(woven(weave, 48, 1.0f, 0.6f));
    if (!cloth.layers.empty()) continue;
    for (const System system : {System::kWarp, System::kWeft}) {
      const auto& threads = system == System::kWarp ? cloth.ends : cloth.picks;
      for (int i = 0; i < static_cast<int>(threads.size()); ++i) {
        for (int c = 0; c < 48; ++c) {
          ASSERT_LT(std::abs(aside_at(cloth, system, i, c)), 0.5f * threads[0].spacing_mm) << weave;
          ASSERT_GT(apart(cloth, system, i, c), threads[0].width_mm - 1e-5f) << weave;
        }
      }
    }
  }
}

TEST(WashedAside, BothFacesShowTheSameThreadsInTheSamePlace) {
  const Cloth front = cloth_of(canvas()), back = cloth_of(canvas(), Face::kBack);
  EXPECT_EQ(front.warp_aside_mm, back.warp_aside_mm);
  EXPECT_EQ(front.weft_aside_mm, back.weft_aside_mm);
}

TEST(WashedAside, AChangedCellMovesOnlyItsNeighbours) {
  const Cloth before = cloth_of(woven("canvas", 48, 1.0f, 0.5f));
  Cloth after = before;
  constexpr int kPick = 23, kEnd = 20;
  after.up.set(kPick, kEnd, !after.up.get(kPick, kEnd));
  const WashedAside was = washed_aside(before, 1), is = washed_aside(after, 1);
  int moved = 0;
  for (int p = 0; p < 48; ++p) {
    for (int e = 0; e < 48; ++e) {
      const size_t i = static_cast<size_t>(p * 48 + e);
      if (is.warp_mm[i] == was.warp_mm[i] && is.weft_mm[i] == was.weft_mm[i]) continue;
      ++moved;
      EXPECT_LE(std::max(std::abs(p - kPick), std::abs(e - kEnd)), kAsideReach);
    }
  }
  EXPECT_GT(moved, 0);
}

TEST(WashedAside, AThreadCrossesOthersWhereTheyAre) {
  const Cloth cloth = cloth_of(canvas());
  for (int end = 0; end < 24; ++end) {
    for (int pick = 1; pick < 23; ++pick) {
      const float at = cloth.picks[static_cast<size_t>(pick)].centre_mm + aside_at(cloth, System::kWeft, pick, end);
      const CentreStep step = centre_step(cloth, System::kWarp, end, at + 1e-4f);
      EXPECT_EQ(step.crossing, pick);
      EXPECT_NEAR(step.t, 0, 1e-3f);
      EXPECT_NEAR(section_at(cloth, System::kWarp, end, step).z, aside_at(cloth, System::kWarp, end, pick), 1e-3f);
    }
  }
}

}  // namespace
}  // namespace weftlight::cloth
