#pragma once
// Helpers beside GLM: the precision of the solver, safe normalisation, and two curves.

#include <cmath>
#include <glm/geometric.hpp>

#include "drape/mesh.h"

namespace weftlight::drape {

/// The precision of the solver: a substep moves a resting cloth by about 1e-3 mm, only ten times the rounding error of
/// a float of one metre in millimetres.
using Vec3d = glm::dvec3;

/// `fallback` for a vector without direction.
inline Vec3 unit(Vec3 a, Vec3 fallback = {0, 0, 1}) {
  const float l = glm::length(a);
  return l > 1e-12f ? a * (1.0f / l) : fallback;
}

/// i as a fraction of the way from the first of `count` to the last.
inline float fraction_of(int i, int count) { return static_cast<float>(i) / static_cast<float>(count - 1); }

inline float mix(float a, float b, float t) { return a + (b - a) * t; }
/// 0 before `from`, 1 after `to`, smooth between.
inline float ramp(float from, float to, float x) {
  const float t = std::fmin(std::fmax((x - from) / (to - from), 0.0f), 1.0f);
  return t * t * (3 - 2 * t);
}

constexpr float kPi = 3.14159265358979f;

}  // namespace weftlight::drape
