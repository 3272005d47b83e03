// Versions and colourways: kept, gone back to, renamed, deleted, and shared by the steps of undo.

#include "design/versions.h"

#include <gtest/gtest.h>

#include "analysis/difference.h"
#include "design/edits.h"
#include "design/history.h"
#include "weaves/weaves.h"

namespace weftlight::design {

using analysis::compare;
using weaves::Lean, weaves::twill;

namespace {

Design sample() {
  Design d = twill({2, 2}, Lean::kRight, {16, 16});
  d.title = "Scarf";
  d.loom.next_pick = 7;
  return d;
}

Design recoloured(Design d) {
  d.draft.palette[0] = {0.8f, 0.1f, 0.1f};
  return with_thread_color(std::move(d), System::kWeft, 3, 0);
}

TEST(Versions, GoingBackRestoresWhatIsWovenAndNothingElse) {
  const Design first = with_version(sample(), "  Blue ");
  ASSERT_EQ(first.versions.size(), 1u);
  EXPECT_EQ(first.versions[0].name, "Blue");
  Design now = recoloured(first);
  now = with_threading(std::move(now), 2, 1, true, true);
  now.title = "Shawl", now.loom.next_pick = 9, now.scene.mesh = "skirt";
  EXPECT_EQ(current_version(now), nullptr);
  const Design back = at_version(now, now.versions[0]);
  EXPECT_EQ(back.draft, first.draft);
  EXPECT_EQ(back.title, "Shawl") << "the title is the file's";
  EXPECT_EQ(back.loom.next_pick, 9) << "the place at the loom is kept";
  EXPECT_EQ(back.scene.mesh, "skirt");
  EXPECT_EQ(back.versions, now.versions);
  EXPECT_EQ(current_version(back), &back.versions[0]);
  EXPECT_TRUE(is_consistent(back));
}

TEST(Versions, OfANameAreReplacedAndNamesStayUnique) {
  Design d = with_version(sample(), "A");
  d = with_version(recoloured(std::move(d)), "A");
  ASSERT_EQ(d.versions.size(), 1u);
  EXPECT_EQ(current_version(d), &d.versions[0]);
  EXPECT_EQ(with_version(d, " \t"), d) << "no name, no version";
  d = with_version(std::move(d), "B");
  d = with_renamed_version(std::move(d), 1, "A");
  EXPECT_EQ(d.versions[1].name, "A 2");
  EXPECT_EQ(with_renamed_version(d, 1, " "), d);
  EXPECT_EQ(version_named(d, "a 2"), &d.versions[1]);
  const Design both = with_version(d, "a");
  EXPECT_EQ(version_named(both, "a"), &both.versions[2]) << "the exact name first";
  d = without_version(std::move(d), 0);
  ASSERT_EQ(d.versions.size(), 1u);
  EXPECT_EQ(d.versions[0].name, "A 2");
  EXPECT_EQ(free_version_name(d), "Version 2");
}

TEST(Versions, HaveALimit) {
  Design d = sample();
  for (size_t i = 0; i < kMaxVersions; ++i) d = with_version(std::move(d), std::to_string(i));
  EXPECT_FALSE(has_room_for_version(d));
  EXPECT_EQ(with_version(d, "one more"), d);
  EXPECT_NE(with_version(recoloured(d), "3"), d) << "one of them can still be replaced";
}

TEST(Versions, AreColourwaysIfColoursAloneDiffer) {
  const Design d = sample();
  EXPECT_TRUE(is_colourway(d, recoloured(d)));
  EXPECT_FALSE(is_colourway(d, with_threading(d, 2, 1, true, true)));
  Design thick = d;
  thick.draft.warp.thickness_mm[0] = 2;
  EXPECT_FALSE(is_colourway(d, thick));
}

TEST(Versions, GoWithUndoAndTakeMemoryOnce) {
  History history(twill({2, 2}, Lean::kRight, {512, 512}));
  const size_t before = history.kept_bytes();
  history.commit(with_version(history.now(), "A"), "keep");
  const size_t kept = history.kept_bytes();
  EXPECT_GT(kept, before);
  history.commit(recoloured(history.now()), "colour");
  EXPECT_LT(history.kept_bytes() - kept, 3 * before) << "steps share the version";
  history.commit(at_version(history.now(), history.now().versions[0]), "back");
  EXPECT_EQ(current_version(history.now()), &history.now().versions[0]);
  history.undo();
  EXPECT_EQ(current_version(history.now()), nullptr);
  history.go_to(0);
  EXPECT_TRUE(history.now().versions.empty());
}

TEST(Versions, AreComparedToo) {
  const Design a = sample(), b = with_version(a, "Blue");
  const auto differences = compare(a, b).differences;
  ASSERT_EQ(differences.size(), 1u);
  EXPECT_EQ(differences[0].what, "versions");
  EXPECT_EQ(differences[0].b, "Blue");
}

}  // namespace
}  // namespace weftlight::design
