// The light of an environment map, sampled by its bright texels and a capped sky as the reference picture has it, is
// that of the whole map met by chance. Fails with probability kFalseAlarm for an unbiased tracer with new seeds.

#include <gtest/gtest.h>

#include <cmath>

#include "../statistics.h"
#include "base/loops.h"
#include "designs.h"
#include "draft/drawdown.h"
#include "reference/picture.h"
#include "scene/environment_light.h"

namespace weftlight::render_data {

using base::for_each_job;
using cloth::Period, cloth::lay_out;
using design::Design;
using draft::Face, draft::drawdown;
using files::Image;
using reference::ClothTracer, reference::RandomStream, reference::Surroundings, reference::TubeScene;
using scene::DistantLight, scene::Environment;

namespace {

constexpr int kPixels = 32, kSamples = 12000;

/// A grey room with a window and a lamp of many texels, all in front of the cloth (+y is up there).
Image room() {
  Image image{128, 64, 3, std::vector<float>(size_t{3} * 128 * 64, 0.3f)};
  const auto fill = [&](int x0, int x1, int y0, int y1, glm::vec3 c) {
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        for (int k = 0; k < 3; ++k) image.texels[static_cast<size_t>(3 * (y * 128 + x) + k)] = c[k];
  };
  fill(50, 76, 12, 24, {3, 4, 6});
  fill(90, 98, 8, 14, {30, 20, 10});
  return image;
}

struct Moments {
  double sum = 0, squares = 0;
};

/// Sums of the green of each pixel; `light` and `sky` as the picture has them. The cloth faces up the map's y.
std::vector<Moments> traced(const TubeScene& tubes, uint64_t seed,
                            const std::function<void(Surroundings&, RandomStream&)>& surround) {
  const ClothTracer tracer(tubes);
  std::vector<Moments> out(kPixels);
  for_each_job(kPixels, [&](int pixel) {
    RandomStream random((seed << 32) + static_cast<uint64_t>(pixel));
    for (int i = 0; i < kSamples; ++i) {
      Surroundings around;
      surround(around, random);
      const float x = (static_cast<float>(pixel) + random.next()) / kPixels, y = random.next();
      const double c = static_cast<double>(
          tracer.trace({x * tubes.cloth().width_mm, y * tubes.cloth().depth_mm, 5}, {0, 0, -1}, 0, around, random, 0)
              .radiance.g);
      out[static_cast<size_t>(pixel)].sum += c, out[static_cast<size_t>(pixel)].squares += c * c;
    }
  });
  return out;
}

TEST(EnvironmentBias, BrightTexelsAndACappedSkyAreTheWholeMap) {
  Design design = twill(4, 2, {0.8f, 0.7f, 0.6f}, {0.4f, 0.5f, 0.6f});
  design.yarns[0].lobes.transmission = 0;  // a sky met by chance does not pass through threads
  const auto built = TubeScene::build(lay_out(design, drawdown(design.draft), Face::kFront, Period::kRepeat), {});
  ASSERT_TRUE(built) << built.error().text;
  const TubeScene& tubes = **built;
  const Environment map(room());
  const auto up = [](glm::vec3 local) { return glm::vec3(local.x, local.z, -local.y); };  // cloth to map
  const auto down = [](glm::vec3 towards) { return glm::vec3(towards.x, -towards.z, towards.y); };
  const auto sampled = traced(tubes, 1, [&](Surroundings& around, RandomStream& random) {
    const float u = random.next();
    const DistantLight light = map.sample(u, random.next());
    around.light_towards = down(light.towards), around.light_irradiance = light.irradiance;
    around.light_radius_rad = light.radius;
    around.sky = [&](glm::vec3 d) { return map.capped_radiance(up(d)); };
  });
  const auto met = traced(tubes, 2, [&](Surroundings& around, RandomStream&) {
    around.light_irradiance = glm::vec3(0);
    around.sky = [&](glm::vec3 local) {
      const glm::vec3 d = up(local);
      const Image& image = map.picture();
      const int x = static_cast<int>((std::atan2(d.x, -d.z) / 6.2831853f + 0.5f) * 127.999f);
      const int y = static_cast<int>(std::acos(std::clamp(d.y, -1.0f, 1.0f)) / 3.1415927f * 63.999f);
      const float* t = &image.texels[static_cast<size_t>(3 * (y * 128 + x))];
      return glm::vec3(t[0], t[1], t[2]);
    };
  });
  Verdict verdict;
  double off = 0, variance = 0, whole = 0;
  const auto variance_of = [](const Moments& m) {
    return (m.squares / kSamples - m.sum / kSamples * m.sum / kSamples) / (kSamples - 1);
  };
  for (size_t i = 0; i < sampled.size(); ++i) {
    const double difference = (sampled[i].sum - met[i].sum) / kSamples,
                 v = variance_of(sampled[i]) + variance_of(met[i]);
    verdict.add(z_tail(difference / std::sqrt(v)));
    off += difference, variance += v, whole += met[i].sum / kSamples;
  }
  verdict.add(z_tail(off / std::sqrt(variance)));
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed() << "; the whole is off by "
                               << off / whole << ", " << off / std::sqrt(variance) << " standard deviations";
  EXPECT_LT(std::sqrt(variance), 0.006 * whole) << "a bias of three percent would be seen";
}

}  // namespace
}  // namespace weftlight::render_data
