#include "render_data/stages.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>

#include "../scratch.h"
#include "base/whole_files.h"
#include "design/edits.h"

namespace weftlight::render_data {

using design::Design, design::with_threading, design::with_tieup;
using draft::Draft, draft::blank_draft;

namespace {

// Which stages run, and that what they leave is what a fresh update makes: coarse maps show it as well as fine ones.
constexpr Fineness kCoarse{4, 128};

/// 80 x 80 threads of an 8-shaft satin: too many to bake the whole draft in fine maps.
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
  return a.width_mm == b.width_mm && a.depth_mm == b.depth_mm && a.lobes == b.lobes && a.crossings == b.crossings &&
         a.asides == b.asides;
}

TEST(Stages, ARepeatIsPatchedWhileItLastsAndMadeAnewWhenItGrows) {
  Stages stages(kCoarse);
  Design d = satin();
  EXPECT_TRUE(stages.update(std::make_shared<const Design>(d)).all_maps);
  d = with_tieup(d, 3, 5, !d.draft.tieup.get(3, 5));
  const StageResult patched = stages.update(std::make_shared<const Design>(d));
  EXPECT_FALSE(patched.all_maps);
  EXPECT_FALSE(patched.patches.empty());
  Stages fresh(kCoarse);
  fresh.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));

  d = with_threading(d, 40, 3, true);
  EXPECT_TRUE(stages.update(std::make_shared<const Design>(d)).all_maps);
  Stages anew(kCoarse);
  anew.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(same_textures(stages.packed(), anew.packed()));
}

/// 199 x 199 threads with random picks: without a repeat, and with a tie-up cell that changes about 2,500 crossings.
Design unordered() {
  Design d;
  d.draft = blank_draft(199, 199, 4, 4);
  d.scene.mesh.clear();
  uint32_t random = 1;
  for (int i = 0; i < 199; ++i) {
    random = random * 1664525u + 1013904223u;
    d.draft.threading.set(i, i % 4, true), d.draft.treadling.set(i, static_cast<int>(random >> 30), true);
  }
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) d.draft.tieup.set(t, s, (s + t) % 4 < 2);
  return d;
}

TEST(Stages, OfALargeDraftNoMapsAreKeptAndEditsBakeWindows) {
  constexpr Fineness kNoneKept{4, 128, 1000};
  Stages stages(kNoneKept), with_maps(kCoarse);
  Design d = unordered();
  const auto same = [&] {
    for (size_t k = 0; k < kPackedKinds; ++k) {
      EXPECT_EQ(stages.packed().front.textures[k].levels, with_maps.packed().front.textures[k].levels);
      EXPECT_EQ(stages.packed().back.textures[k].levels, with_maps.packed().back.textures[k].levels);
    }
  };
  const auto update = [&](Stages& of) { return of.update(std::make_shared<const Design>(d)); };
  update(stages), update(with_maps);
  same();
  for (const int pick : {3, 190}) {
    for (int s = 0; s < 4; ++s) d = design::with_treadling(d, pick, s, !d.draft.treadling.get(pick, s));
    const StageResult edited = update(stages);
    EXPECT_FALSE(edited.all_maps);
    EXPECT_FALSE(edited.patches.maps.empty());
    update(with_maps);
    same();
    Stages fresh(kNoneKept);
    update(fresh);
    EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
  }
}

TEST(Stages, ThreadsThatWashingMovesArePatchedOnceThereAreSome) {
  Stages stages(kCoarse);
  Design d = satin();
  for (auto* threads : {&d.draft.warp, &d.draft.weft}) threads->spacing_mm.assign(threads->color.size(), 1.2f);
  stages.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(stages.packed().asides.empty());
  // Squares of plain weave among the floats.
  for (int t = 0; t < 4; ++t)
    for (int s = 0; s < 4; ++s) d = with_tieup(d, t, s, (t + s) % 2 == 0);
  EXPECT_TRUE(stages.update(std::make_shared<const Design>(d)).all_maps);
  EXPECT_FALSE(stages.packed().asides.empty());
  for (const auto& [treadle, shaft] : {std::pair{5, 1}, {2, 7}}) {
    d = with_tieup(d, treadle, shaft, !d.draft.tieup.get(treadle, shaft));
    const StageResult patched = stages.update(std::make_shared<const Design>(d));
    EXPECT_FALSE(patched.all_maps);
    ASSERT_FALSE(patched.patches.crossings.empty());
    EXPECT_FALSE(patched.patches.crossings.front().asides.empty());
    Stages fresh(kCoarse);
    fresh.update(std::make_shared<const Design>(d));
    EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
  }
}

