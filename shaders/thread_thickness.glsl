// Threads that give way: sections of uneven threads, and how far they stand aside. GLSL 3.30 and C++20.
//
//   float s = border_sway(system, thread, crossing, count, slubs_in(length))   of the border beyond this thread
//   vec3 section = section_between(body, sway before it, sway after it)   half width, half height, offset aside
//
// Neighbouring threads of a system share the room that the sett leaves. Where one is thick, the border to its neighbour
// moves aside, and the neighbour gives way; where it is thin, the neighbour takes its room. A thread fills the same part
// of its room everywhere, so the cloth is covered as if the threads were even: threads that touch leave no holes beside
// a thin place. Sections are interpolated between crossings; the pattern is periodic. A thread turns with its centre line;
// that its sides are not parallel (two degrees in the steepest slub) is not in the normal, here and in the traced
// reference.

#ifndef FORMULA
#define FORMULA
#endif

// Length of a thick or thin place: slubs of flax and of dupion silk are one to some centimetres long; longer variation
// is the spread between threads.
const float kSlub_mm = 9.0f;
const float kMaxSway = 2.7171f;         // so that the standard deviation is 1: sqrt(3) / sqrt(128/315)
const float kMaxAside = 0.8f;           // of half the room: the furthest that a border moves
const float kTallestSection = 1.5f;      // height over width to which a jammed thread grows (core/cloth/lay_out.cpp)

// A thread's section; mm.
struct ThreadSection {
  float centre;      // across
  float half_room;   // half of the spacing
  float half_width;  // means along the thread
  float half_height;
  vec2 aside;        // mean offsets of its two borders from the middle between the threads, towards +across
  vec2 sway;         // standard deviations of these along the thread
  float squareness;  // of the section (thread_section.glsl)
};

FORMULA bool is_uneven(ThreadSection s) { return s.sway.x > 0.0f || s.sway.y > 0.0f; }

// The furthest that a thread with all its room reaches to a side of its place.
FORMULA float furthest_side(ThreadSection s) {
  return s.half_room + max(kMaxSway * s.sway.x - s.aside.x, kMaxSway * s.sway.y + s.aside.y);
}

FORMULA int slubs_in(float length_mm) { return max(int(length_mm / kSlub_mm + 0.5f), 1); }

// A random number for each slub of each border, 0 to 1.
FORMULA float slub_of(uint border, int slub) {
  uint h = (border + uint(slub) * 0x85EBCA77u) * 0x2C1B3C6Du;
  h = (h ^ (h >> 15)) * 0x297A2D39u;
  return float(h >> 8) * 5.9604644775390625e-8f;
}

// Of the border beyond a thread: mean 0, standard deviation 1, at most kMaxSway. count: crossings of the period,
// crossing of 0..count - 1.
FORMULA float border_sway(int system, int thread, int crossing, int count, int slubs) {
  uint own = uint(thread) * 0x9E3779B1u + (system == 0 ? 0x51u : 0xA7000000u);
  // Each border starts at its own phase.
  float slub_at = (float(crossing) / float(count) + float(own >> 8) * 5.9604644775390625e-8f) * float(slubs);
  int slub = int(slub_at);
  float u = slub_at - float(slub);
  if (slub >= slubs) slub -= slubs;
  float bump = 4.0f * u * (1.0f - u);
  return kMaxSway * (2.0f * slub_of(own, slub) - 1.0f) * bump * bump;
}

// Half width, half height, and offset of the centre towards +across, between borders of this sway.
FORMULA vec3 section_between(ThreadSection s, float before, float after) {
  vec2 aside = s.aside + s.sway * vec2(before, after);
  float wider = 1.0f + 0.5f * (s.sway.y * after - s.sway.x * before) / (s.half_room + 0.5f * (s.aside.y - s.aside.x));
  vec2 half_sizes = max(vec2(s.half_width, s.half_height) * wider, vec2(1.0e-6f));
  return vec3(half_sizes, 0.5f * (aside.x + aside.y));
}
