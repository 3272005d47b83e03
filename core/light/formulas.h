#pragma once
// The formulas of shaders/*.glsl as C++: the same text, through GLM, in weftlight::formulas.
// Its tables are those of light/tables.h.

#include <bit>
#include <cstdint>
#include <glm/glm.hpp>

#include "shaders/interop.h"

namespace weftlight::formulas {

using glm::ivec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using interop::YarnData;
using namespace glm;

vec4 albedo_table(float opening, float along, float across);
vec2 albedo_mean_table(float major, float minor);
vec4 fuzz_table(float opening, float depth);

/// exp for x in -87..88 (beyond: clamped), relative error 2e-7. It hides GLM's, since it has no branch and no
/// call: a loop over formulas can then run on vectors. Cody, Waite reduction; Taylor series to x^6.
inline float exp(float x) {
  const float t = x < -87.0f ? -87.0f : (x > 88.0f ? 88.0f : x);
  const float shifted = t * 1.44269504f + 12582912.0f;  // 1.5 * 2^23: the sum's low bits are the integer
  const float n = shifted - 12582912.0f;
  const float r = (t - n * 0.693359375f) + n * 2.12194440e-4f;
  const float p =
      1.0f + r * (1.0f + r * (0.5f + r * (0.16666667f + r * (0.041666667f + r * (0.0083333333f + r * 0.0013888889f)))));
  return p * std::bit_cast<float>((std::bit_cast<int32_t>(shifted) << 23) + 0x3f800000);
}

/// Likewise the logarithm, of a normal positive number alone, so that it does not hide GLM's: error 2e-7 of it or 1e-7.
/// Cephes' polynomial about 1.
inline float log_of_normal(float x) {
  const int32_t bits = std::bit_cast<int32_t>(x), from_root = bits - 0x3f3504f3;  // of a half
  const float n = static_cast<float>(from_root >> 23);
  const float r = std::bit_cast<float>((from_root & 0x007fffff) + 0x3f3504f3) - 1.0f, r2 = r * r;
  const float p =
      0.33333331174f +
      r * (-0.24999993993f +
           r * (0.20000714765f +
                r * (-0.16668057665f +
                     r * (0.14249322787f +
                          r * (-0.12420140846f + r * (0.1167699874f + r * (-0.1151461031f + r * 0.070376836292f)))))));
  return (r + (p * r * r2 - n * 2.12194440e-4f - 0.5f * r2)) + n * 0.693359375f;
}

/// Of a normal positive number, instead of GLM's; relative error 3e-7 times the logarithm of the result, or 3e-7.
inline float pow(float x, float exponent) { return exp(exponent * log_of_normal(x)); }

#define FORMULA inline
#include "shaders/fibre.glsl"
#include "shaders/filter.glsl"
#include "shaders/flyaway.glsl"
#include "shaders/horizon.glsl"
#include "shaders/lattice.glsl"
#include "shaders/lobes.glsl"
#include "shaders/method_colors.glsl"
#include "shaders/methods.glsl"
// clang-format off: it builds on those above
#include "shaders/engine.glsl"
// clang-format on
#include "shaders/tone.glsl"
#include "shaders/vrst03.glsl"
#undef FORMULA

}  // namespace weftlight::formulas
