// The centre line of a thread between two crossings. GLSL 3.30 and C++20.

#ifndef FORMULA
#define FORMULA
#endif

// A cubic through heights z0, z1 with slopes m0, m1: x height, y slope, z second derivative at t (0..1) of `step`.
FORMULA vec3 hermite(float z0, float m0, float z1, float m1, float step, float t) {
  float rise = z1 - z0;
  float a = m0 * step;
  float b = m1 * step;
  float c2 = 3.0f * rise - 2.0f * a - b;
  float c3 = a + b - 2.0f * rise;
  return vec3(z0 + t * (a + t * (c2 + t * c3)), (a + t * (2.0f * c2 + t * 3.0f * c3)) / step,
              (2.0f * c2 + t * 6.0f * c3) / (step * step));
}
