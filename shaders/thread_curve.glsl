// The centre line of a thread between two crossings. GLSL 3.30 and C++20.

#ifndef FORMULA
#define FORMULA
#endif

// The cubic through heights z0, z1 with slopes m0, m1, `step` apart (negative: backwards): its terms, from the first on.
FORMULA vec4 cubic_through(float z0, float m0, float z1, float m1, float step) {
  float mean = (z1 - z0) / step;
  return vec4(z0, m0, (3.0f * mean - 2.0f * m0 - m1) / step, (m0 + m1 - 2.0f * mean) / (step * step));
}

// x height, y slope, z second derivative so far from its first end.
FORMULA vec3 cubic_at(vec4 c, float along) {
  return vec3(c.x + along * (c.y + along * (c.z + along * c.w)), c.y + along * (2.0f * c.z + along * 3.0f * c.w),
              2.0f * c.z + along * 6.0f * c.w);
}
