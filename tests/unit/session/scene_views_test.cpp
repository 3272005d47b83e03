// Named views of the cloth: saved, shown, renamed, deleted, and in the file.

#include "session/editing/scene_views.h"

#include <gtest/gtest.h>

#include "design/edits.h"
#include "wif/wif.h"

namespace weftlight::session {

using design::Design, design::NamedView, design::Scene;
using draft::blank_draft;
using scene::ShippedView, scene::drawn_scene, scene::kFlatMesh, scene::kShippedViews, scene::view_named;

namespace {

Design plain() {
  Design d;
  d.draft = blank_draft(8, 8, 2, 2);
  for (int i = 0; i < 8; ++i) d.draft.threading.set(i, i % 2, true);
  return d;
}

ClothView seen_from(float azimuth, bool flat = false) {
  ClothView v;
  v.camera = {azimuth, 10, 0.5f, 0.1f, -0.2f};
  v.flat = flat;
  return v;
}

TEST(Views, SaveCameraLightAndDrape) {
  Design d = plain();
  d.scene.mesh = "skirt";
  d.scene.light_azimuth = 33;
  d = keep_view_edit(seen_from(60), "  By the window ").apply(d);
  ASSERT_EQ(d.views.size(), 1u);
  EXPECT_EQ(d.views[0].name, "By the window");
  EXPECT_EQ(d.views[0].scene.mesh, "skirt");
  EXPECT_EQ(d.views[0].scene.light_azimuth, 33);
  EXPECT_EQ(d.views[0].scene.view_azimuth, 60);
  EXPECT_EQ(d.scene.view_azimuth, Scene{}.view_azimuth) << "where a window begins stays";
  d = keep_view_edit(seen_from(70, true), "By the window").apply(d);
  ASSERT_EQ(d.views.size(), 1u) << "one of a name";
  EXPECT_TRUE(d.views[0].flat);
  EXPECT_EQ(keep_view_edit(seen_from(1), "  ").apply(d), d) << "no name, no view";
}

TEST(Views, GoingToAViewMovesTheCameraAndEditsOnlyLightAndDrape) {
  Design d = plain();
  ClothView v = seen_from(20);
  d = keep_view_edit(v, "Here").apply(d);
  v.camera = {};
  EXPECT_FALSE(go_to_view(v, d, d.views[0])) << "the light is the same: nothing to undo";
  EXPECT_EQ(v.camera, seen_from(20).camera);
  d.scene.light_azimuth = 80;
  const MaybeEdit edit = go_to_view(v, d, d.views[0]);
  ASSERT_TRUE(edit);
  EXPECT_EQ(edit->label, "Go to view " + d.views[0].name);
  EXPECT_EQ(edit->apply(d).scene, d.views[0].scene.mesh.empty() ? Scene{} : plain().scene);
  NamedView flat = d.views[0];
  flat.flat = true;
  go_to_view(v, d, flat);
  EXPECT_TRUE(v.flat);
  EXPECT_EQ(v.draped, seen_from(20).camera) << "F leads back to it";
}

TEST(Views, GrazingLightIsForTheFlatSwatchOnly) {
  const Design d = plain();
  ClothView v = seen_from(20);
  v.grazing = true;
  EXPECT_EQ(seen_scene(v, d), with_orbit(d.scene, v.camera)) << "the drape keeps its light";
  v.flat = true;
  const Scene seen = seen_scene(v, d);
  EXPECT_EQ(seen.mesh, kFlatMesh);
  EXPECT_EQ(seen.light_elevation, 12);
  EXPECT_EQ(keep_view_edit(v, "Relief").apply(d).views[0].scene.light_elevation, 12) << "kept as it is seen";
  v.grazing = false;
  EXPECT_EQ(seen_scene(v, d).light_elevation, d.scene.light_elevation);
  v.grazing = true;
  go_to_view(v, d, {"Other", d.scene, true});
  EXPECT_FALSE(v.grazing) << "a view brings its own light";
}

TEST(Views, CanBeRenamedAndDeleted) {
  Design d = plain();
  for (const char* name : {"A", "B", "C"}) d = keep_view_edit(seen_from(1), name).apply(d);
  d = rename_views_edit({"C", "", "C"}).apply(d);
  ASSERT_EQ(d.views.size(), 2u);
  EXPECT_EQ(d.views[0].name, "C");
  EXPECT_EQ(d.views[1].name, "C 2");
  EXPECT_EQ(free_view_name(d), "View 3");
}

TEST(Views, ShippedViewsAreFoundByNameInAnyCase) {
  const Design d = plain();
  for (const ShippedView& s : kShippedViews) {
    EXPECT_TRUE(view_named(d, s.id, 800, 600)) << s.id;
    EXPECT_TRUE(view_named(d, s.label, 800, 600)) << s.label;
  }
  const auto near = view_named(d, "NEAR THREADS", 800, 600), head_on = view_named(d, "head on", 800, 600);
  ASSERT_TRUE(near && head_on);
  EXPECT_LT(near->scene.view_distance, 0.4f * head_on->scene.view_distance);
  EXPECT_EQ(drawn_scene(*near).mesh, kFlatMesh);
  EXPECT_EQ(drawn_scene(*view_named(d, "whole", 800, 600)).mesh, d.scene.mesh);
  EXPECT_FALSE(view_named(d, "nowhere", 800, 600));
  Design own = keep_view_edit(seen_from(77), "Whole").apply(d);
  EXPECT_EQ(view_named(own, "whole", 800, 600)->scene.view_azimuth, 77) << "the weaver's own come first";
}

TEST(Views, AreSavedInTheFileAndRemovedCompletely) {
  const std::string before = wif::write_new_wif(plain());
  const wif::WifRead read = wif::read_wif(before);
  ASSERT_TRUE(read.file);
  Design kept = keep_view_edit(seen_from(12.5f, true), "\xC3\x84rmel").apply(read.file->design);
  kept = keep_view_edit(seen_from(-3), "Two").apply(kept);
  const std::string with = wif::write_wif(*read.file, kept);
  EXPECT_NE(with.find("[PRIVATE WEFTLIGHT VIEW 2]"), std::string::npos);
  const wif::WifRead again = wif::read_wif(with);
  ASSERT_TRUE(again.file);
  EXPECT_EQ(again.file->design.views, kept.views);
  Design none = again.file->design;
  none.views.clear();
  EXPECT_EQ(wif::write_wif(*again.file, none).find("VIEW"), std::string::npos);
}

}  // namespace
}  // namespace weftlight::session
