// Threads as bodies: elliptic sections, swept at right angles along centre lines that climb over each other, and
// rays among them. GLSL 3.30 and C++20 (core/cloth/thread_table.h). Cloth space: x along the weft, y along the
// warp, z out of the face that is seen; millimetres. Systems: 0 warp, 1 weft.
//
//   Crossing c = crossing_near(grid, at)           the two strands over and under a place
//   ThreadHit h = first_thread(grid, at, v, span)  what a ray down against v meets
//   thread_point(strand, ...)                      normal and axis there, place on the thread
//   threads_block(grid, from, l, ...)              whether a thread stands before the light
//
// The host declares what it holds of the cloth:
//   vec4 thread_body(int system, int thread)       centre, half its room, half width, half height
//   int thread_bin(int system, int bin)            the first thread that reaches past the bin's start
//   vec4 crossing_at(int end, int pick)            height and slope of the warp, of the weft
//
// Based on: F. T. Peirce 1937 (crimp; the heights are core/cloth/centre_line.cpp's); Policarpo, Oliveira, Comba
//   2005 (linear steps along a ray, then the secant). Differs: the shape is evaluated, not fetched from a map of
//   heights, so that it is as sharp at any zoom and threads have an underside.

#include "thread_curve.glsl"

const float kStepsAThread = 8.0f;   // of the eye's ray, for each spacing that it runs over the cloth
const float kLightStepsAThread = 8.0f;
const int kMostSteps = 64;

struct ThreadGrid {
  ivec2 count;      // ends, picks
  ivec2 bins;
  vec2 period;
  float spacing;    // mean
  float top;        // no thread is higher
  float side;       // 1: the front; -1: the back, where heights turn over
  vec2 even;        // the room of each thread where all of a system have the same, else 0
};

// One thread between two crossings.
struct Strand {
  int thread;
  float centre;     // across
  float half_width;
  float half_height;
  float start;      // along, at the crossing
  float step;       // to the next one on this side; negative backwards
  float z0;
  float m0;
  float z1;
  float m1;
};

struct Crossing {
  Strand warp;
  Strand weft;
  vec2 low;         // both strands hold between these places
  vec2 high;
};

FORMULA vec3 strand_curve(Strand s, float along) {
  // Beyond its ends it goes on straight: a cubic would run away there.
  float t = (along - s.start) / s.step;
  float held = clamp(t, 0.0f, 1.0f);
  vec3 c = hermite(s.z0, s.m0, s.z1, s.m1, s.step, held);
  return vec3(c.x + c.y * (t - held) * s.step, c.y, held == t ? c.z : 0.0f);
}

// Where a point lies in the section of a thread that holds it: x, y on the section, 1 long on the ellipse; z the
// section's place along. Sections stand at right angles to the centre line, so over a slope the one that holds a
// point stands further along: the foot of the perpendicular, by Newton's steps.
FORMULA vec3 strand_place(Strand s, float across, float along, float z) {
  float place = along;
  vec3 c = strand_curve(s, place);
  for (int k = 0; k < 2; ++k) {
    float square = 1.0f + c.y * c.y;
    // Held back where sections meet inside a bend.
    place += (along - place + (z - c.x) * c.y) / max(square - (z - c.x) * c.z, 0.5f * square);
    c = strand_curve(s, place);
  }
  float up = ((z - c.x) - (along - place) * c.y) * inversesqrt(1.0f + c.y * c.y);
  return vec3((across - s.centre) / s.half_width, up / s.half_height, place);
}

// Below 0 inside the thread; a length.
FORMULA float strand_distance(Strand s, float across, float along, float z) {
  vec3 p = strand_place(s, across, along, z);
  return (sqrt(p.x * p.x + p.y * p.y) - 1.0f) * s.half_height;
}

// Highest point of the thread over a place; far below where it is not.
FORMULA float strand_top(Strand s, float across, float along) {
  float x = (across - s.centre) / s.half_width;
  if (abs(x) > 1.0f) return -1.0e6f;
  vec3 c = strand_curve(s, along);
  float lean = sqrt(1.0f + c.y * c.y);
  float wanted = sqrt(1.0f - x * x);
  float z = c.x + s.half_height * wanted * lean;
  for (int k = 0; k < 2; ++k) z += (wanted - strand_place(s, across, along, z).y) * s.half_height * lean;
  return z;
}

// Much the same, cheaper, for the steps of a ray: the section is cut upright where the point is.
FORMULA float strand_near(Strand s, float across, float along, float z) {
  vec3 c = strand_curve(s, along);
  float x = (across - s.centre) / s.half_width;
  float y = (z - c.x) * inversesqrt(1.0f + c.y * c.y) / s.half_height;
  return (sqrt(x * x + y * y) - 1.0f) * s.half_height;
}

