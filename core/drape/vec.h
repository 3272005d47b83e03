#pragma once
// What the drape needs beside GLM: the solver's precision, directions that may be none, and two curves.

#include <cmath>
#include <glm/geometric.hpp>

#include "drape/mesh.h"
#include "drape/names.h"

namespace weftlight::drape {

/// The solver's own precision: a substep moves a resting cloth by about 1e-3 mm, ten times the
/// rounding of a float metre in millimetres.
using Vec3d = glm::dvec3;

/// `fallback` where there is no direction.
inline Vec3 unit(Vec3 a, Vec3 fallback = {0, 0, 1}) {
  const float l = glm::length(a);
  return l > 1e-12f ? a * (1.0f / l) : fallback;
}

/// Of the way from the first of `count` to the last.
inline float share_of(int i, int count) { return static_cast<float>(i) / static_cast<float>(count - 1); }

inline float mix(float a, float b, float t) { return a + (b - a) * t; }
/// 0 before `from`, 1 after `to`, smooth between.
inline float ramp(float from, float to, float x) {
  const float t = std::fmin(std::fmax((x - from) / (to - from), 0.0f), 1.0f);
  return t * t * (3 - 2 * t);
}

constexpr float kPi = 3.14159265358979f;

}  // namespace weftlight::drape
