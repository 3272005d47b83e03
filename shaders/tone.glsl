// Tone mapping: scene-linear to display-linear, 0..1. GLSL 3.30 and C++20.
//
// Based on: Khronos PBR Neutral tone mapper 2024. Chosen because it keeps colours below its shoulder: a thread has the
// colour that the weaver picked, and only highlights are compressed and desaturated.

#ifndef FORMULA
#define FORMULA
#endif

FORMULA vec3 tone_map(vec3 c) {
  const float kShoulder = 0.76f;  // display value where the compression begins
  const float kPaling = 0.15f;    // desaturation rate of highlights
  float low = min(c.r, min(c.g, c.b));
  float toe = low < 0.08f ? low - 6.25f * low * low : 0.04f;
  c -= toe;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < kShoulder) return max(c, vec3(0.0f));
  float room = 1.0f - kShoulder;
  float pressed = 1.0f - room * room / (peak + room - kShoulder);
  c *= pressed / peak;
  float pale = 1.0f - 1.0f / (kPaling * (peak - pressed) + 1.0f);
  return mix(c, vec3(pressed), pale);
}