TEST(Stages, QuickAnswersEndInTheSamePictureAsFullOnes) {
  Stages stages(kCoarse);
  Design d = satin();
  const auto keep = [](const Design& design) { return std::make_shared<const Design>(design); };
  const auto expect_caught_up = [&] {
    stages.update(keep(d), Effort::kFull);
    Stages fresh(kCoarse);
    fresh.update(keep(d));
    EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
  };
  EXPECT_TRUE(stages.update(keep(d), Effort::kQuick).all_maps);

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

TEST(Stages, OfManyCellsWhatIsSeenComesFirst) {
  Stages stages(kCoarse);
  const auto keep = [](const Design& design) { return std::make_shared<const Design>(design); };
  const Design before = unordered(), after = with_tieup(before, 2, 2, !before.draft.tieup.get(2, 2));
  stages.update(keep(before));
  const PackedTexture& color = stages.packed().front.textures[0];
  // Shown whole, four texels a pixel.
  const float texel_mm = stages.packed().width_mm / static_cast<float>(color.width);
  stages.set_visible_part({0, 0, 1e6f, 1e6f, 4 * texel_mm});
  const StageResult seen = stages.update(keep(after), Effort::kQuick);
  EXPECT_FALSE(seen.all_maps);
  ASSERT_FALSE(seen.patches.maps.empty());
  for (const PackedPatch& p : seen.patches.maps) {
    EXPECT_GE(p.level, 2) << "as fine as the pixels, and no finer";
    const PackedTexture& whole = stages.packed().front.textures[static_cast<size_t>(p.kind)];
    EXPECT_EQ(p.width, whole.level_width(p.level)) << "all of it is seen";
    EXPECT_EQ(p.texels.size(),
              static_cast<size_t>(p.width) * static_cast<size_t>(p.height * whole.layers * whole.channels));
  }

  const StageResult full = stages.update(keep(after));
  EXPECT_TRUE(full.all_maps) << "over what was sent in the meantime";
  Stages fresh(kCoarse);
  fresh.update(keep(after));
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
}

TEST(Stages, WhatWasSeenOfAnEditGoesWithItsUndo) {
  Stages stages(kCoarse);
  const auto keep = [](const Design& design) { return std::make_shared<const Design>(design); };
  const Design before = unordered(), after = with_tieup(before, 2, 2, !before.draft.tieup.get(2, 2));
  stages.update(keep(before));
  Stages fresh(kCoarse);
  fresh.update(keep(before));
  // Close up: a corner of the cloth, two threads a pixel, drawn one by one.
  const float mm = stages.packed().width_mm / 199;
  stages.set_visible_part({10 * mm, 20 * mm, 40 * mm, 50 * mm, 0.05f * mm});
  const StageResult near = stages.update(keep(after), Effort::kQuick);
  ASSERT_EQ(near.patches.crossings.size(), 1u);
  EXPECT_LT(near.patches.crossings[0].texels.size(), 2000u);
  for (const PackedPatch& p : near.patches.maps) EXPECT_LT(p.width, 128);
  EXPECT_FALSE(stages.update(keep(before), Effort::kQuick).patches.empty()) << "as it was before";
  EXPECT_TRUE(stages.update(keep(before)).all_maps);
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
}

/// The stages that an update runs.
std::set<std::string> stages_of(Stages& stages, const Design& design, Effort effort = Effort::kFull) {
  std::mutex mutex;
  std::set<std::string> ran;
  stages.update(std::make_shared<const Design>(design), effort, {{}, [&](const char* stage, size_t, size_t) {
                                                                   const std::lock_guard lock(mutex);
                                                                   ran.insert(stage);
                                                                 }});
  return ran;
}

TEST(Stages, WhatAnEditDoesNotTouchIsNotComputedAgain) {
  Stages stages(kCoarse);
  Design d = satin();
  stages.update(std::make_shared<const Design>(d));
  EXPECT_TRUE(stages_of(stages, d).empty());

  d.scene.lights = "window";
  EXPECT_EQ(stages_of(stages, d), (std::set<std::string>{"lights"}));
  d.yarns[0].tex += 1;
  EXPECT_TRUE(stages_of(stages, d).empty()) << "weighs, and is not visible";
  d.yarns[0].lobes.along_width = 0.6f;
  const std::set<std::string> of_lobes = stages_of(stages, d);
  EXPECT_TRUE(of_lobes.contains("response"));
  EXPECT_FALSE(of_lobes.contains("drawdown") || of_lobes.contains("front: threads") ||
               of_lobes.contains("front: maps"));

  d = with_tieup(d, 3, 5, !d.draft.tieup.get(3, 5));
  const std::set<std::string> painted = stages_of(stages, d, Effort::kQuick);
  EXPECT_TRUE(painted.contains("front: maps"));
  EXPECT_FALSE(painted.contains("back: maps") || painted.contains("response")) << "wait for the full update";
  const std::set<std::string> rest = stages_of(stages, d);
  EXPECT_TRUE(rest.contains("back: maps") && rest.contains("response"));
  EXPECT_FALSE(rest.contains("front: maps")) << "are up to date";
}

// The window stops a full update when a newer design comes.
TEST(Stages, AStoppedUpdateIsFinishedByTheNext) {
  const Design before = satin(), after = with_tieup(before, 3, 5, !before.draft.tieup.get(3, 5));
  Stages fresh(kCoarse);
  fresh.update(std::make_shared<const Design>(after));
  for (const std::string last : {"front: mips", "back: maps"}) {
    SCOPED_TRACE(last);
    Stages stages(kCoarse);
    EXPECT_TRUE(stages.update(std::make_shared<const Design>(before), Effort::kQuick).all_maps);
    std::stop_source stop;
    const auto starts = [&](const char* stage, size_t, size_t) {
      if (stage == last) stop.request_stop();
    };
    const StageResult stopped =
        stages.update(std::make_shared<const Design>(before), Effort::kFull, {stop.get_token(), starts});
    EXPECT_TRUE(stopped.stopped);
    EXPECT_FALSE(stopped.all_maps || stopped.lobes || !stopped.patches.empty()) << "nothing is handed over by half";
    const StageResult quick = stages.update(std::make_shared<const Design>(after), Effort::kQuick);
    EXPECT_FALSE(quick.stopped);
    const PackedTexture &front = stages.packed().front.textures[0], &back = stages.packed().back.textures[0];
    EXPECT_EQ(front.width, back.width) << "the faces share textures";
    EXPECT_EQ(front.levels.size(), back.levels.size());
    stages.update(std::make_shared<const Design>(after));
    EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
  }
}

TEST(Stages, AfterAStopALargeEditIsStillPreviewed) {
  Stages stages(kCoarse);
  const Design before = unordered(), after = with_tieup(before, 2, 2, !before.draft.tieup.get(2, 2)),
               later = with_tieup(after, 1, 1, !before.draft.tieup.get(1, 1));
  const auto keep = [](const Design& design) { return std::make_shared<const Design>(design); };
  stages.update(keep(before));
  stages.set_visible_part({0, 0, 1e6f, 1e6f, 1.2f});
  EXPECT_FALSE(stages.update(keep(after), Effort::kQuick).patches.empty());
  std::stop_source stop;
  const auto starts = [&](const char* stage, size_t, size_t) {
    if (std::string_view(stage) == "front: threads") stop.request_stop();
  };
  EXPECT_TRUE(stages.update(keep(after), Effort::kFull, {stop.get_token(), starts}).stopped);
  EXPECT_TRUE(stages_of(stages, later, Effort::kQuick).empty()) << "no stage of the cloth runs";
  EXPECT_TRUE(stages.update(keep(later)).all_maps);
  Stages fresh(kCoarse);
  fresh.update(keep(later));
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
}

// Memory may be there again, a wrong file is not right because it is read again.
TEST(Stages, WhatLackedMemoryIsTriedAgainWithoutAChange) {
  static base::ErrorKind kind;
  static int runs;
  const auto fails_once = [](StageWork&, Change) -> base::Result<Outcome> {
    if (++runs == 1) return base::failure(kind, "it failed");
    return Outcome{};
  };
  const Stage stage{Node::kMesh, "mesh", {Node::kDrape}, fails_once};
  const StageInput input;
  StageData data;
  StageResult result;
  StageWork work{input, Effort::kFull, data, result};
  for (const base::ErrorKind why : {base::ErrorKind::kMemory, base::ErrorKind::kInput}) {
    StageKeys keys;
    kind = why, runs = 0;
    const auto update = [&] { return keys.run({&stage, 1}, work, Effort::kFull, {}); };
    update();
    EXPECT_FALSE(keys.made({&stage, 1}));
    update();
    EXPECT_EQ(keys.made({&stage, 1}).has_value(), why == base::ErrorKind::kMemory);
    update();
    EXPECT_EQ(runs, why == base::ErrorKind::kMemory ? 2 : 1);
  }
}

TEST(Stages, ADraftWithoutThreadsIsAProblemUntilItHasSome) {
  Stages stages(kCoarse);
  const Design good = satin();
  stages.update(std::make_shared<const Design>(good));
  Design bad = good;
  bad.draft = Draft{};
  const auto update = [&](const Design& d) { return stages.update(std::make_shared<const Design>(d)); };
  const std::string problem = problem_of(update(bad).made);
  EXPECT_FALSE(problem.empty());
  bad.scene.lights = "window";
  const StageResult again = update(bad);
  EXPECT_EQ(problem_of(again.made), problem) << "told as long as it is so";
  EXPECT_TRUE(again.lights) << "the scene does not depend on it";
  EXPECT_EQ(problem_of(update(good).made), "");
  Stages fresh(kCoarse);
  fresh.update(std::make_shared<const Design>(good));
  EXPECT_TRUE(same_textures(stages.packed(), fresh.packed()));
}

// The preview keeps the lights that it has.
TEST(Stages, ASinglePictureDoesNotWaitForClothThatCannotBeShown) {
  Design d = satin();
  d.scene.mesh = "no_such_drape";
  Stages stages(kCoarse);
  std::mutex mutex;
  std::set<std::string> ran;
  const StageResult none =
      stages.update(std::make_shared<const Design>(d), Effort::kOnce, {{}, [&](const char* stage, size_t, size_t) {
                                                                         const std::lock_guard lock(mutex);
                                                                         ran.insert(stage);
                                                                       }});
  EXPECT_FALSE(none.made);
  EXPECT_FALSE(none.stopped) << "the reason is lost";
  EXPECT_FALSE(ran.contains("response"));
}

TEST(Stages, APictureOfLightThatCannotBeReadIsToldAndTheOldLightStays) {
  const Scratch scratch;
  Stages stages(kCoarse);
  Design d = satin();
  const auto update = [&] { return stages.update(std::make_shared<const Design>(d)); };
  const StageResult first = update();
  EXPECT_TRUE(first.lights && first.made) << problem_of(first.made);
  for (const char* size : {"-Y 64 +X 64", "-Y 30000 +X 60000", "-Y 64 +X 128"}) {  // square, huge, empty
    const std::string path = scratch / "light.hdr";
    ASSERT_EQ(problem_of(base::write_file_atomically(
                  path, std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n") + size + "\n")),
              "");
    d.scene.lights = path;
    const StageResult broken = update();
    EXPECT_FALSE(broken.lights) << size;
    ASSERT_FALSE(broken.made) << size;
    EXPECT_EQ(broken.made.error().file, path) << problem_of(broken.made);
    EXPECT_EQ(problem_of(update().made), problem_of(broken.made)) << "told as long as the design asks for it";
    d.scene.lights = "window";
    const StageResult mended = update();
    EXPECT_TRUE(mended.lights && mended.made) << problem_of(mended.made);
  }
}

}  // namespace
}  // namespace weftlight::render_data
