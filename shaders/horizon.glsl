// Visibility of a light over the surrounding threads, from horizons.
// GLSL 3.30 and C++20. Azimuth 0 is +u (along the weft), a quarter turn +v (along the warp).
//
//   HorizonTaps t = horizon_taps(azimuth, count): mix four neighbouring bins t.at[] with t.weight,
//   for the mean and for the spread of the horizon's sine, then horizon_visibility().
//
// Based on: Max 1988, "Horizon mapping"; Keys 1981 (cubic convolution). Differs: the horizon of a footprint is a mean
// and a spread, so shadows fade with distance where a boolean map would flicker.

#ifndef FORMULA
#define FORMULA
#endif

struct HorizonTaps {
  ivec4 at;       // bins
  vec4 weight;    // sum 1
};

// Cubic in azimuth: exact to third order, so that a moving light shows no steps at the bins.
FORMULA HorizonTaps horizon_taps(float azimuth, int count) {
  float n = float(count);
  float turn = azimuth * 0.15915494f;
  float x = (turn - floor(turn)) * n;
  float cell = min(floor(x), n - 1.0f);
  float t = clamp(x - cell, 0.0f, 1.0f);
  int i = int(cell);
  HorizonTaps taps;
  taps.at = ivec4((i + count - 1) % count, i, (i + 1) % count, (i + 2) % count);
  float t2 = t * t;
  float t3 = t2 * t;
  taps.weight = vec4(-0.5f * t + t2 - 0.5f * t3, 1.0f - 2.5f * t2 + 1.5f * t3,
                     0.5f * t + 2.0f * t2 - 1.5f * t3, -0.5f * t2 + 0.5f * t3);
  return taps;
}

FORMULA float horizon_mix(HorizonTaps taps, vec4 values) {
  return clamp(dot(taps.weight, values), 0.0f, 1.0f);
}

// Visible fraction of a light. elevation_sine: of its centre above the cloth; mean, spread: mean and standard
// deviation of the horizon's sine over the footprint; light_radius: radians (its disc is taken as a Gaussian of the
// same variance, radius / 2).
FORMULA float horizon_visibility(float elevation_sine, float mean, float spread, float light_radius) {
  float softness = 0.5f * light_radius * sqrt(max(1.0f - elevation_sine * elevation_sine, 0.0f));
  float sigma = sqrt(spread * spread + softness * softness + 1.0e-6f);
  float x = clamp((elevation_sine - mean) / sigma, -4.0f, 4.0f);
  // Normal distribution by its logistic form (Bowling et al. 2009, error 1.4e-4).
  return 1.0f / (1.0f + exp(-x * (1.5976f + 0.07056f * x * x)));
}
