// Threads as bodies: sections (thread_section.glsl) swept at right angles along centre lines that pass over each other,
// and rays among them. GLSL 3.30 and C++20 (core/cloth/thread_scene.h). Cloth space: x along the weft, y along the warp,
// z out of the visible face; millimetres. Systems: 0 warp, 1 weft.
//
//   Crossing c = crossing_near(grid, at)           the two strands over and under a position
//   ThreadHit h = first_thread(grid, at, v, span)  the first thread on a ray down against v
//   thread_point(strand, ...)                      normal and axis there, position on the thread
//   threads_block(grid, from, l, ...)              whether another thread occludes the light
//
// The host declares the data of the cloth:
//   ThreadSection thread_body(int system, int thread)
//   int thread_bin(int system, int bin)            the first thread that reaches past the bin's start
//   vec4 crossing_at(int end, int pick)            height and slope of the warp, of the weft
//   vec2 aside_at(int end, int pick)               how far washing moves both sideways there, if grid.aside is not 0
//   ThreadGrid thread_layer(int i, float side)     the cloth's layer i: thread_records.glsl's grid_of()
// and may define these where they hold for the cloth, so that unneeded code is left out (a software renderer runs both
// sides of a branch):
//   EVEN_THREADS   the threads of each system have the same spacing
//   ONE_LAYER
//   SMOOTH_YARNS   no thread is uneven along its length
//   CLOSED_CLOTH   threads of a system touch everywhere
//   STRAIGHT_THREADS   washing moves no thread sideways (core/cloth/washed_aside.h)
//
// Loops test their condition at the end: a software renderer would run the body of one that tests first once more.
//
// Where threads are moved sideways, those that cross them are stretched between their new places.
//
// A cloth of several layers has a grid for each; at a position each layer has one end and one pick.
//
// Based on: F. T. Peirce 1937 (crimp; the heights are core/cloth/centre_line.cpp's); Policarpo, Oliveira, Comba 2005
// (linear steps along a ray, then the secant). Differs: the shape is evaluated, not fetched from a height map, so that
// it is sharp at any zoom and threads have an underside.

#include "thread_curve.glsl"

// Steps of a ray in one crossing's cell, for a rise of the cloth's height above its middle plane.
const float kStepsInTop = 5.0f;
const int kMinStepsInCell = 4;
const int kMaxStepsInCell = 10;
// Where the nearest thread is further away than such a step, the ray advances this fraction of the distance.
// strand_near() underestimates it for a thread wider than high, and is approximate over a bend.
const float kSafe = 0.8f;
const int kMaxHalvings = 24;   // for up to 2^24 threads
const int kBinsAThread = 4;

// One thread between two crossings.
struct Strand {
  int thread;
  float centre;       // across, at the crossing
  float aside;        // its change along, 1
  vec2 thin;          // 1 over half width and half height, at the crossing
  vec2 thinner;       // their change along, 1/mm, up to the next one
  float half_height;  // mean: unit of distances inside a section
  float squareness;   // of the section
  float start;        // along, at the crossing
  float low;          // bounds of this crossing and the next on this side, along
  float high;
  vec4 curve;       // of the centre line
};

struct Crossing {
  Strand warp;
  Strand weft;
  vec2 low;         // both strands are valid between these positions
  vec2 high;
};

FORMULA vec3 strand_curve(Strand s, float along) {
  // Beyond its ends it continues straight: a cubic would diverge there.
  float held = clamp(along, s.low, s.high);
  vec3 c = cubic_at(s.curve, held - s.start);
  return vec3(c.x + c.y * (along - held), c.y, held == along ? c.z : 0.0f);
}

// 1 over half width and half height at a position along.
FORMULA vec2 strand_thin(Strand s, float along) {
  return s.thin + s.thinner * (clamp(along, s.low, s.high) - s.start);
}

// Position of the centre line across.
FORMULA float strand_centre(Strand s, float along) {
#if defined(SMOOTH_YARNS) && defined(STRAIGHT_THREADS)
  return s.centre;
#else
  return s.centre + s.aside * (clamp(along, s.low, s.high) - s.start);
#endif
}

