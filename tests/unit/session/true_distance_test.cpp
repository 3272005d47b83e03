#include "session/editing/true_distance.h"

#include <gtest/gtest.h>

#include "scene/camera.h"

namespace weftlight::session {
namespace {

constexpr int kWidth = 640, kHeight = 700;

/// Pixels on the screen of a length on the swatch, as the camera draws it.
float drawn_px(const Settings& settings, const Screen& screen, float mm) {
  design::Scene scene;
  scene.view_azimuth = scene.view_elevation = 0;
  scene.view_distance = true_view_distance(settings, screen, kWidth, kHeight);
  const scene::Bounds swatch{{-150, 0, 0}, {150, 200, 0}};
  const scene::Camera camera = scene::place_camera(scene, {}, swatch, kWidth, kHeight, 0, 0);
  const glm::vec4 left = camera.world_to_clip * glm::vec4(0, 100, 0, 1),
                  right = camera.world_to_clip * glm::vec4(mm, 100, 0, 1);
  return (right.x / right.w - left.x / left.w) * kWidth / 2;
}

TEST(TrueDistance, TheClothIsAsLargeAsACardOnTheMeasuredScreen) {
  Settings s;
  const Screen screen{"laptop 1920x1080", 3.9f};
  s.screens[screen.name] = 5.5f;
  s.eye_to_screen_cm = 50;
  s.seen_from_m = 0.5f;
  EXPECT_NEAR(drawn_px(s, screen, kCardWidth_mm), 5.5f * kCardWidth_mm, 0.1f);
}

TEST(TrueDistance, AClothTwiceAsFarIsHalfAsLarge) {
  Settings s;
  const Screen screen{"laptop 1920x1080", 4};
  for (const float metres : {kNearestSeen_m, 1.0f, 2.0f, kFurthestSeen_m}) {
    s.seen_from_m = metres;
    // The same angle: size / distance.
    EXPECT_NEAR(drawn_px(s, screen, 100) / 4 / (s.eye_to_screen_cm * 10), 100 / (1000 * metres), 1e-4f);
  }
}

TEST(TrueDistance, AScreenThatClaimsNonsenseIsTakenForAUsualOne) {
  EXPECT_NEAR(px_a_mm({}, {"projector", 0}), 3.78f, 0.01f);
  EXPECT_NEAR(px_a_mm({}, {"television", 9000}), 3.78f, 0.01f);
  EXPECT_EQ(px_a_mm({}, {"laptop", 5}), 5);
}

TEST(TrueDistance, StaysInItsRange) {
  EXPECT_EQ(stepped_distance_m(0.35f, 10), kNearestSeen_m);
  EXPECT_EQ(stepped_distance_m(4.9f, -10), kFurthestSeen_m);
  EXPECT_EQ(distance_text(2, false), "2.00 m");
  EXPECT_EQ(distance_text(2, true), "6 ft 7 in");
}

TEST(TrueDistance, TheMeasuredScreensAreKept) {
  Settings s;
  s.screens["laptop 1920x1080"] = 5.5f;
  s.screens["wall 3840x2160"] = 2;
  s.seen_from_m = 2.5f;
  s.eye_to_screen_cm = 60;
  s.rulers = true;
  s.interface_percent = 150;
  const Settings read = settings_from(settings_text(s));
  EXPECT_EQ(read.screens, s.screens);
  EXPECT_EQ(read.seen_from_m, 2.5f);
  EXPECT_EQ(read.eye_to_screen_cm, 60);
  EXPECT_TRUE(read.rulers);
  EXPECT_EQ(read.interface_percent, 150);
}

TEST(TrueDistance, NonsenseInTheSettingsIsLeftOut) {
  const Settings read =
      settings_from(R"({"screens":{"a":0,"b":-3,"c":1e9,"d":"x","e":4},"seen_from_m":900,"eye_to_screen_cm":-1,)"
                    R"("interface_percent":100000})");
  EXPECT_EQ(read.screens.size(), 1U);
  EXPECT_EQ(read.seen_from_m, Settings{}.seen_from_m);
  EXPECT_EQ(read.eye_to_screen_cm, Settings{}.eye_to_screen_cm);
  EXPECT_EQ(read.interface_percent, 200);
  EXPECT_EQ(settings_from(R"({"interface_percent":-5})").interface_percent, 80);
}

}  // namespace
}  // namespace weftlight::session
