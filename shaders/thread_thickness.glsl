// How a spun thread swells and thins along its length. GLSL 3.30 and C++20.
//
//   float f = thickness_factor(spread, system, thread, crossing, count, slubs_in(length))    thickness there over its mean
//   vec2 half = swollen(half_sizes, half_room, f)                                   half width and half height there
//
// One thick or thin place follows the other, each of its own strength, and the thread is as thick as its mean where one
// ends; between two crossings the section goes evenly. It closes over the period. What a swelling adds to the slope
// along the thread (two degrees in the steepest slub) is left out of the normal, here and in the traced truth.

#ifndef FORMULA
#define FORMULA
#endif

// Length of a thick or thin place: slubs of flax and of dupion silk are one to some centimetres long; what is longer is
// the spread between threads.
const float kSlub_mm = 9.0f;
const float kSlubGain = 1.7547f;      // so that the thickness spreads as asked for: 1 / sqrt(4/5 * 128/315)
const float kMinSwell = 0.4f;       // of the mean thickness
const float kTallestSection = 1.5f;   // a jammed thread gives way sideways until then (core/cloth/lay_out.cpp)

FORMULA int slubs_in(float length_mm) { return max(int(length_mm / kSlub_mm + 0.5f), 1); }

// A number for each place of each thread, 0 to 1.
FORMULA float slub_of(uint thread, int slub) {
  uint h = (thread + uint(slub) * 0x85EBCA77u) * 0x2C1B3C6Du;
  h = (h ^ (h >> 15)) * 0x297A2D39u;
  return float(h >> 8) * 5.9604644775390625e-8f;
}

// spread: standard deviation over the mean. count: crossings of the period, crossing of 0..count - 1.
FORMULA float thickness_factor(float spread, int system, int thread, int crossing, int count, int slubs) {
  uint own = uint(thread) * 0x9E3779B1u + (system == 0 ? 0x51u : 0xA7000000u);
  // Each thread's places begin elsewhere.
  float place = (float(crossing) / float(count) + float(own >> 8) * 5.9604644775390625e-8f) * float(slubs);
  int slub = int(place);
  float u = place - float(slub);
  if (slub >= slubs) slub -= slubs;
  float strength = slub_of(own, slub);
  float bump = 4.0f * u * (1.0f - u);
  // Thick places are fewer and stronger than thin ones: -1 to 2, mean 0.
  return max(1.0f + spread * kSlubGain * (3.0f * strength * strength - 1.0f) * bump * bump, kMinSwell);
}

// A thread keeps to its room: what has none beside it goes into its height.
FORMULA vec2 uneven_section(vec2 half_size, float half_room, float f) {
  float wide = min(half_size.x * f, max(half_room, half_size.x));
  return vec2(wide, min(half_size.y * f * (half_size.x * f / wide), max(kTallestSection * wide, half_size.y)));
}