FORMULA int thread_at(ThreadGrid g, int system, float place) {
  if (g.even[system] > 0.0f) return clamp(int(place / g.even[system]), 0, g.count[system] - 1);
  int bin = clamp(int(place / g.period[system] * float(g.bins[system])), 0, g.bins[system] - 1);
  int thread = thread_bin(system, bin);
  for (int k = 0; k < 6; ++k) {
    vec4 body = thread_body(system, thread);
    if (body.x + body.y > place || thread + 1 >= g.count[system]) break;
    ++thread;
  }
  return thread;
}

FORMULA Strand strand_of(int thread, vec4 body, float base, float start, float step, float side, vec2 here, vec2 next) {
  Strand s;
  s.thread = thread;
  s.centre = body.x + base;
  s.half_width = max(body.z, 1.0e-6f);
  s.half_height = max(body.w, 1.0e-6f);
  s.start = start;
  s.step = step;
  s.z0 = side * here.x;
  s.m0 = side * here.y;
  s.z1 = side * next.x;
  s.m1 = side * next.y;
  return s;
}

// A thread's neighbour: its index in x; the place of its centre, which may lie in the next period, in y.
FORMULA vec2 beside(ThreadGrid g, int system, int thread, int step) {
  int n = g.count[system];
  int next = thread + step;
  if (g.even[system] > 0.0f) {
    return vec2(float(next < 0 ? n - 1 : next >= n ? 0 : next), (float(next) + 0.5f) * g.even[system]);
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
  return vec2(float(next), thread_body(system, next).x + shift);
}

FORMULA Crossing crossing_near(ThreadGrid g, vec2 at) {
  vec2 base = vec2(floor(at.x / g.period.x) * g.period.x, floor(at.y / g.period.y) * g.period.y);
  int end = thread_at(g, 0, at.x - base.x);
  int pick = thread_at(g, 1, at.y - base.y);
  vec4 end_body = thread_body(0, end);
  vec4 pick_body = thread_body(1, pick);
  vec2 middle = vec2(end_body.x, pick_body.x) + base;
  bool right = at.x >= middle.x;
  bool up = at.y >= middle.y;
  vec2 next_end = beside(g, 0, end, right ? 1 : -1);
  vec2 next_pick = beside(g, 1, pick, up ? 1 : -1);
  vec4 here = crossing_at(end, pick);
  vec4 along_warp = crossing_at(end, int(next_pick.x));
  vec4 along_weft = crossing_at(int(next_end.x), pick);
  Crossing c;
  c.warp = strand_of(end, end_body, base.x, middle.y, next_pick.y - pick_body.x, g.side, vec2(here.x, here.y),
                     vec2(along_warp.x, along_warp.y));
  c.weft = strand_of(pick, pick_body, base.y, middle.x, next_end.y - end_body.x, g.side, vec2(here.z, here.w),
                     vec2(along_weft.z, along_weft.w));
  c.low = vec2(right ? middle.x : middle.x - end_body.y, up ? middle.y : middle.y - pick_body.y);
  c.high = vec2(right ? middle.x + end_body.y : middle.x, up ? middle.y + pick_body.y : middle.y);
  return c;
}

FORMULA bool holds(Crossing c, vec2 at) {
  return at.x >= c.low.x && at.x < c.high.x && at.y >= c.low.y && at.y < c.high.y;
}

FORMULA vec2 near_distances(Crossing c, vec3 p) {
  return vec2(strand_near(c.warp, p.x, p.y, p.z), strand_near(c.weft, p.y, p.x, p.z));
}

FORMULA vec2 distances(Crossing c, vec3 p) {
  return vec2(strand_distance(c.warp, p.x, p.y, p.z), strand_distance(c.weft, p.y, p.x, p.z));
}

struct ThreadHit {
  int system;       // -1: a gap
  Strand strand;
  vec3 at;
};

FORMULA ThreadHit hit_of(Crossing c, vec3 p, vec2 d) {
  ThreadHit hit;
  bool warp = d.x <= d.y;
  hit.system = warp ? 0 : 1;
  hit.strand = c.weft;
  if (warp) hit.strand = c.warp;
  hit.at = p;
  return hit;
}

// Straight down, or nearly: the higher of both strands over the place.
FORMULA ThreadHit thread_below(ThreadGrid g, vec2 at, vec2 lean) {
  Crossing c = crossing_near(g, at);
  vec3 p = vec3(at, 0.0f);
  float warp = 0.0f;
  float weft = 0.0f;
  for (int k = 0; k < 2; ++k) {
    warp = strand_top(c.warp, p.x, p.y);
    weft = strand_top(c.weft, p.y, p.x);
    float z = max(max(warp, weft), -g.top);
    vec2 there = at + lean * z;
    p = vec3(there, z);
    if (!holds(c, there)) c = crossing_near(g, there);
  }
  ThreadHit hit = hit_of(c, p, vec2(-warp, -weft));
  if (max(warp, weft) < -1.0e5f) hit.system = -1;
  return hit;
}

// First thread on the ray that crosses the middle plane at `at`, coming from v. most: steps at the most; 0 asks
// for the thread straight below.
FORMULA ThreadHit first_thread(ThreadGrid g, vec2 at, vec3 v, int most) {
  vec2 lean = vec2(v.x, v.y) / max(v.z, 0.04f);   // for a height of 1
  float run = 2.0f * g.top * length(lean) / g.spacing;
  if (most == 0 || run < 0.06f) return thread_below(g, at, lean);
  int steps = int(clamp(ceil(run * kStepsAThread), 8.0f, float(most)));
  float down = 2.0f * g.top / float(steps);
  Crossing c = crossing_near(g, at + lean * g.top);
  vec2 d = distances(c, vec3(at + lean * g.top, g.top));
  float above = min(d.x, d.y);
  float z = g.top;
  for (int i = 0; i < steps; ++i) {
    float next = z - down;
    vec2 there = at + lean * next;
    if (!holds(c, there)) c = crossing_near(g, there);
    d = near_distances(c, vec3(there, next));
    if (min(d.x, d.y) < 0.0f) d = distances(c, vec3(there, next));
    float under = min(d.x, d.y);
    if (under < 0.0f) {
      // The surface lies between: false position.
      float high = z;
      float low = next;
      for (int k = 0; k < 3; ++k) {
        float try_z = low + (high - low) * clamp(-under / max(above - under, 1.0e-6f), 0.02f, 0.98f);
        there = at + lean * try_z;
        if (!holds(c, there)) c = crossing_near(g, there);
        d = distances(c, vec3(there, try_z));
        float now = min(d.x, d.y);
        if (now < 0.0f) {
          low = try_z;
          under = now;
        } else {
          high = try_z;
          above = now;
        }
        z = try_z;
      }
      return hit_of(c, vec3(there, z), d);
    }
    above = under;
    z = next;
  }
  ThreadHit hit = hit_of(c, vec3(at, z), vec2(0.0f, 1.0f));
  hit.system = -1;
  return hit;
}

// Whether a thread stands between a point and a light far away, on either side of the cloth. The thread (skip_system, skip_thread) does not
// count; skip_system -1: all do.
FORMULA bool threads_block(ThreadGrid g, vec3 from, vec3 l, int most, int skip_system, int skip_thread) {
  float way = l.z < 0.0f ? -1.0f : 1.0f;
  float rise = g.top - way * from.z;
  if (rise <= 0.0f) return false;
  vec2 lean = vec2(l.x, l.y) / max(abs(l.z), 0.02f);
  float run = rise * length(lean) / g.spacing;
  int steps = int(clamp(ceil(run * kLightStepsAThread), 4.0f, float(most)));
  Crossing c = crossing_near(g, vec2(from.x, from.y));
  for (int i = 0; i < steps; ++i) {
    float up = rise * (float(i) + 0.5f) / float(steps);
    vec2 there = vec2(from.x, from.y) + lean * up;
    if (!holds(c, there)) c = crossing_near(g, there);
    vec3 p = vec3(there, from.z + way * up);
    vec2 d = near_distances(c, p);
    if (min(d.x, d.y) < 0.0f) d = distances(c, p);
    if (skip_system == 0 && c.warp.thread == skip_thread) d.x = 1.0f;
    if (skip_system == 1 && c.weft.thread == skip_thread) d.y = 1.0f;
    if (min(d.x, d.y) < 0.0f) return true;
  }
  return false;
}

// A place on a thread, in the cloth's axes.
struct ThreadPoint {
  vec3 normal;
  vec3 axis;
  vec3 around;      // along the section, towards +across
  float turn;       // around the thread: 0 on its ridge, a quarter towards +across
  float along;      // of the section
};

FORMULA ThreadPoint thread_point(int system, Strand s, vec3 p) {
  float across = system == 0 ? p.x : p.y;
  float along = system == 0 ? p.y : p.x;
  vec3 q = strand_place(s, across, along, p.z);
  vec3 c = strand_curve(s, q.z);
  float n = inversesqrt(1.0f + c.y * c.y);
  float x = q.x;
  float y = q.y;
  // On the ellipse.
  float r = inversesqrt(max(x * x + y * y, 1.0e-8f));
  x *= r;
  y *= r;
  float side = x / s.half_width;
  float up = y / s.half_height;
  ThreadPoint t;
  t.normal = system == 0 ? normalize(vec3(side, -c.y * n * up, n * up)) : normalize(vec3(-c.y * n * up, side, n * up));
  t.axis = system == 0 ? vec3(0.0f, n, c.y * n) : vec3(n, 0.0f, c.y * n);
  vec3 aside = system == 0 ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  t.around = normalize(aside - t.normal * dot(aside, t.normal) + t.axis * 1.0e-6f);
  t.turn = 0.25f - atan(y, x) * 0.15915494f;
  t.along = q.z;
  return t;
}

// Normal between plies. ply: Texel.ply; length: the thread's period.
FORMULA vec3 ply_normal(ThreadPoint t, ThreadTexture x, float ply, float length_mm) {
  float slant = 4.0f * x.ply_relief_mm * ply;
  return normalize(t.normal + t.around * (slant * float(x.plies) / (6.2831853f * x.radius_mm))
                            + t.axis * (slant * float(x.ply_advance) / length_mm));
}
