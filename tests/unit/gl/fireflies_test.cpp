// No pixel blazes among darker ones: neither noise of the reference nor a division of the preview.

#include <algorithm>

#include "picture.h"
#include "render_data/reference_scene.h"

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
    view.width = 96, view.height = 72, view.spp = 16, view.bounces = 2;
    view.yarns_per_pixel = 0.5f;
    const TracedImage image = reference.trace(view, {});
    std::vector<float> values;
    for (const glm::vec4& p : image.pixels) values.push_back(p.r + p.g + p.b);
    const double most = brightest_among_neighbours(values, image.width, image.height);
    EXPECT_LT(most, 4.5) << lights;  // 16 samples a pixel; highlights of single fibres are as bright
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

}  // namespace
}  // namespace weftlight::gl
