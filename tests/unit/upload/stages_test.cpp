#include "upload/stages.h"

#include <gtest/gtest.h>

#include "draft/edits.h"

namespace weftlight::upload {
namespace {

/// 80 x 80 threads in an 8-shaft satin: too many for the whole draft to be shown in fine maps.
Design satin() {
  Design d;
  d.draft = blank_draft(80, 80, 8, 8);
  d.scene.mesh.clear();
  for (int i = 0; i < 80; ++i) d.draft.threading.set(i, i % 8, true), d.draft.treadling.set(i, i % 8, true);
  for (int t = 0; t < 8; ++t)
    for (int s = 0; s < 8; ++s) d.draft.tieup.set(t, s, s * 5 % 8 != t);
  return d;
}

bool same_textures(const PackedCloth& a, const PackedCloth& b) {
  for (size_t k = 0; k < kPackedKinds; ++k) {
    if (a.front.textures[k].levels != b.front.textures[k].levels) return false;
    if (a.back.textures[k].levels != b.back.textures[k].levels) return false;
  }
  return a.width_mm == b.width_mm && a.depth_mm == b.depth_mm && a.lobes == b.lobes;
}

TEST(Stages, ARepeatIsPatchedWhileItLastsAndMadeAnewWhenItGrows) {
  Stages stages;
  Design d = satin();
  EXPECT_TRUE(stages.update(std::make_shared<const Design>(d)).all_maps);
  d = with_tieup(d, 3, 5, !d.draft.tieup.get(3, 5));
  const StageResult patched = stages.update(std::make_shared<const Design>(d));
  EXPECT_FALSE(patched.all_maps);
  EXPECT_FALSE(patched.patches.empty());
  Stages fresh;
  fresh.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));

  d = with_threading(d, 40, 3, true);
  EXPECT_TRUE(stages.update(std::make_shared<const Design>(d)).all_maps);
  Stages anew;
  anew.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(same_textures(stages.packed(), anew.packed()));
}

TEST(Stages, QuickAnswersEndInTheSamePictureAsFullOnes) {
  Stages stages;
  Design d = satin();
  const auto keep = [](const Design& design) { return std::make_shared<const Design>(design); };
  const auto expect_caught_up = [&] {
    stages.update(keep(d), Effort::kFull);
    Stages fresh;
    fresh.update(keep(d));
    EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
  };
  EXPECT_TRUE(stages.update(keep(d), Effort::kQuick).all_maps);
  expect_caught_up();

  d = with_tieup(d, 3, 5, !d.draft.tieup.get(3, 5));
  EXPECT_FALSE(stages.update(keep(d), Effort::kQuick).all_maps) << "painted cells are patched, not baked small";
  d = with_tieup(d, 4, 5, !d.draft.tieup.get(4, 5));
  stages.update(keep(d), Effort::kQuick);
  expect_caught_up();

  d.yarns[0].lobes.along_width = 0.6f;
  EXPECT_TRUE(stages.update(keep(d), Effort::kQuick).lobes.has_value());
  expect_caught_up();
  d.yarns[0].turns_per_m = 900;
  stages.update(keep(d), Effort::kQuick);
  d = with_tieup(d, 4, 6, !d.draft.tieup.get(4, 6));
  stages.update(keep(d), Effort::kQuick);
  expect_caught_up();
}

}  // namespace
}  // namespace weftlight::upload
