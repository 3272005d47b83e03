// Light on one fibre (shaders/fibre.glsl) on the GPU against the same text in C++.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "light/formulas.h"
#include "pixel_program.h"

namespace weftlight::gl {
namespace {

using formulas::FibreOptics;
using glm::vec3;
using glm::vec4;

using FibreCase = std::array<vec4, 4>;
constexpr int kRows = 3;

constexpr const char* kFibreMain = R"(
  vec3 wi = given(0).xyz, wo = given(1).xyz;
  FibreOptics f = FibreOptics(given(2).x, given(3).xyz, given(2).y, given(2).z, vec3(0.0), 0.25);
  float h = given(2).w;
  if (row == 0) result = vec4(fibre_scatter(f, h, wi, wo), 1.0);
  if (row == 1) result = vec4(fibre_density(f, h, wi, wo), 0.0, 0.0, 1.0);
  if (row == 2) result = vec4(fibre_sample(f, h, wo, vec4(given(0).w, given(1).w, given(3).w, 0.3)), 1.0);
)";

vec3 on_cpu(const FibreCase& c, int row) {
  const vec3 wi(c[0]), wo(c[1]);
  const FibreOptics f{c[2].x, vec3(c[3]), c[2].y, c[2].z, vec3(0), 0.25f};
  const float h = c[2].w;
  switch (row) {
    case 0:
      return formulas::fibre_scatter(f, h, wi, wo);
    case 1:
      return {formulas::fibre_density(f, h, wi, wo), 0, 0};
    default:
      return formulas::fibre_sample(f, h, wo, {c[0].w, c[1].w, c[3].w, 0.3f});
  }
}

using FibreParity = PixelTest;

TEST_F(FibreParity, GpuAgreesWithCpu) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> u(0, 1);
  const auto direction = [&](float along) {
    const float a = 6.2831853f * u(rng), s = std::sqrt(1 - along * along);
    return vec3(along, s * std::cos(a), s * std::sin(a));
  };
  std::vector<FibreCase> cases;
  for (int k = 0; k < 2000; ++k) {
    const float along = 1.8f * u(rng) - 0.9f, other = glm::clamp(-along + 0.4f * u(rng) - 0.2f, -0.95f, 0.95f);
    cases.push_back({vec4(direction(along), 0.98f * u(rng)), vec4(direction(other), 0.98f * u(rng)),
                     vec4(1.1f + u(rng), 0.05f + 0.3f * u(rng), 0.05f + 0.4f * u(rng), 1.96f * u(rng) - 0.98f),
                     vec4(u(rng), u(rng), u(rng), 0.98f * u(rng))});
  }
  const std::vector<vec4> gpu = run_pixels(pixel_program({"fibre.glsl"}, kFibreMain), cases, kRows);
  for (int row = 0; row < kRows; ++row) {
    size_t off = 0, far_off = 0, lit = 0;
    for (size_t k = 0; k < cases.size(); ++k) {
      const vec3 c = on_cpu(cases[k], row), g(gpu[static_cast<size_t>(row) * cases.size() + k]);
      lit += c.x != 0;
      for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(std::isfinite(g[i])) << row << " case " << k;
        // The narrowest lobes fall by e within 0.01 radians, and the angles come from sines and cosines in floats.
        off += std::abs(g[i] - c[i]) > 0.01f * std::abs(c[i]) + 1e-3f;
        far_off += std::abs(g[i] - c[i]) > 0.05f * std::abs(c[i]) + 1e-3f;
      }
    }
    // A sample at the border of two parts of the light may fall to either; and of the flanks of lobes, some differ by a
    // little more than that.
    EXPECT_LE(off, row == 2 ? 12u : 3u) << row;
    EXPECT_LE(far_off, row == 2 ? 12u : 0u) << row;
    EXPECT_GT(lit, 1500u) << row;
  }
}

}  // namespace
}  // namespace weftlight::gl
