// Bias of the tracer: the same light, sampled in two ways, gives the same picture, pixel by pixel. Each test fails with
// probability kFalseAlarm for an unbiased tracer with new seeds.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../statistics.h"
#include "base/loops.h"
#include "reference/picture.h"

namespace weftlight::reference {

using base::for_each_job;
using cloth::Cloth;
using design::Yarn;
using draft::BitMatrix;

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSide = 8;  // pixels

/// Plain weave of a glossy single yarn, close, so that threads shade each other.
Cloth glossy_plain(float transmission) {
  Cloth cloth;
  Yarn yarn;
  yarn.groove_depth = 0.5f;
  yarn.lobes.transmission = transmission;
  yarn.lobes.along_width = 0.15f, yarn.lobes.across_width = 0.3f;
  cloth.yarns = {yarn};
  for (int i = 0; i < 4; ++i) {
    const float at = 0.25f + 0.5f * static_cast<float>(i);
    cloth.ends.push_back({at, 0.5f, 0.4f, 0.3f, {0.8f, 0.6f, 0.3f}, 0});
    cloth.picks.push_back({at, 0.5f, 0.4f, 0.3f, {0.3f, 0.6f, 0.8f}, 0});
  }
  cloth.width_mm = cloth.depth_mm = 2;
  cloth.up = BitMatrix(4, 4);
  for (int p = 0; p < 4; ++p)
    for (int e = 0; e < 4; ++e) cloth.up.set(p, e, (p + e) % 2);
  return cloth;
}

/// Mean of each channel of each pixel, and the variance of that mean.
struct Estimate {
  std::vector<double> mean, variance;
};

/// One period of the cloth in kSide x kSide pixels, seen from `view`; `seed` differs between independent pictures.
Estimate estimate(const TubeScene& tubes, const Surroundings& around, int bounces, int samples, uint64_t seed) {
  const ClothTracer tracer(tubes);
  const glm::vec3 view = glm::normalize(glm::vec3(0.3f, -0.2f, 1));
  Estimate out{std::vector<double>(kSide * kSide * 3), std::vector<double>(kSide * kSide * 3)};
  for_each_job(kSide * kSide, [&](int pixel) {
    RandomStream random((seed << 32) + static_cast<uint64_t>(pixel));
    glm::dvec3 sum(0), squares(0);
    for (int i = 0; i < samples; ++i) {
      const float x = static_cast<float>(pixel % kSide) + random.next();
      const float y = static_cast<float>(pixel / kSide) + random.next();
      const glm::vec3 at(x * tubes.cloth().width_mm / kSide, y * tubes.cloth().depth_mm / kSide, 0);
      const glm::dvec3 c = tracer.trace(at + view * 2.0f, -view, 0, around, random, bounces).radiance;
      sum += c, squares += c * c;
    }
    for (int k = 0; k < 3; ++k) {
      const double mean = sum[k] / samples;
      out.mean[static_cast<size_t>(3 * pixel + k)] = mean;
      out.variance[static_cast<size_t>(3 * pixel + k)] = (squares[k] / samples - mean * mean) / (samples - 1);
    }
  });
  return out;
}

/// Differences of two pictures in standard deviations: of each channel of each pixel, and last of the whole.
std::vector<double> z_values(const Estimate& a, const Estimate& b) {
  std::vector<double> z;
  std::array<double, 2> whole{};
  for (size_t i = 0; i < a.mean.size(); ++i) {
    const double variance = a.variance[i] + b.variance[i], off = a.mean[i] - b.mean[i];
    z.push_back(variance > 0 ? off / std::sqrt(variance) : off == 0 ? 0 : 1e9);
    if (i % 3 == 1) whole[0] += off, whole[1] += variance;  // green alone: channels share their samples
  }
  z.push_back(whole[0] / std::sqrt(whole[1]));
  return z;
}

Verdict verdict_of(const std::vector<double>& z) {
  Verdict verdict;
  for (const double one : z) verdict.add(z_tail(one));
  return verdict;
}

/// A disc of light in the direction of a lamp: sampled as a light, or met by chance as part of the sky.
struct Lamp {
  glm::vec3 towards = glm::normalize(glm::vec3(0.6f, 0.3f, 1));
  float radius_rad = 0.6f;
  float irradiance = kPi;

  Surroundings sampled() const {
    Surroundings s;
    s.light_towards = towards, s.light_radius_rad = radius_rad, s.light_irradiance = glm::vec3(irradiance);
    return s;
  }
  Surroundings met() const {
    Surroundings s;
    s.light_irradiance = glm::vec3(0);
    const float radiance = irradiance / (2 * kPi * (1 - std::cos(radius_rad)));
    s.sky = [lamp = *this, radiance](glm::vec3 d) {
      return glm::vec3(glm::dot(d, lamp.towards) >= std::cos(lamp.radius_rad) ? radiance : 0.0f);
    };
    return s;
  }
};

class Bias : public testing::Test {
 protected:
  void SetUp() override {
    auto built = TubeScene::build(glossy_plain(0), {});
    ASSERT_TRUE(built) << built.error().text;
    tubes_ = std::move(*built);
  }
  std::unique_ptr<TubeScene> tubes_;
};

TEST_F(Bias, ALightSampledOrMetByChanceGivesTheSamePicture) {
  const Lamp lamp;
  for (const int bounces : {0, 2}) {
    const Estimate sampled = estimate(*tubes_, lamp.sampled(), bounces, 8000, 1),
                   met = estimate(*tubes_, lamp.met(), bounces, 16000, 2);
    const std::vector<double> z = z_values(sampled, met);
    const Verdict verdict = verdict_of(z);
    EXPECT_TRUE(verdict.holds()) << bounces << " bounces: " << verdict.least() << " is less than " << verdict.needed()
                                 << "; the whole differs by " << z.back() << " standard deviations";
  }
}

TEST_F(Bias, TwoSeedsAreIndependentPicturesOfTheSame) {
  const Lamp lamp;
  const Estimate one = estimate(*tubes_, lamp.sampled(), 1, 2000, 3),
                 other = estimate(*tubes_, lamp.sampled(), 1, 2000, 4);
  std::vector<double> z = z_values(one, other);
  const Verdict verdict = verdict_of(z);
  EXPECT_TRUE(verdict.holds()) << verdict.least() << " is less than " << verdict.needed();
  // Streams that share numbers would be too alike, ones with fewer samples than they tell too different: the sum of
  // squares of green is a chi-square of so many degrees of freedom.
  double squares = 0;
  for (size_t i = 1; i < 3 * kSide * kSide; i += 3) squares += z[i] * z[i];
  const double above = gamma_tail(0.5 * kSide * kSide, 0.5 * squares);
  EXPECT_GT(std::min(above, 1 - above), 0.5 * kFalseAlarm) << squares << " of " << kSide * kSide;
}

TEST_F(Bias, OnePercentTooMuchLightIsSeen) {
  Lamp lamp;
  const Estimate right = estimate(*tubes_, lamp.sampled(), 0, 8000, 5);
  lamp.irradiance *= 1.01f;
  const Verdict verdict = verdict_of(z_values(right, estimate(*tubes_, lamp.sampled(), 0, 8000, 6)));
  EXPECT_FALSE(verdict.holds()) << verdict.least();
}

}  // namespace
}  // namespace weftlight::reference
