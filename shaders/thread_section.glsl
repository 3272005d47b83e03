// Cross-section of a thread in units of its half sizes: an ellipse, or, where the thread is pressed between its
// neighbours, fuller towards the corners of its room. GLSL 3.30 and C++20.
//
// Based on: M. Fernandez-Guasti, Analytic geometry of some rectilinear figures, 1992: the squircle
// x^2 + y^2 - q x^2 y^2 = 1 (his s^2 is q here), from a circle (q = 0) to a square (q = 1).
// Differs: stretched to the thread's half sizes, as the circle is to an ellipse.

#ifndef FORMULA
#define FORMULA
#endif

// 1 on the section, less inside; proportional to the distance from the centre. Takes x^2 and y^2.
FORMULA float section_norm(float xx, float yy, float q) {
  float r = xx + yy;
  return sqrt(0.5f * (r + sqrt(max(r * r - 4.0f * q * xx * yy, 0.0f))));
}

// Area of the section over that of the ellipse (q = 0): a fit to the integral, within 0.0005 up to q = 0.75.
FORMULA float section_fullness(float q) {
  return 1.0f + q * (0.125f + q * (0.0511f + q * (-0.004f + q * 0.0629f)));
}

// y of the section's upper side at an x of -1..1.
FORMULA float section_top(float x, float q) {
  float x2 = min(x * x, 1.0f);
  return sqrt((1.0f - x2) / max(1.0f - q * x2, 1.0e-6f));
}

// Along the normal at a point of the section.
FORMULA vec2 section_gradient(float x, float y, float q) {
  return vec2(x * (1.0f - q * y * y), y * (1.0f - q * x * x));
}

// Curvature, 1/mm, at a point of the section. thin: 1 over half width and half height.
FORMULA float section_curvature(float x, float y, float q, vec2 thin) {
  vec2 g = section_gradient(x, y, q) * thin;
  float xx = (1.0f - q * y * y) * thin.x * thin.x;
  float yy = (1.0f - q * x * x) * thin.y * thin.y;
  float xy = -2.0f * q * x * y * thin.x * thin.y;
  float size = inversesqrt(max(g.x * g.x + g.y * g.y, 1.0e-20f));
  return (xx * g.y * g.y - 2.0f * xy * g.x * g.y + yy * g.x * g.x) * size * size * size;
}

// The point of the section in the direction of an angle from its top, and the change of that point with the angle.
FORMULA vec4 section_point(float angle, float q) {
  float s = sin(angle);
  float c = cos(angle);
  float sc = s * c;
  float root = sqrt(max(1.0f - 4.0f * q * sc * sc, 1.0e-6f));
  float reach = sqrt(2.0f / (1.0f + root));
  float change = 4.0f * q * sc * (c * c - s * s) / (root * (1.0f + root) * (1.0f + root) * reach);
  return vec4(reach * s, reach * c, change * s + reach * c, change * c - reach * s);
}
