#pragma once
// Lighting from an environment map: a few distant lights for what stands out, which the lobes render sharply,
// low-frequency light for the rest, and the map itself for the ray tracer.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "files/files.h"

namespace weftlight::scene {

using files::Image;

struct DistantLight {
  glm::vec3 towards{0, 1, 0};  // unit
  glm::vec3 irradiance{0};     // at normal incidence
  float radius = 0;            // sine of the half angle of its disc
  bool operator==(const DistantLight&) const = default;
};
inline constexpr size_t kMaxLights = 4;

using Harmonics = std::array<glm::vec3, 9>;  // radiance; order Y00, Y1-1, Y10, Y11, Y2-2 .. Y22 (y, z, x)

/// Direction of a point of the map, in fractions of its width and height: its centre lies at -z, behind what faces +z,
/// its right half towards +x.
glm::vec3 environment_direction(float across, float down);

class Environment {
 public:
  /// From a picture of read_environment().
  explicit Environment(Image picture);

  const std::vector<DistantLight>& lights() const { return lights_; }  // strongest first; their light is not in rest()
  const Harmonics& rest() const { return rest_; }
  const Image& picture() const { return picture_; }
  /// Mean radiance over all directions.
  glm::vec3 mean() const { return mean_; }
  /// Samples a light: the excess of one texel over the mean, chosen in proportion to it; u, v: 0..1. Its irradiance is
  /// divided by the probability, so that the mean over many, plus all of capped_radiance(), is the light of the map.
  DistantLight sample(float u, float v) const;
  /// Radiance along a direction, at most the mean.
  glm::vec3 capped_radiance(glm::vec3 direction) const;

 private:
  glm::vec3 texel(size_t at) const;
  glm::vec3 capped(glm::vec3 radiance) const;

  Image picture_;
  std::vector<DistantLight> lights_;
  Harmonics rest_{};
  glm::vec3 mean_{0};
  // Cumulative distributions of the light above the mean: over rows, and within each row, 0..1.
  std::vector<float> rows_, columns_;
};

/// Rotates radiance of bands 0 to 2 about +y by the given degrees of azimuth.
Harmonics turned(const Harmonics& sky, float degrees);
glm::vec3 turned(glm::vec3 direction, float degrees);

/// Real harmonics of bands 0 to 2.
std::array<float, 9> harmonics(glm::vec3 direction);

}  // namespace weftlight::scene