// Coordinates of a point in the section of a thread that contains it: x, y in half widths and heights;
// z the section's position along. Sections are perpendicular to the centre line, so over a slope the one that contains
// a point lies further along: the foot of the perpendicular, by Newton steps.
FORMULA vec3 section_coords(Strand s, float across, float along, float z) {
  float foot = along;
  vec3 c = strand_curve(s, foot);
  for (int k = 0; k < 2; ++k) {
    float square = 1.0f + c.y * c.y;
    // Limited where sections meet inside a bend.
    foot += (along - foot + (z - c.x) * c.y) / max(square - (z - c.x) * c.z, 0.5f * square);
    c = strand_curve(s, foot);
  }
  float up = ((z - c.x) - (along - foot) * c.y) * inversesqrt(1.0f + c.y * c.y);
  vec2 thin = strand_thin(s, foot);
  return vec3((across - strand_centre(s, foot)) * thin.x, up * thin.y, foot);
}

// Signed distance in mm, negative inside the thread.
FORMULA float strand_distance(Strand s, float across, float along, float z) {
  vec3 p = section_coords(s, across, along, z);
  return (section_norm(p.x * p.x, p.y * p.y, s.squareness) - 1.0f) * s.half_height;
}

// Whether a vertical line through a position meets the thread.
FORMULA bool lies_under(Strand s, float across, float along) {
  return abs((across - strand_centre(s, along)) * strand_thin(s, along).x) <= 1.0f;
}

// Highest point of the thread over a position, refined in `steps` from that of a straight one; far below if it is not
// there.
FORMULA float strand_top(Strand s, float across, float along, int steps) {
  vec2 thin = strand_thin(s, along);
  float x = (across - strand_centre(s, along)) * thin.x;
  if (abs(x) > 1.0f) return -1.0e6f;
  vec3 c = strand_curve(s, along);
  float lean = sqrt(1.0f + c.y * c.y) / thin.y;
  float wanted = section_top(x, s.squareness);
  float z = c.x + wanted * lean;
  for (int k = 0; k < steps; ++k) z += (wanted - section_coords(s, across, along, z).y) * lean;
  return z;
}

// An approximation of strand_distance() for the steps of a ray: one step towards the foot.
FORMULA float strand_near(Strand s, float across, float along, float z) {
  vec3 c = strand_curve(s, along);
  float foot = along + (z - c.x) * c.y / (1.0f + c.y * c.y);
  c = strand_curve(s, foot);
  vec2 thin = strand_thin(s, along);
  float x = (across - strand_centre(s, along)) * thin.x;
  float y = ((z - c.x) - (along - foot) * c.y) * thin.y;
  return (section_norm(x * x, y * y / (1.0f + c.y * c.y), s.squareness) - 1.0f) * s.half_height;
}

// The first thread that reaches past a position of 0..period.
FORMULA int thread_at(ThreadGrid g, int system, float at) {
  int first = g.first[system];
#if defined(EVEN_THREADS)
  return first + clamp(int(at / g.even[system]), 0, g.count[system] - 1);
#else
  if (g.even[system] > 0.0f) return first + clamp(int(at / g.even[system]), 0, g.count[system] - 1);
  int bins = g.count[system] * kBinsAThread;
  int bin = clamp(int(at / g.period[system] * float(bins)), 0, bins - 1);
  int thread = thread_bin(system, first * kBinsAThread + bin);
  int last = bin + 1 < bins ? thread_bin(system, first * kBinsAThread + bin + 1) : first + g.count[system] - 1;
  // Most bins contain one border at most; those of very fine threads among coarse ones contain thousands.
  int k = 0;
  do {
    int middle = (thread + last) / 2;
    ThreadSection body = thread_body(system, middle);
    if (body.centre + body.half_room > at) last = middle;
    else thread = min(middle + 1, last);
    ++k;
  } while (k < kMaxHalvings && thread < last);
  return thread;
#endif
}

// Sway of the border beyond a thread where it crosses thread `at` of the other system.
FORMULA float sway_at(ThreadGrid g, int system, int thread, int at) {
  int other = 1 - system;
  return border_sway(system, thread, at - g.first[other], g.count[other], g.slubs[system]);
}

FORMULA int thread_before(ThreadGrid g, int system, int thread) {
  return thread == g.first[system] ? thread + g.count[system] - 1 : thread - 1;
}

// A thread's half width, half height and offset aside where it crosses thread `at` of the other system.
FORMULA vec3 section_at(ThreadGrid g, int system, int thread, ThreadSection body, int at) {
  vec2 sways = vec2(0.0f);
#if !defined(SMOOTH_YARNS)
  if (is_uneven(body)) {
    sways = vec2(sway_at(g, system, thread_before(g, system, thread), at), sway_at(g, system, thread, at));
  }
#endif
  vec3 section = section_between(body, sways.x, sways.y);
#if !defined(STRAIGHT_THREADS)
  if (g.aside > 0.0f) section.z += system == 0 ? aside_at(thread, at).x : aside_at(at, thread).y;
#endif
  return section;
}

