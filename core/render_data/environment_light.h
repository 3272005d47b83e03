#pragma once
// The light of a picture from all around, as the renderer takes it: what stands out as a few lights far off, which the
// lobes see sharp, the rest as soft light; and the picture itself for the ray tracer.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "files/files.h"
#include "render_data/names.h"

namespace weftlight::render_data {

/// A light far off.
struct DistantLight {
  glm::vec3 towards{0, 1, 0};  // unit
  glm::vec3 irradiance{0};     // at right angles
  float radius = 0;            // sine of the half angle of its disc
  bool operator==(const DistantLight&) const = default;
};
inline constexpr size_t kMaxLights = 4;

using Harmonics = std::array<glm::vec3, 9>;  // radiance; order Y00, Y1-1, Y10, Y11, Y2-2 .. Y22 (y, z, x)

/// Direction of a place of the picture, shares of its width and height: its middle lies at -z, behind what faces +z,
/// its right half towards +x.
glm::vec3 environment_direction(float across, float down);

class Environment {
 public:
  /// Of a picture as read_environment() gives it.
  explicit Environment(Image picture);

  const std::vector<DistantLight>& lights() const { return lights_; }  // strongest first; their light is not in rest()
  const Harmonics& rest() const { return rest_; }
  const Image& picture() const { return picture_; }
  /// Mean radiance over all directions.
  glm::vec3 mean() const { return mean_; }
  /// A light of what one texel has above the mean, chosen by how much that is; u, v: 0..1. Its irradiance is over the
  /// chance to be chosen, so that the mean of many, with all of soft(), is the picture's light.
  DistantLight sample(float u, float v) const;
  /// Radiance along a direction, no brighter than the mean.
  glm::vec3 soft(glm::vec3 direction) const;

 private:
  glm::vec3 texel(size_t at) const;
  glm::vec3 soft_of(glm::vec3 radiance) const;

  Image picture_;
  std::vector<DistantLight> lights_;
  Harmonics rest_{};
  glm::vec3 mean_{0};
  std::vector<float> rows_,
      columns_;  // of what is above the mean: running sums of the rows' light, and within each row, 0..1
};

/// Bands 0 to 2 of radiance turned about +y, so that what came from azimuth a comes from a + degrees.
Harmonics turned(const Harmonics& sky, float degrees);
glm::vec3 turned(glm::vec3 direction, float degrees);

/// Real harmonics of bands 0 to 2.
std::array<float, 9> harmonics(glm::vec3 direction);

}  // namespace weftlight::render_data
