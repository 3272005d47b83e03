// The sRGB curve, of one channel of 0..1. GLSL 3.30 and C++20 (core/design/srgb.h).
//
// Based on: IEC 61966-2-1:1999.

#ifndef FORMULA
#define FORMULA
#endif

FORMULA float srgb_decoded(float c) { return c <= 0.04045f ? c / 12.92f : pow((c + 0.055f) / 1.055f, 2.4f); }
FORMULA float srgb_encoded(float c) {
  return c <= 0.0031308f ? c * 12.92f : 1.055f * pow(c, 1.0f / 2.4f) - 0.055f;
}
