// What the camera sees: the whole cloth from every side, up to its edges, and as near as was asked for.

#include "scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/resources.h"
#include "files/files.h"

namespace weftlight::scene {
namespace {

/// An upright sheet of 200 by 100 mm with its middle at (10, 20, 0).
Mesh sheet() {
  Mesh mesh;
  mesh.position_mm = {{-90, -30, 0}, {110, -30, 0}, {110, 70, 0}, {-90, 70, 0}};
  mesh.index = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// A round body, as draped cloth is.
Mesh round_body() {
  Mesh mesh;
  for (int azimuth = 0; azimuth < 360; azimuth += 20)
    for (int elevation = -80; elevation <= 80; elevation += 20)
      mesh.position_mm.push_back(80.0f * direction_of(static_cast<float>(azimuth), static_cast<float>(elevation)));
  return mesh;
}

glm::vec2 in_picture(const Camera& camera, glm::vec3 place) {
  const glm::vec4 clip = camera.world_to_clip * glm::vec4(place, 1);
  EXPECT_GT(clip.w, 0) << "behind the camera";
  return glm::vec2(clip) / clip.w;
}

TEST(Camera, BoundsHoldEveryVertex) {
  const Bounds b = bounds_of(sheet());
  EXPECT_EQ(b.low, glm::vec3(-90, -30, 0));
  EXPECT_EQ(b.high, glm::vec3(110, 70, 0));
  EXPECT_EQ(b.centre(), glm::vec3(10, 20, 0));
  EXPECT_NEAR(b.radius(), 0.5f * std::hypot(200.0f, 100.0f), 1e-3f);
  EXPECT_EQ(bounds_of({}).radius(), 0);
}

TEST(Camera, DirectionsTurnToTheRightAndUp) {
  EXPECT_LT(glm::length(direction_of(0, 0) - glm::vec3(0, 0, 1)), 1e-6f);
  EXPECT_LT(glm::length(direction_of(90, 0) - glm::vec3(1, 0, 0)), 1e-6f);
  EXPECT_LT(glm::length(direction_of(37, 90) - glm::vec3(0, 1, 0)), 1e-6f);
}

TEST(Camera, SeesTheWholeClothFromEverySide) {
  const Mesh mesh = round_body();
  const Bounds bounds = bounds_of(mesh);
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  for (const float azimuth : {-80.0f, 0.0f, 45.0f, 180.0f})
    for (const float elevation : {-95.0f, 0.0f, 30.0f, 90.0f}) {  // also where up and the view are one
      scene.view_azimuth = azimuth, scene.view_elevation = elevation;
      const Camera camera = place_camera(scene, mesh, bounds, 400, 300, 0, 0);
      float furthest = 0;
      for (const auto& place : mesh.position_mm) {
        const glm::vec2 at = in_picture(camera, place);
        furthest = std::max({furthest, std::abs(at.x), std::abs(at.y)});
      }
      EXPECT_LT(furthest, 1) << azimuth << ", " << elevation;
      EXPECT_GT(furthest, 0.6f) << azimuth << ", " << elevation << ": much of the picture is empty";
      EXPECT_LT(glm::length(in_picture(camera, bounds.centre())), 1e-3f);
    }
}

/// A form without its triangles, which a camera would look for the surface in the middle of the picture.
base::Result<Mesh> vertices_of(const std::string& form) {
  return files::load_drape(base::presets_dir() + "/meshes/" + form + ".glb").map([](Mesh mesh) {
    mesh.index.clear();
    return mesh;
  });
}

/// Half widths of a picture: how far a form reaches to a side, from all around and a little above.
float furthest_aside(const Mesh& mesh, const Bounds& bounds, int width, int height) {
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  float furthest = 0;
  for (const float azimuth : {0.0f, 25.0f, 60.0f, 180.0f, 315.0f})
    for (const float elevation : {0.0f, 22.0f}) {
      scene.view_azimuth = azimuth, scene.view_elevation = elevation;
      const Camera camera = place_camera(scene, mesh, bounds, width, height, 0, 0);
      for (const auto& place : mesh.position_mm) furthest = std::max(furthest, std::abs(in_picture(camera, place).x));
    }
  return furthest;
}

// The hands of a shirt touched the edges of a pane that is taller than wide.
TEST(Camera, FormsKeepAMarginInPicturesOfAnyShape) {
  for (const char* name : {"sphere", "tablecloth", "curtain", "skirt", "tunic", "shirt", "scarf", "cushion"})
    for (const char* fabric : {"", "_limp", "_stiff"}) {
      const base::Result<Mesh> form = vertices_of(std::string(name) + fabric);
      ASSERT_TRUE(form) << name << fabric;
      const Bounds bounds = bounds_of(*form);
      for (const int width : {400, 1000, 2500})
        EXPECT_LE(furthest_aside(*form, bounds, width, 1000), 0.92f)
            << name << fabric << ", " << width << " x 1000: a margin of 4 %";
    }
}

/// How far a mesh reaches towards the edges of a picture, which are at 1, from all around and from above and below.
float furthest_out(const Mesh& mesh, int width, int height) {
  const Bounds bounds = bounds_of(mesh);
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  float furthest = 0;
  for (int azimuth = 40; azimuth < 400; azimuth += 60)
    for (const float elevation : {-30.0f, 0.0f, 22.0f, 60.0f}) {
      scene.view_azimuth = static_cast<float>(azimuth), scene.view_elevation = elevation;
      const Camera camera = place_camera(scene, mesh, bounds, width, height, 0, 0);
      for (const auto& place : mesh.position_mm) {
        const glm::vec2 at = in_picture(camera, place);
        furthest = std::max({furthest, std::abs(at.x), std::abs(at.y)});
      }
    }
  return furthest;
}

// The corners of a turned cushion were cut off by 9 % of the picture, those of the plane at its sides.
TEST(Camera, NothingIsCutOffWhicheverWayItIsTurned) {
  std::vector<std::string> meshes{"plane"};
  for (const char* name : {"sphere", "tablecloth", "curtain", "skirt", "tunic", "shirt", "scarf", "cushion"})
    for (const char* fabric : {"", "_limp", "_stiff"}) meshes.push_back(std::string(name) + fabric);
  for (const std::string& name : meshes) {
    const base::Result<Mesh> mesh = vertices_of(name);
    ASSERT_TRUE(mesh) << name;
    for (const int width : {400, 1000, 1600, 2500})
      EXPECT_LE(furthest_out(*mesh, width, 1000), 0.966f) << name << ", " << width << " x 1000";
  }
}

TEST(Camera, AFormKeepsItsSizeWhileItIsTurned) {
  const base::Result<Mesh> cushion = vertices_of("cushion_stiff");
  ASSERT_TRUE(cushion);
  const Bounds bounds = bounds_of(*cushion);
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  const auto pixel_mm = [&](int azimuth) {
    scene.view_azimuth = static_cast<float>(azimuth);
    return place_camera(scene, *cushion, bounds, 1280, 800, 0, 0).pixel_mm;
  };
  for (int azimuth = 15; azimuth < 360; azimuth += 15) EXPECT_NEAR(pixel_mm(azimuth), pixel_mm(0), 1e-5f) << azimuth;
}

// Their first views are composed by hand, and nothing of these reaches as far as a corner of a cushion.
TEST(Camera, FormsThatStandUprightFillThePictureAsTheirCylinderDoes) {
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  for (const char* name : {"tablecloth", "curtain", "skirt", "tunic", "shirt", "scarf"})
    for (const char* fabric : {"", "_limp", "_stiff"}) {
      const base::Result<Mesh> form = vertices_of(std::string(name) + fabric);
      ASSERT_TRUE(form) << name << fabric;
      const Bounds bounds = bounds_of(*form);
      for (const float elevation : {8.0f, 12.0f, 22.0f, 26.0f}) {
        scene.view_elevation = elevation;
        EXPECT_EQ(place_camera(scene, *form, bounds, 1280, 800, 0, 0).pixel_mm,
                  place_camera(scene, {}, bounds, 1280, 800, 0, 0).pixel_mm)
            << name << fabric << " from " << elevation;
      }
    }
}

TEST(Camera, TheHeightAloneFramesAFormInAWidePicture) {
  Scene scene;
  scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  for (const char* name : {"curtain", "skirt", "tunic", "shirt", "scarf", "cushion"}) {
    const base::Result<Mesh> form = files::load_drape(name);
    ASSERT_TRUE(form) << name;
    Bounds bounds = bounds_of(*form);
    const auto pixel_mm = [&] { return place_camera(scene, {}, bounds, 1280, 800, 0, 0).pixel_mm; };
    const float framed = pixel_mm();
    bounds.reach = 0;
    EXPECT_EQ(pixel_mm(), framed) << name;
  }
}

TEST(Camera, APixelHasTheSizeThatItSays) {
  const Mesh mesh = sheet();
  const Bounds bounds = bounds_of(mesh);
  Scene scene;
  scene.view_azimuth = scene.view_elevation = scene.pan_x = scene.pan_y = 0, scene.view_distance = 1;
  const auto pixel_mm = [&](const Camera& camera) {
    const float across = in_picture(camera, bounds.centre() + glm::vec3(1, 0, 0)).x * 400 / 2;
    return 1 / across;
  };
  const Camera whole = place_camera(scene, mesh, bounds, 400, 300, 0, 0);
  EXPECT_NEAR(pixel_mm(whole), whole.pixel_mm, 0.01f * whole.pixel_mm);
  // Half the distance shows half as much; the eye stays outside the folds.
  scene.view_distance = 0.5f;
  const Camera near = place_camera(scene, mesh, bounds, 400, 300, 0, 0);
  EXPECT_NEAR(near.pixel_mm, whole.pixel_mm / 2, 0.02f * whole.pixel_mm);
  EXPECT_LT(glm::length(near.eye - whole.eye), 1e-3f);
  // Further away it is smaller.
  scene.view_distance = 2;
  EXPECT_GT(place_camera(scene, mesh, bounds, 400, 300, 0, 0).pixel_mm, 1.9f * whole.pixel_mm);
  // A footprint of three threads of 0.5 mm.
  EXPECT_NEAR(place_camera(scene, mesh, bounds, 400, 300, 3, 0.5f).pixel_mm, 1.5f, 1e-3f);
}

TEST(Camera, PanMovesThePictureByPartsOfItsWidth) {
  const Mesh mesh = sheet();
  const Bounds bounds = bounds_of(mesh);
  Scene scene;
  scene.view_azimuth = scene.view_elevation = 0, scene.view_distance = 1;
  scene.pan_x = 0.25f, scene.pan_y = 0;
  const glm::vec2 at = in_picture(place_camera(scene, mesh, bounds, 400, 300, 0, 0), bounds.centre());
  EXPECT_NEAR(at.x, 0.5f, 0.01f) << "a quarter of the picture, whose halves are 1 wide";
  EXPECT_NEAR(at.y, 0, 0.01f);
}

TEST(Camera, FindsTheDistanceThatShowsSoMuch) {
  const Mesh mesh = sheet();
  const Bounds bounds = bounds_of(mesh);
  Scene scene;
  scene.view_azimuth = scene.view_elevation = scene.pan_x = scene.pan_y = 0;
  scene.view_distance = distance_of_height(bounds, 4.0f / 3, 40);
  const Camera camera = place_camera(scene, mesh, bounds, 400, 300, 0, 0);
  EXPECT_NEAR(camera.pixel_mm * 300, 40, 1);
  EXPECT_EQ(distance_of_height(bounds, 4.0f / 3, 1e6f), 1) << "no further than the whole";
}

}  // namespace
}  // namespace weftlight::scene
