#pragma once
// Arithmetic on Vec3 and Vec2, for core/drape only (hence the inner namespace).

#include <cmath>

#include "drape/mesh.h"

namespace weftlight::draping {

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vec3 operator*(Vec3 a, float s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
inline float dot(Vec3 a, Vec3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }
/// `fallback` where there is no direction.
inline Vec3 unit(Vec3 a, Vec3 fallback = {0, 0, 1}) {
  const float l = length(a);
  return l > 1e-12f ? a * (1.0f / l) : fallback;
}
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a[0] - b[0], a[1] - b[1]}; }
inline float length(Vec2 a) { return std::sqrt(a[0] * a[0] + a[1] * a[1]); }
inline float mix(float a, float b, float t) { return a + (b - a) * t; }

constexpr float kPi = 3.14159265358979f;

}  // namespace weftlight::draping
