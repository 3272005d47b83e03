#include "reference/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weftlight::reference {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Basis {
  glm::vec3 t, b, n;
  explicit Basis(glm::vec3 normal) : n(normal) {
    const glm::vec3 helper = std::abs(n.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    t = glm::normalize(glm::cross(helper, n));
    b = glm::cross(n, t);
  }
  glm::vec3 world(glm::vec3 v) const { return t * v.x + b * v.y + n * v.z; }
};

}  // namespace

glm::vec3 cosine_direction(glm::vec3 normal, RandomStream& sampler) {
  const float r2 = sampler.next(), a = 2 * kPi * sampler.next(), r = std::sqrt(r2);
  return Basis(normal).world({r * std::cos(a), r * std::sin(a), std::sqrt(std::max(0.0f, 1 - r2))});
}

glm::vec3 in_disc(glm::vec3 towards, float radius_rad, RandomStream& sampler) {
  if (radius_rad <= 0) return towards;
  const float c = 1 - sampler.next() * (1 - std::cos(radius_rad)), s = std::sqrt(std::max(0.0f, 1 - c * c));
  const float a = 2 * kPi * sampler.next();
  return Basis(towards).world({s * std::cos(a), s * std::sin(a), c});
}

glm::vec2 pixel_sample(int k, glm::vec2 shift) {
  return glm::fract(shift + glm::vec2(0.7548776662f, 0.5698402910f) * static_cast<float>(k + 1));
}

}  // namespace weftlight::reference
