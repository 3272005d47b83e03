// An environment map, split into lights and the rest, conserves energy.

#include "scene/environment_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../statistics.h"
#include "scene/light_rig.h"

namespace weftlight::scene {

using design::Scene;
using files::Image;

namespace {

constexpr float kPi = 3.14159265f;

Image grey(int width, float value) {
  return {width, width / 2, 3, std::vector<float>(static_cast<size_t>(3 * width * width / 2), value)};
}

void put(Image& image, int x, int y, glm::vec3 c) {
  float* t = &image.texels[static_cast<size_t>(3 * (y * image.width + x))];
  t[0] = c.r, t[1] = c.g, t[2] = c.b;
}

float covers(const Image& image, int y) {
  const float step = kPi / static_cast<float>(image.height), top = static_cast<float>(y) * step;
  return (std::cos(top) - std::cos(top + step)) * 2 * kPi / static_cast<float>(image.width);
}

glm::vec3 middle_of(const Image& image, int x, int y) {
  return environment_direction((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                               (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height));
}

/// Of all directions.
glm::vec3 whole(const Environment& e) {
  glm::vec3 sum = e.rest()[0] * std::sqrt(4 * kPi);
  for (const DistantLight& light : e.lights()) sum += light.irradiance;
  return sum;
}

TEST(Environments, AWhiteOneIsAWhiteSkyWithoutLights) {
  const Environment white(grey(256, 1));
  EXPECT_TRUE(white.lights().empty());
  for (const glm::vec3 d : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::normalize(glm::vec3(1, -2, 3))})
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(sky_radiance(white.rest(), d)[k], 1, 2e-3);
}

TEST(Environments, OneBrightTexelIsOneLight) {
  for (const int y : {3, 40, 70, 120}) {
    Image image = grey(256, 0);
    put(image, 60, y, {9000, 5000, 1000});
    const Environment sun(std::move(image));
    ASSERT_EQ(sun.lights().size(), 1u);
    const DistantLight& light = sun.lights()[0];
    EXPECT_GT(glm::dot(light.towards, middle_of(sun.picture(), 60, y)), 0.9999f);
    const float part = covers(sun.picture(), y);
    EXPECT_NEAR(light.irradiance.r / (9000 * part), 1, 1e-3);
    EXPECT_NEAR(light.irradiance.b / (1000 * part), 1, 1e-3);
    EXPECT_LT(light.radius, 0.02f);
    EXPECT_LT(glm::length(sun.rest()[0]), 0.02f * glm::length(light.irradiance));
  }
}

TEST(Environments, KeepAllTheirLight) {
  std::minstd_rand random(3);
  Image image = grey(256, 0.2f);
  for (int i = 0; i < 40; ++i)
    put(image, static_cast<int>(random() % 256), static_cast<int>(random() % 128),
        glm::vec3(random() % 500, random() % 500, random() % 500));
  glm::vec3 all(0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const float* t = &image.texels[static_cast<size_t>(3 * (y * image.width + x))];
      all += glm::vec3(t[0], t[1], t[2]) * covers(image, y);
    }
  const Environment e(std::move(image));
  EXPECT_GT(e.lights().size(), 1u);
  EXPECT_LE(e.lights().size(), kMaxLights);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(whole(e)[k] / all[k], 1, 1e-3);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(e.mean()[k] * 4 * kPi / all[k], 1, 1e-3);
  // Importance-sampled texels give all of the light.
  glm::vec3 sampled(0);
  constexpr int kSide = 256;
  for (int i = 0; i < kSide * kSide; ++i)
    sampled += e.sample((static_cast<float>(i % kSide) + 0.5f) / kSide, (static_cast<float>(i / kSide) + 0.5f) / kSide)
                   .irradiance /
               static_cast<float>(kSide * kSide);
  for (int y = 0; y < e.picture().height; ++y)
    for (int x = 0; x < e.picture().width; ++x)
      sampled += e.capped_radiance(middle_of(e.picture(), x, y)) * covers(e.picture(), y);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(sampled[k] / all[k], 1, 0.02);
}

/// A sky of several tones with a sun, a window and single bright texels.
Image uneven() {
  std::minstd_rand random(9);
  Image image = grey(64, 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      put(image, x, y, glm::vec3(1, 1.2f, 1.5f) * (0.2f + 0.02f * static_cast<float>(y % 9)));
  for (int i = 0; i < 60; ++i)
    put(image, static_cast<int>(random() % 64), static_cast<int>(random() % 32),
        glm::vec3(random() % 9, random() % 9, 2));
  for (int y = 8; y < 13; ++y)
    for (int x = 20; x < 26; ++x) put(image, x, y, {8, 7, 5});
  put(image, 40, 5, {300, 250, 200});
  return image;
}

TEST(Environments, SamplesAreDistributedAsTheLightAboveTheMean) {
  const Environment e(uneven());
  const Image& map = e.picture();
  std::vector<double> expected, counted(map.texels.size() / 3);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const float* t = &map.texels[static_cast<size_t>(3 * (y * map.width + x))];
      const glm::dvec3 above = glm::max(glm::dvec3(t[0], t[1], t[2]) - glm::dvec3(e.mean()), glm::dvec3(0));
      expected.push_back(glm::dot(above, glm::dvec3(0.2126, 0.7152, 0.0722)) * static_cast<double>(covers(map, y)));
    }
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < 400'000; ++i) {
    const float u = unit(random);
    const glm::vec3 d = e.sample(u, unit(random)).towards;
    const float across = std::atan2(d.x, -d.z) / (2 * kPi) + 0.5f, down = std::acos(d.y) / kPi;
    const int x = static_cast<int>(across * static_cast<float>(map.width)),
              y = static_cast<int>(down * static_cast<float>(map.height));
    ++counted[static_cast<size_t>(y * map.width + x)];
  }
  EXPECT_GT(chi_square(counted, expected), kFalseAlarm);
  *std::max_element(counted.begin(), counted.end()) *= 0.95;
  EXPECT_LT(chi_square(counted, expected), 1e-6) << "the test sees a texel that is chosen too seldom by five percent";
}

TEST(Environments, AWindowIsAFewLightsAndASkyIsNone) {
  Image room = grey(256, 0.05f), sky = grey(256, 0.1f);
  for (int y = 40; y < 75; ++y)
    for (int x = 100; x < 130; ++x) put(room, x, y, glm::vec3(12));
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 256; ++x) put(sky, x, y, glm::vec3(0.6f, 0.8f, 1));
  const Environment window(std::move(room)), overcast(std::move(sky));
  EXPECT_GE(window.lights().size(), 2u);
  EXPECT_TRUE(overcast.lights().empty());
  for (const DistantLight& light : window.lights())
    EXPECT_GT(glm::dot(light.towards, middle_of(window.picture(), 115, 57)), 0.85f);
}

