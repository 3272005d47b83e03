// Method `irawan`: floats as curved cylinders, one sample a pixel, unfiltered, as ray tracers do that leave filtering
// to their samples; without shadows between threads. A peer for comparison, not a method of `auto`.
//
// Based on: Irawan, Marschner 2012, "Specular reflection from woven cloth" (irawan.glsl).
// Differs: twist and lobe width of a thread's fibres come from its yarn; the sky, which the paper does not have,
// lights only the diffuse part.

#include "thread_fetch.glsl"
#include "irawan.glsl"

vec4 shade_irawan(Side side, Lights x, Footprint f) {
  ThreadGrid g = thread_grid(side.face);
  vec2 at = fract(f.at) * g.period;
  IrawanPoint p = irawan_point(g, at);
  if (p.system < 0) return vec4(0.0);
  vec4 dye = thread_dye(g, p.system, p.thread, p.system == 0 ? at.y : at.x);
  YarnLobes yarn = thread_lobes(int(dye.w), dye.rgb);
  float fibre_tan = thread_pattern(p.system, p.thread, g.side).fibre_tan;
  vec3 key = yarn.body * (max(x.l.z, 0.0) / 3.14159265) + yarn.f0 * irawan_specular(p, fibre_tan, x.l, x.v);
  return vec4(x.key * key + yarn.body * sky_diffuse(side.n) * side.sky, 1.0);
}
