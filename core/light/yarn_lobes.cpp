#include "light/yarn_lobes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "design/yarn_fields.h"

namespace weftlight::light {

using cloth::linear_from_srgb;
using design::clamped;

namespace {

float unit(float v) { return v >= 0 ? std::min(v, 1.0f) : 0; }  // NaN: 0

glm::vec3 unit_colour(Linear c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

}  // namespace

FibreReflectance fibre_reflectance(const Lobes& any) {
  const Lobes lobes = clamped(any);
  const float root = (lobes.ior - 1) / (lobes.ior + 1), once = root * root;
  if (lobes.metallic) return {once, 1, 1, 0};
  const float fibre_layers = lobes.layers / (1 + (lobes.layers - 1) * once);
  return {fibre_layers * once, fibre_layers, lobes.inner, lobes.body};
}

interop::YarnData yarn_data(const Lobes& any) {
  const Lobes lobes = clamped(any);
  const Linear tint = linear_from_srgb(lobes.specular_tint);
  const FibreReflectance fibre = fibre_reflectance(lobes);
  interop::YarnData y{};
  y.along_width = lobes.along_width, y.across_width = lobes.across_width;
  y.specular = lobes.specular, y.reflectance = fibre.clear, y.fibre_layers = fibre.fibre_layers;
  y.body = fibre.body, y.transmission = lobes.transmission;
  y.fuzz = lobes.fuzz, y.fuzz_width = lobes.fuzz_width, y.fuzz_depth = lobes.fuzz_width * lobes.fuzz_width;
  y.tint = {tint.r, tint.g, tint.b, fibre.dyed};
  y.inner_halvings = lobes.metallic ? 0 : -std::log2(std::clamp(lobes.inner_depth, 0.25f, 2.0f));
  return y;
}

interop::YarnData mean_yarn(const Cloth& cloth, const std::vector<ThreadBody>& threads) {
  using Numbers = std::array<float, sizeof(interop::YarnData) / sizeof(float)>;
  Numbers sum{};
  for (const ThreadBody& thread : threads) {
    const auto numbers = std::bit_cast<Numbers>(yarn_data(cloth.yarns[static_cast<size_t>(thread.yarn)].lobes));
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += numbers[i] / static_cast<float>(threads.size());
  }
  return std::bit_cast<interop::YarnData>(sum);
}

glm::vec3 body_weights(const formulas::YarnLobes& lobes) {
  constexpr float kNone = 1e-6f;  // of a metal: all alike
  const glm::vec3 sent = lobes.body + lobes.through + kNone;
  return sent / (sent.r + sent.g + sent.b);
}

formulas::YarnLobes yarn_lobes(const Lobes& lobes, Linear thread_colour) {
  return formulas::yarn_of(yarn_data(lobes), unit_colour(thread_colour));
}

}  // namespace weftlight::light
