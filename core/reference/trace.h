#pragma once
// Light in the cloth: what a ray sees of the tubes, with the yarns' own lobes, true shadowing and
// masking, gaps, light through the threads, and bounces if asked. Cloth space, millimetres.
//
// Based on: Kajiya 1986 (rendering equation, estimated by following paths).

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "cloth/thread_texture.h"
#include "reference/names.h"
#include "reference/tubes.h"

namespace weftlight::reference {

/// Repeatable random numbers (O'Neill 2014, PCG-XSH-RR 64/32).
class RandomStream {
 public:
  explicit RandomStream(uint64_t seed) : state_(seed * 2 + 1) { next(), next(); }
  float next() {
    const uint64_t old = state_;
    state_ = old * 6364136223846793005u + 1442695040888963407u;
    const uint32_t x = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
    const uint32_t r = static_cast<uint32_t>(old >> 59);
    return static_cast<float>(((x >> r) | (x << ((32 - r) & 31))) >> 8) * 0x1p-24f;
  }

 private:
  uint64_t state_;
};

/// What lies around the cloth at a point of it.
struct Surroundings {
  glm::vec3 light_towards{0, 0, 1};         // unit, cloth space
  float light_radius_rad = 0;               // half angle of its disc
  glm::vec3 light_irradiance{3.14159265f};  // on a surface that faces it
  /// Whether something outside the cloth hides the light in that direction. Empty: nothing does.
  std::function<bool(glm::vec3)> hidden;
  /// Radiance of the sky along a direction that leaves the cloth. Empty: black.
  std::function<glm::vec3(glm::vec3)> sky;
};

struct Seen {
  glm::vec3 radiance{0};
  bool hit = false;  // false: the ray went through a gap
};

class ClothTracer {
 public:
  explicit ClothTracer(const TubeScene& tubes);
  /// One sample of what the ray sees. `bounces`: indirect light between threads, 0 for none.
  Seen trace(glm::vec3 origin, glm::vec3 direction, float t_min, const Surroundings& around, RandomStream& sampler,
             int bounces) const;

 private:
  struct Point;
  Point point_of(const TubeHit& hit, glm::vec3 from) const;
  glm::vec3 direct(const Point& point, const Surroundings& around, RandomStream& sampler) const;
  bool shadowed(const Point& point, glm::vec3 towards) const;

  const TubeScene& tubes_;
  std::array<std::vector<ThreadTexture>, 2> textures_;
  float ray_epsilon_mm_;  // offset of secondary rays
};

}  // namespace weftlight::reference
