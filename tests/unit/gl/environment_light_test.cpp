// Environment maps: a white one gives the furnace result, a bright texel that of a distant light, several their sum.

#include "scene/environment_light.h"

#include "picture.h"
#include "scene/light_rig.h"

namespace weftlight::gl {

using design::Method, design::method_name;
using files::Image;
using render_data::square, render_data::twill;
using scene::DistantLight, scene::Environment, scene::LightRig, scene::kKeyIrradiance, scene::load_light_rig;

namespace {

class EnvironmentLight : public PictureTest {
 protected:
  void SetUp() override {
    PictureTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    frame.width = frame.height = 32;
    upload(twill(4, 2, {1, 1, 1}, {1, 1, 1}), square(40));
  }
  void TearDown() override {
    if (renderer) renderer->set_lights(load_light_rig("studio").value());
  }
  static Image grey(float value) { return {256, 128, 3, std::vector<float>(size_t{3} * 256 * 128, value)}; }
  static void put(Image& image, int x, int y, float value) {
    for (int k = 0; k < 3; ++k) image.texels[static_cast<size_t>(3 * (y * image.width + x) + k)] = value;
  }
  Image under(Image picture) {
    LightRig rig;
    rig.environment = std::make_shared<const Environment>(std::move(picture));
    lights = rig.environment->lights();
    renderer->set_lights(rig);
    scene.light_azimuth = 0;
    return draw();
  }
  std::vector<DistantLight> lights;
};

TEST_F(EnvironmentLight, OfAWhitePictureIsTheFurnaces) {
  LightRig furnace;  // radiance 1 from everywhere
  furnace.key = glm::vec3(0);
  furnace.sky[0] = glm::vec3(std::sqrt(4 * 3.14159265f));
  for (const Method method : {Method::kFlat, Method::kYarn}) {
    look.method = method;
    renderer->set_lights(furnace);
    const Mean asked = middle(draw());
    // What folds and pattern leave of white threads.
    EXPECT_GT(asked.g, 0.6);
    EXPECT_LT(asked.g, 1.01);
    EXPECT_NEAR(middle(under(grey(1))).sum() / asked.sum(), 1, 0.002) << method_name(method);
    EXPECT_TRUE(lights.empty());
  }
  look.method = Method::kFlat;
  EXPECT_NEAR(middle(under(grey(3))).sum() / middle(under(grey(1))).sum(), 3, 0.01);
}

TEST_F(EnvironmentLight, OfOneBrightTexelIsThatOfALightFarOff) {
  for (const Method method : {Method::kYarn, Method::kCloth}) {
    look.method = method;
    Image picture = grey(0.001f);
    put(picture, 40, 40, 6000);  // before the cloth, at the left
    const Mean ours = middle(under(std::move(picture)));
    ASSERT_EQ(lights.size(), 1u);
    LightRig equivalent;
    equivalent.key = lights[0].irradiance / kKeyIrradiance;
    equivalent.key_radius = lights[0].radius;
    renderer->set_lights(equivalent);
    const glm::vec3 d = lights[0].towards;
    scene.light_azimuth = glm::degrees(std::atan2(d.x, d.z)), scene.light_elevation = glm::degrees(std::asin(d.y));
    const Mean theirs = middle(draw());
    EXPECT_GT(theirs.sum(), 0.1);
    EXPECT_NEAR(ours.sum() / theirs.sum(), 1, 0.02) << method_name(method);
  }
}

TEST_F(EnvironmentLight, OfSeveralIsTheirSum) {
  const int pixels[][2] = {{20, 45}, {64, 30}, {235, 60}};
  for (const Method method : {Method::kYarn, Method::kRepeat}) {
    look.method = method;
    Image all = grey(0);
    Mean sum;
    for (const auto& [x, y] : pixels) {
      Image one = grey(0);
      put(one, x, y, 5000), put(all, x, y, 5000);
      const Mean alone = middle(under(std::move(one)));
      sum.r += alone.r, sum.g += alone.g, sum.b += alone.b;
    }
    const Mean together = middle(under(std::move(all)));
    EXPECT_EQ(lights.size(), 3u);
    EXPECT_NEAR(together.sum() / sum.sum(), 1, 0.02) << method_name(method);
  }
}

TEST_F(EnvironmentLight, ShowsBehindTheClothWhereItIsAsked) {
  Image picture = grey(0.2f);
  for (int y = 0; y < 128; ++y)
    for (int x = 128; x < 256; ++x) picture.texels[static_cast<size_t>(3 * (y * 256 + x))] = 0.8f;
  frame.cloth = false, frame.width = frame.height = 64;
  scene.surroundings = true;
  const Image shown = under(std::move(picture));
  const auto red = [&](int x) { return shown.texels[static_cast<size_t>(4 * (32 * 64 + x))]; };
  EXPECT_NEAR(red(4), 0.2f, 0.02);
  EXPECT_NEAR(red(60), 0.8f, 0.02);
}

}  // namespace
}  // namespace weftlight::gl