// section, next: half width, half height, offset aside at the crossing and at the next one; centre: without the offset.
FORMULA Strand strand_of(int thread, ThreadSection body, vec3 section, vec3 next_section, float centre, float start,
                         float step, float side, vec2 here, vec2 next) {
  Strand s;
  s.thread = thread;
  s.centre = centre + section.z;
  s.aside = (next_section.z - section.z) / step;
  s.thin = 1.0f / vec2(section.x, section.y);
  s.thinner = (1.0f / vec2(next_section.x, next_section.y) - s.thin) / step;
  s.half_height = max(body.half_height, 1.0e-6f);
  s.squareness = body.squareness;
  s.start = start;
  s.low = min(start, start + step);
  s.high = max(start, start + step);
  s.curve = cubic_through(side * here.x, side * here.y, side * next.x, side * next.y, step);
  return s;
}

// A thread's neighbour: its index in x; the position of its centre, which may lie in the next period, in y.
FORMULA vec2 beside(ThreadGrid g, int system, int thread, int step) {
  int n = g.count[system];
  int first = g.first[system];
  int next = thread - first + step;
#if defined(EVEN_THREADS)
  return vec2(float(first + (next < 0 ? n - 1 : next >= n ? 0 : next)), (float(next) + 0.5f) * g.even[system]);
#else
  if (g.even[system] > 0.0f) {
    return vec2(float(first + (next < 0 ? n - 1 : next >= n ? 0 : next)), (float(next) + 0.5f) * g.even[system]);
  }
  float shift = 0.0f;
  if (next < 0) {
    next = n - 1;
    shift = -g.period[system];
  }
  if (next >= n) {
    next = 0;
    shift = g.period[system];
  }
  return vec2(float(first + next), thread_body(system, first + next).centre + shift);
#endif
}

// The thread at a position and the neighbour on that side of its centre.
struct NearThread {
  int thread;
  int next;
  float centre;        // with the period that it lies in, without its offset aside
  float next_centre;
  float border;        // between both, at the position
  vec2 sways;          // of that border where the two threads around the position cross it
  vec4 aside;          // how far washing moves the thread where these cross it, and its neighbour
  float edge;          // of the cell, on the side of the thread's centre
  ThreadSection body;
};

// at: of 0..period. The border is that between even threads.
FORMULA NearThread even_thread(ThreadGrid g, int system, float at, float base) {
  NearThread n;
  n.thread = thread_at(g, system, at);
  n.body = thread_body(system, n.thread);
  n.centre = n.body.centre + base;
  bool up = at >= n.body.centre;
  vec2 next = beside(g, system, n.thread, up ? 1 : -1);
  n.next = int(next.x);
  n.next_centre = next.y + base;
  n.border = n.centre + (up ? n.body.half_room : -n.body.half_room);
  n.sways = vec2(0.0f);
  n.aside = vec4(0.0f);
  n.edge = n.centre;
  return n;
}

// The same with the border where threads `cross` and `next_cross` of the other system cross it; the position lies the
// part t of the way from the first to the second.
FORMULA NearThread settled_thread(ThreadGrid g, int system, NearThread n, float at, int cross, int next_cross, float t) {
#if !defined(SMOOTH_YARNS) || !defined(STRAIGHT_THREADS)
  bool up = n.next_centre >= n.centre;
  int border = up ? n.thread : n.next;
  n.border += up ? n.body.aside.y : n.body.aside.x;
  float sway = up ? n.body.sway.y : n.body.sway.x;
  if (sway > 0.0f) n.sways = vec2(sway_at(g, system, border, cross), sway_at(g, system, border, next_cross));
  n.border += sway * mix(n.sways.x, n.sways.y, t) + 0.5f * mix(n.aside.x + n.aside.z, n.aside.y + n.aside.w, t);
  if (up ? at >= n.border : at < n.border) {
    int thread = n.thread;
    float centre = n.centre;
    n.thread = n.next;
    n.centre = n.next_centre;
    n.next = thread;
    n.next_centre = centre;
    n.aside = vec4(n.aside.z, n.aside.w, n.aside.x, n.aside.y);
    n.edge += n.centre - centre;
    n.body = thread_body(system, n.thread);
  }
#endif
  return n;
}

