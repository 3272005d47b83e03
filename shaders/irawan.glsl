// Cloth after Irawan and Marschner: each float is a curved cylinder, and its fibres mirror light in a stripe across
// it. GLSL 3.30 and C++20; with threads.glsl, whose host it shares. Frame of a float: x across the thread, y along it,
// z the cloth's normal; millimetres.
//
//   IrawanPoint p = irawan_point(grid, at)    the float at a position, and the position on it
//   irawan_specular(p, tan, l, v)             mirrored radiance for unit irradiance at normal incidence
//
// Based on: Irawan, Marschner 2012, "Specular reflection from woven cloth", sections 4 and 5 (staple yarns, and
// filament yarns without their smoothing; circular bends); Piti Irawan 2008, "Appearance of woven cloth"; Nelson,
// McEvoy 2016, ThunderLoom (floats and threads of a WIF; its bend and width of the stripe).
// Differs: a highlight's strength is that of the yarn's own fibres; the papers fit it to six measured cloths.

// Inclination of a float at its ends, and the fraction of it that the stripe covers: what ThunderLoom uses for any
// WIF.
const float kIrawanBend = 0.5f;
const float kIrawanStripe = 0.3f;
// Fraction of light scattered uniformly around a fibre, and concentration of the rest, forwards (the paper's cotton
// denim has 0.01 and 4, its silk 0.02 and 1.5).
const float kIrawanEven = 0.05f;
const float kIrawanForward = 4.0f;
// Gain so that a float mirrors the required fraction of normally incident light, since fibres scatter most light
// forwards, into the cloth. (Without it: 0.037 to 0.043 for twists from none to 45 degrees.)
const float kIrawanGain = 25.0f;
const float kIrawanFilament = 0.05f;  // tangent of the twist below which fibres count as straight
const int kIrawanFloat = 24;          // largest number of threads that a float is followed over, each way

struct IrawanPoint {
  int system;     // -1: a gap
  int thread;
  bool above;  // of a float; else of a thread below, visible beside the one above
  vec2 at;     // from the float's middle: across, along
  vec2 size;   // width, length
};

FORMULA int irawan_top(ThreadGrid g, ivec2 cell) {
  vec4 c = crossing_at(cell.x, cell.y);
  return g.side * (c.x - c.z) >= 0.0f ? 0 : 1;
}

// Length of a float beyond its crossing at `cell`.
FORMULA float irawan_reach(ThreadGrid g, int system, ivec2 cell, int way) {
  int other = 1 - system;
  float reach = 0.0f;
  for (int k = 0; k < kIrawanFloat; ++k) {
    cell[other] += way;
    if (cell[other] < 0) cell[other] = g.count[other] - 1;
    if (cell[other] >= g.count[other]) cell[other] = 0;
    if (irawan_top(g, cell) != system) break;
    reach += 2.0f * thread_body(other, cell[other]).half_room;
  }
  return reach;
}

// at: 0..period.
FORMULA IrawanPoint irawan_point(ThreadGrid g, vec2 at) {
  ivec2 cell = ivec2(thread_at(g, 0, at.x), thread_at(g, 1, at.y));
  ThreadSection end = thread_body(0, cell.x);
  ThreadSection pick = thread_body(1, cell.y);
  vec2 aside = vec2(at.x - end.centre, at.y - pick.centre);
  vec2 room = vec2(end.half_room, pick.half_room);
  vec2 half_width = vec2(min(end.half_width, end.half_room), min(pick.half_width, pick.half_room));
  IrawanPoint p;
  p.system = irawan_top(g, cell);
  p.above = abs(aside[p.system]) <= half_width[p.system];
  if (!p.above) p.system = 1 - p.system;
  int other = 1 - p.system;
  p.thread = cell[p.system];
  p.size = 2.0f * vec2(half_width[p.system], room[other]);
  p.at = vec2(aside[p.system], aside[other]);
  if (p.above) {
    float back = irawan_reach(g, p.system, cell, -1);
    float on = irawan_reach(g, p.system, cell, 1);
    p.size.y += back + on;
    p.at.y += 0.5f * (back - on);
  } else if (abs(p.at.x) > half_width[p.system]) {
    p.system = -1;
  }
  return p;
}

// von Mises' distribution of an angle by its cosine (Abramowitz and Stegun 9.8.1, 9.8.2 for I0).
FORMULA float irawan_von_mises(float cosine, float k) {
  float t = k / 3.75f;
  float scaled;   // exp(-k) I0(k)
  if (t < 1.0f) {
    t *= t;
    scaled = exp(-k) * (1.0f + t * (3.5156229f + t * (3.0899424f + t * (1.2067492f
             + t * (0.2659732f + t * (0.0360768f + t * 0.0045813f))))));
  } else {
    t = 1.0f / t;
    scaled = inversesqrt(k) * (0.39894228f + t * (0.01328592f + t * (0.00225319f + t * (-0.00157565f
             + t * (0.00916281f + t * (-0.02057706f + t * (0.02635537f + t * (-0.01647633f + t * 0.00392377f))))))));
  }
  return exp(k * (cosine - 1.0f)) / (6.2831853f * scaled);
}

