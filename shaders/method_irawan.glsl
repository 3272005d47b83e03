// SampledMethod `irawan`: floats as curved cylinders, drawn from one place a pixel, unfiltered, as ray tracers draw it that
// leave that to their samples; no thread shades another. A peer to measure by, not a rung of `auto`.
//
// Based on: Irawan, Marschner 2012, "Specular reflection from woven cloth" (irawan.glsl).
// Differs: a thread's fibres lean, and are as wide, as its yarn says; the sky, which the paper has not, lights the
//   diffuse part alone.

#include "thread_fetch.glsl"
#include "irawan.glsl"

vec4 shade_irawan(Side side, Lights x, Footprint f) {
  ThreadGrid g = thread_grid(side.face);
  IrawanPlace p = irawan_place(g, fract(f.at) * g.period);
  if (p.system < 0) return vec4(0.0);
  vec4 look = thread_look(p.system, p.thread);
  YarnLobes yarn = thread_lobes(int(look.w), look.rgb);
  float fibre_tan = thread_pattern(p.system, p.thread, g.side).fibre_tan;
  vec3 key = yarn.body * (max(x.l.z, 0.0) / 3.14159265) + yarn.f0 * irawan_specular(p, fibre_tan, x.l, x.v);
  return vec4(x.key * key + yarn.body * sky_diffuse(side.n) * side.sky, 1.0);
}
