#pragma once
// Arithmetic on triples and pairs, for core/drape only (hence the inner namespace).

#include <cmath>
#include <type_traits>

#include "drape/mesh.h"
#include "drape/names.h"

namespace weftlight::drape {

template <class T>
using Triple = std::array<T, 3>;
/// The solver's own precision: a substep moves a resting cloth by about 1e-3 mm, ten times the
/// rounding of a float metre in millimetres.
using Vec3d = Triple<double>;

template <class T>
Triple<T> operator+(Triple<T> a, Triple<T> b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class T>
Triple<T> operator-(Triple<T> a, Triple<T> b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class T>
Triple<T> operator*(Triple<T> a, std::type_identity_t<T> s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
template <class T>
Triple<T>& operator+=(Triple<T>& a, Triple<T> b) {
  return a = a + b;
}
template <class T>
Triple<T>& operator-=(Triple<T>& a, Triple<T> b) {
  return a = a - b;
}
template <class T>
T dot(Triple<T> a, Triple<T> b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
T length(Triple<T> a) {
  return std::sqrt(dot(a, a));
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// `fallback` where there is no direction.
inline Vec3 unit(Vec3 a, Vec3 fallback = {0, 0, 1}) {
  const float l = length(a);
  return l > 1e-12f ? a * (1.0f / l) : fallback;
}
inline Vec3 to_float(Vec3d a) { return {static_cast<float>(a[0]), static_cast<float>(a[1]), static_cast<float>(a[2])}; }
inline Vec3d to_double(Vec3 a) {
  return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}

inline Vec2 operator-(Vec2 a, Vec2 b) { return {a[0] - b[0], a[1] - b[1]}; }
inline float length(Vec2 a) { return std::sqrt(a[0] * a[0] + a[1] * a[1]); }
inline float mix(float a, float b, float t) { return a + (b - a) * t; }
/// 0 before `from`, 1 after `to`, smooth between.
inline float ramp(float from, float to, float x) {
  const float t = std::fmin(std::fmax((x - from) / (to - from), 0.0f), 1.0f);
  return t * t * (3 - 2 * t);
}

constexpr float kPi = 3.14159265358979f;

}  // namespace weftlight::drape