TEST(Environments, TurnAsTheirLightsDo) {
  Harmonics sky{};
  for (size_t k = 0; k < 9; ++k) sky[k] = glm::vec3(0.3f * static_cast<float>(k % 4), 0.1f, k == 8 ? 0.4f : -0.2f);
  sky[0] = glm::vec3(9);
  for (const float degrees : {30.0f, -100.0f, 180.0f})
    for (const glm::vec3 d : {glm::vec3(1, 0, 0), glm::normalize(glm::vec3(-1, 2, 0.5f)), glm::vec3(0, 0.6f, -0.8f)})
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(sky_radiance(turned(sky, degrees), turned(d, degrees))[k], sky_radiance(sky, d)[k], 1e-4);
}

TEST(Environments, ASceneTurnsThemByTheAzimuthOfItsLight) {
  Image image = grey(256, 0.01f);
  put(image, 128, 50, glm::vec3(8000));
  LightRig rig;
  rig.environment = std::make_shared<const Environment>(std::move(image));
  Scene scene;
  scene.light_azimuth = 180, scene.light_strength = 2;  // light from behind the cloth now comes from the front
  const SceneLight light = scene_light(rig, scene);
  ASSERT_EQ(light.lights.size(), 1u);
  EXPECT_GT(light.lights[0].towards.z, 0.9f);
  EXPECT_NEAR(light.lights[0].irradiance.g, 2 * rig.environment->lights()[0].irradiance.g, 1e-3);
}

}  // namespace
}  // namespace weftlight::scene
