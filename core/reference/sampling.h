#pragma once
// The random numbers of the ray tracer, and what it draws with them.
//
// Based on: O'Neill 2014 (PCG-XSH-RR 64/32); Malley 1988 (a disc lifted to the hemisphere is cosine-weighted); Roberts
// 2018 (R2).

#include <cstdint>
#include <glm/glm.hpp>

namespace weftlight::reference {

/// Repeatable random numbers.
class RandomStream {
 public:
  explicit RandomStream(uint64_t seed) : state_(seed * 2 + 1) { next(), next(); }
  /// Uniform in [0, 1).
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

/// A unit direction of the hemisphere around a unit normal, with density cosine / pi by solid angle.
glm::vec3 cosine_direction(glm::vec3 normal, RandomStream& sampler);

/// A unit direction within `radius_rad` of a unit direction, uniform by solid angle. `towards` itself if the radius is
/// 0.
glm::vec3 in_disc(glm::vec3 towards, float radius_rad, RandomStream& sampler);

/// Position of sample k in a pixel, 0..1: the R2 sequence, shifted by pixel.
glm::vec2 pixel_sample(int k, glm::vec2 shift);

}  // namespace weftlight::reference