// A settled thread's section where thread `at` of the other system crosses it; sway: of its border there.
FORMULA vec3 section_near(ThreadGrid g, int system, NearThread n, float sway, int at) {
  bool up = n.next_centre >= n.centre;
  float other = 0.0f;
#if !defined(SMOOTH_YARNS)
  if ((up ? n.body.sway.x : n.body.sway.y) > 0.0f) {
    other = sway_at(g, system, up ? thread_before(g, system, n.thread) : n.thread, at);
  }
#endif
  return section_between(n.body, up ? other : sway, up ? sway : other);
}

// Two values of a thread, where the two threads around the position cross it. swapped: these have changed places since
// the values were found.
FORMULA vec2 in_order(float here, float next, bool swapped) { return swapped ? vec2(next, here) : vec2(here, next); }

FORMULA Strand strand_at(ThreadGrid g, int system, NearThread n, bool swapped, NearThread cross, bool cross_swapped,
                         vec2 here, vec2 next) {
  vec2 sways = in_order(n.sways.x, n.sways.y, swapped);
  vec3 section = section_near(g, system, n, sways.x, cross.thread);
  vec3 next_section = section_near(g, system, n, sways.y, cross.next);
  float start = cross.centre;
  float end = cross.next_centre;
#if !defined(STRAIGHT_THREADS)
  vec2 aside = in_order(n.aside.x, n.aside.y, swapped);
  section.z += aside.x;
  next_section.z += aside.y;
  // The places where this thread crosses those two.
  start += in_order(cross.aside.x, cross.aside.y, cross_swapped).x;
  end += in_order(cross.aside.z, cross.aside.w, cross_swapped).x;
#endif
  return strand_of(n.thread, n.body, section, next_section, n.centre, start, end - start, g.side, here, next);
}

// How far washing moves the threads at the crossing in whose room a position lies.
FORMULA vec2 aside_near(ThreadGrid g, vec2 at) {
#if !defined(STRAIGHT_THREADS)
  if (g.aside > 0.0f) {
    vec2 within = at - vec2(floor(at.x / g.period.x), floor(at.y / g.period.y)) * g.period;
    return aside_at(thread_at(g, 0, within.x), thread_at(g, 1, within.y));
  }
#endif
  return vec2(0.0f);
}

FORMULA Crossing crossing_near(ThreadGrid g, vec2 at) {
  vec2 moved = aside_near(g, at);
  vec2 even = at - moved;   // nearly where the position would lie if no thread were moved
  vec2 base = vec2(floor(even.x / g.period.x) * g.period.x, floor(even.y / g.period.y) * g.period.y);
  NearThread even_end = even_thread(g, 0, even.x - base.x, base.x);
  NearThread even_pick = even_thread(g, 1, even.y - base.y, base.y);
#if !defined(STRAIGHT_THREADS)
  if (g.aside > 0.0f) {
    vec2 first = aside_at(even_end.thread, even_pick.thread);
    vec2 along_end = aside_at(even_end.thread, even_pick.next);
    vec2 along_pick = aside_at(even_end.next, even_pick.thread);
    vec2 opposite = aside_at(even_end.next, even_pick.next);
    even_end.aside = vec4(first.x, along_end.x, along_pick.x, opposite.x);
    even_pick.aside = vec4(first.y, along_pick.y, along_end.y, opposite.y);
    even_end.edge += moved.x;
    even_pick.edge += moved.y;
  }
#endif
  NearThread end = settled_thread(g, 0, even_end, at.x, even_pick.thread, even_pick.next,
                                  (even.y - even_pick.centre) / (even_pick.next_centre - even_pick.centre));
  NearThread pick = settled_thread(g, 1, even_pick, at.y, even_end.thread, even_end.next,
                                   (even.x - even_end.centre) / (even_end.next_centre - even_end.centre));
  bool other_end = end.thread != even_end.thread;
  bool other_pick = pick.thread != even_pick.thread;
  vec4 here = crossing_at(end.thread, pick.thread);
  vec4 along_warp = crossing_at(end.thread, pick.next);
  vec4 along_weft = crossing_at(end.next, pick.thread);
  Crossing c;
  c.warp = strand_at(g, 0, end, other_pick, pick, other_end, vec2(here.x, here.y), vec2(along_warp.x, along_warp.y));
  c.weft = strand_at(g, 1, pick, other_end, end, other_pick, vec2(here.z, here.w), vec2(along_weft.z, along_weft.w));
  c.low = vec2(min(end.edge, end.border), min(pick.edge, pick.border));
  c.high = vec2(max(end.edge, end.border), max(pick.edge, pick.border));
  return c;
}

