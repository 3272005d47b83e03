// Tone mapping: scene-linear to display-linear, 0..1.
//
// Based on: Khronos PBR Neutral tone mapper 2024. Chosen because below its shoulder a colour leaves as it
// came: the thread that a weaver picked keeps its colour, and only highlights are pressed and paled.

vec3 tone_map(vec3 c) {
  const float kShoulder = 0.76;   // display value where the compression begins
  const float kPaling = 0.15;     // how fast highlights lose their colour
  float low = min(c.r, min(c.g, c.b));
  float toe = low < 0.08 ? low - 6.25 * low * low : 0.04;
  c -= toe;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < kShoulder) return max(c, vec3(0.0));
  float room = 1.0 - kShoulder;
  float pressed = 1.0 - room * room / (peak + room - kShoulder);
  c *= pressed / peak;
  float pale = 1.0 - 1.0 / (kPaling * (peak - pressed) + 1.0);
  return mix(c, vec3(pressed), pale);
}
