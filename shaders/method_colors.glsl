// The colours of the methods of `auto` in the false colours and their legend, linear. GLSL 3.30 and C++20.
//
// Based on: Okabe, Ito 2008: vermilion, yellow, bluish green, blue, light enough to show the cloth's shading.

#ifndef FORMULA
#define FORMULA
#endif

// method: 0 yarn, 1 cell, 2 repeat, 3 cloth (kShadedMethods of core/design/methods.h).
FORMULA vec3 method_color(int method) {
  if (method == 0) return vec3(0.84f, 0.37f, 0.0f);
  if (method == 1) return vec3(0.94f, 0.89f, 0.26f);
  if (method == 2) return vec3(0.0f, 0.62f, 0.45f);
  return vec3(0.0f, 0.45f, 0.70f);
}