FORMULA vec2 near_distances(Crossing c, vec3 p) {
  return vec2(strand_near(c.warp, p.x, p.y, p.z), strand_near(c.weft, p.y, p.x, p.z));
}

#include "thread_rays.glsl"

// A point on a thread, in the cloth's axes.
struct ThreadPoint {
  vec3 normal;
  vec3 axis;
  vec3 around;  // along the section, towards +across
  float turn;   // around the thread: 0 on its ridge, a quarter towards +across
  float along;  // position of the section
  vec2 bend;    // curvature along the axis and around the thread, 1/mm
};

FORMULA ThreadPoint thread_point(int system, Strand s, vec3 p) {
  float across = system == 0 ? p.x : p.y;
  float along = system == 0 ? p.y : p.x;
  vec3 q = section_coords(s, across, along, p.z);
  vec3 c = strand_curve(s, q.z);
  float sideways = 0.0f;
#if !defined(SMOOTH_YARNS) || !defined(STRAIGHT_THREADS)
  sideways = s.aside;
#endif
  float n = inversesqrt(1.0f + c.y * c.y);
  float x = q.x;
  float y = q.y;
  // Projected onto the section.
  float r = 1.0f / max(section_norm(x * x, y * y, s.squareness), 1.0e-4f);
  x *= r;
  y *= r;
  vec2 thin = strand_thin(s, q.z);
  vec2 out_of_section = section_gradient(x, y, s.squareness) * thin;
  float side = out_of_section.x;
  float up = out_of_section.y;
  ThreadPoint t;
  // Across, along, up.
  vec3 normal = vec3(side, -c.y * n * up - sideways * side, n * up);
  vec3 axis = vec3(sideways, 1.0f, c.y) * inversesqrt(1.0f + sideways * sideways + c.y * c.y);
  t.normal = normalize(system == 0 ? normal : vec3(normal.y, normal.x, normal.z));
  t.axis = system == 0 ? axis : vec3(axis.y, axis.x, axis.z);
  vec3 aside = system == 0 ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  aside -= t.axis * dot(aside, t.axis);
  t.around = normalize(aside - t.normal * dot(aside, t.normal) + t.axis * 1.0e-6f);
  t.turn = 0.25f - atan(y, x) * 0.15915494f;
  t.along = q.z;
  float size = inversesqrt(side * side + up * up);
  t.bend = vec2(c.z * n * n * n * up * size, section_curvature(x, y, s.squareness, thin));
  return t;
}

// Variances of the slopes of the surface within a sample: along the fibre (tan_fibre: its tangent to the axis), mixed,
// across it. dx, dy: sides of the sample on the middle plane, seen along v.
FORMULA vec3 slope_spread(ThreadPoint t, float tan_fibre, vec3 v, vec2 dx, vec2 dy) {
  const float kMax = 0.25f;   // all that is seen of a round thread
  float scale = 1.0f / max(dot(t.normal, v), 0.25f);
  vec3 a = vec3(dx, 0.0f) - v * (dot(vec2(t.normal.x, t.normal.y), dx) * scale);
  vec3 b = vec3(dy, 0.0f) - v * (dot(vec2(t.normal.x, t.normal.y), dy) * scale);
  vec2 along = vec2(dot(a, t.axis), dot(b, t.axis)) * t.bend.x;
  vec2 around = vec2(dot(a, t.around), dot(b, t.around)) * t.bend.y;
  // The variance of a box of width 1 is 1/12.
  float x = min(dot(along, along) / 12.0f, kMax);
  float y = min(dot(around, around) / 12.0f, kMax);
  float square = 1.0f / (1.0f + tan_fibre * tan_fibre);
  float turned = tan_fibre * tan_fibre;
  return vec3(x + turned * y, tan_fibre * (y - x), turned * x + y) * square;
}

// Normal with the relief of plies. ply: Texel.ply; length_mm: the thread's period.
FORMULA vec3 ply_normal(ThreadPoint t, ThreadTexture x, float ply, float length_mm) {
  SurfaceFrame f;
  f.normal = t.normal;
  f.axis = t.axis;
  f.around = t.around;
  return plied_normal(f, x, ply, length_mm);
}