// Phase function of the fibres over their cone: 1 over all directions for a flat cone.
FORMULA float irawan_phase(vec3 l, vec3 v) {
  return (kIrawanEven + irawan_von_mises(-dot(l, v), kIrawanForward)) / (6.2831853f * kIrawanEven + 1.0f);
}

// A layer of fibres, in along l, out along v (Seeliger's law).
FORMULA float irawan_layer(vec3 n, vec3 l, vec3 v) {
  float in_cosine = max(dot(n, l), 0.0f);
  float out_cosine = max(dot(n, v), 0.0f);
  return in_cosine * out_cosine / max(in_cosine + out_cosine, 1.0e-6f);
}

FORMULA vec3 irawan_normal(float u, float turn) { return vec3(sin(turn), sin(u) * cos(turn), cos(u) * cos(turn)); }

// Stripe of a twisted yarn: at each position along the float, the angle around the thread at which its fibres mirror.
// psi: angle of the fibres to the thread; radii: of the thread, of the bend.
FORMULA float irawan_staple(IrawanPoint p, float psi, vec2 radii, vec3 l, vec3 v) {
  vec3 sum = l + v;
  float sum_length = max(length(sum), 1.0e-4f);
  vec3 h = sum / sum_length;
  float u = 2.0f * kIrawanBend * p.at.y / p.size.y;
  float up = h.y * sin(u) + h.z * cos(u);
  float wanted = (h.z * sin(u) - h.y * cos(u)) * cos(psi) / sin(psi);
  float reach = sqrt(up * up + h.x * h.x);
  if (abs(wanted) >= reach) return 0.0f;
  float turn = atan(h.x, up) + asin(wanted / reach);
  if (abs(turn) >= 1.5707963f) return 0.0f;
  float stripe = kIrawanStripe * p.size.x;
  float edge = 0.5f * (p.size.x - stripe);
  float x = clamp(turn * p.size.x * 0.31830989f, -edge, edge);
  if (abs(x - p.at.x) > 0.5f * stripe) return 0.0f;
  vec3 n = irawan_normal(u, turn);
  float area = radii.x * (radii.y + radii.x * cos(turn)) / (sum_length * max(abs(dot(n, h) * sin(psi)), 1.0e-3f));
  return area * irawan_phase(l, v) * irawan_layer(n, l, v) * (2.0f * kIrawanBend / p.size.y) / stripe;
}

// Stripe of a yarn without twist: the position along the float at which the fibres mirror, the same all around the
// thread.
FORMULA float irawan_straight(IrawanPoint p, vec2 radii, vec3 l, vec3 v) {
  vec3 sum = l + v;
  float u = atan(sum.y, sum.z);
  if (abs(u) >= kIrawanBend) return 0.0f;
  float stripe = kIrawanStripe * p.size.y;
  float edge = 0.5f * (p.size.y - stripe);
  float y = clamp(u / kIrawanBend * 0.5f * p.size.y, -edge, edge);
  if (abs(y - p.at.y) > 0.5f * stripe) return 0.0f;
  float turn = p.at.x / p.size.x * 3.14159265f;
  vec3 n = irawan_normal(u, turn);
  float area = radii.x * (radii.y + radii.x * cos(turn)) / max(sqrt(sum.y * sum.y + sum.z * sum.z), 1.0e-4f);
  return area * irawan_phase(l, v) * irawan_layer(n, l, v) * (3.14159265f / p.size.x) / stripe;
}

// fibre_tan: tangent of the angle between fibre and thread, towards +across; l, v: in the cloth's axes.
FORMULA float irawan_specular(IrawanPoint p, float fibre_tan, vec3 l, vec3 v) {
  if (!p.above || l.z <= 0.0f) return 0.0f;
  vec3 to_light = p.system == 0 ? l : vec3(l.y, l.x, l.z);
  vec3 to_eye = p.system == 0 ? v : vec3(v.y, v.x, v.z);
  vec2 radii;
  radii.x = 0.5f * p.size.x;
  radii.y = max(0.5f * p.size.y / sin(kIrawanBend) - radii.x, 0.0f);
  float radiance = abs(fibre_tan) < kIrawanFilament ? irawan_straight(p, radii, to_light, to_eye)
                                                : irawan_staple(p, -atan(fibre_tan), radii, to_light, to_eye);
  return kIrawanGain * radiance / max(v.z, 0.02f);
}
