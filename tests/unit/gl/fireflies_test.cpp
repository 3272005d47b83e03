// No pixel blazes among darker ones: neither noise of the reference nor a division of the preview.

#include <algorithm>

#include "base/resources.h"
#include "base/whole_files.h"
#include "picture.h"
#include "render_data/reference_scene.h"
#include "wif/wif.h"

namespace weftlight::gl {

using design::Design, design::Lobes, design::Method, design::method_name;
using files::Image;
using reference::TracedImage;
using render_data::ReferenceScene, render_data::ReferenceView, render_data::square, render_data::twill;

namespace {

/// A satin of combed yarns, whose highlights are the narrowest and brightest.
Design shining() {
  Design design = twill(8, 7, {0.85f, 0.8f, 0.7f}, {0.1f, 0.15f, 0.4f});
  Lobes& lobes = design.yarns[0].lobes;
  lobes.along_width = 0.08f, lobes.across_width = 0.4f, lobes.layers = 8;
  return design;
}

/// The largest quotient of a pixel and the brightness that nine tenths of the 7 x 7 around it do not reach; what is
/// darker than a twentieth of the mean counts as that.
double brightest_among_neighbours(const std::vector<float>& values, int width, int height) {
  double mean = 0;
  for (const float v : values) mean += static_cast<double>(v) / static_cast<double>(values.size());
  double most = 0;
  for (int y = 3; y + 3 < height; ++y)
    for (int x = 3; x + 3 < width; ++x) {
      std::vector<float> around;
      for (int j = -3; j <= 3; ++j)
        for (int i = -3; i <= 3; ++i) around.push_back(values[static_cast<size_t>((y + j) * width + x + i)]);
      const double own = static_cast<double>(around[24]);
      std::nth_element(around.begin(), around.begin() + 44, around.end());
      most = std::max(most, own / std::max(static_cast<double>(around[44]), 0.05 * mean));
    }
  return most;
}

class Fireflies : public PictureTest {};

TEST_F(Fireflies, TheReferenceHasNone) {
  Design design = shining();
  design.scene.mesh = "tablecloth";
  for (const char* lights : {"studio", "evening_sun"}) {
    design.scene.lights = lights;
    ReferenceScene reference;
    ASSERT_TRUE(reference.update(design));
    ReferenceView view;
    view.scene = design.scene;
    view.width = 96, view.height = 72, view.spp = 64, view.bounces = 2;  // as by default
    view.yarns_per_pixel = 0.5f;
    const TracedImage image = reference.trace(view, {});
    std::vector<float> values;
    for (const glm::vec4& p : image.pixels) values.push_back(p.r + p.g + p.b);
    const double most = brightest_among_neighbours(values, image.width, image.height);
    // With 16 samples one pixel was brighter than that in 6 to 10 of 90 traces, by a lamp that one sample met.
    EXPECT_LT(most, 4.5) << lights;
  }
}

TEST_F(Fireflies, ThePreviewHasNone) {
  upload(shining(), square(40));
  scene.light_elevation = 30;
  for (const float yarns : {0.1f, 0.5f, 3.0f})
    for (const Method method :
         {Method::kFlat, Method::kCloth, Method::kRepeat, Method::kCell, Method::kYarn, Method::kAuto}) {
      look.method = method;
      frame.yarns_per_pixel = yarns;
      const Image image = draw();
      std::vector<float> values;
      for (size_t i = 0; i < image.texels.size(); i += static_cast<size_t>(image.channels))
        values.push_back(image.texels[i] + image.texels[i + 1] + image.texels[i + 2]);
      const double most = brightest_among_neighbours(values, image.width, image.height);
      EXPECT_LT(most, 2.5) << method_name(method) << ' ' << yarns;
    }
}

Design shipped_cloth(const std::string& name) {
  const wif::WifRead read =
      wif::read_wif(base::read_file(base::presets_dir() + "/cloths/" + name + ".wif").value_or(""));
  EXPECT_TRUE(read.file) << name;
  return read.file ? read.file->design : Design{};
}

// Rays slipped between the round warp threads of heavy denim, which let the backdrop through in white dots.
TEST_F(Fireflies, ClothWhoseThreadsTouchHidesTheBackdropAtASlant) {
  frame.transparent = true;
  scene.view_azimuth = 50;
  for (const char* name : {"denim", "cotton_denim", "tweed"}) {
    upload(shipped_cloth(name), square(80));
    for (const float yarns : {0.1f, 0.8f}) {
      frame.yarns_per_pixel = yarns;
      const Image image = draw();
      float least = 1;
      for (size_t y = kSide / 4; y < kSide * 3 / 4; ++y)
        for (size_t x = kSide / 4; x < kSide * 3 / 4; ++x)
          least = std::min(least, image.texels[(y * kSide + x) * 4 + 3]);
      EXPECT_GT(least, 0.999f) << name << ' ' << yarns;
    }
  }
}

// Single samples in the shadow between threads were black dots on flannel, whose nap covers them.
TEST_F(Fireflies, ANapHasNoPepper) {
  upload(shipped_cloth("flannel"), square(80));
  frame.yarns_per_pixel = 0.6f;
  frame.width = frame.height = 4 * kSide;
  scene.view_azimuth = 30;
  scene.light_azimuth = -50, scene.light_elevation = 20;
  const Image image = draw();
  const double mean = middle(image).sum();
  int dark = 0;
  for (size_t y = kSide; y < size_t{3} * kSide; ++y)
    for (size_t x = kSide; x < size_t{3} * kSide; ++x) {
      const float* p = image.texels.data() + (y * 4 * kSide + x) * 4;
      dark += static_cast<double>(p[0] + p[1] + p[2]) < 0.75 * mean;
    }
  EXPECT_LT(dark, 0.001 * 4 * kSide * kSide);
}

}  // namespace
}  // namespace weftlight::gl
