// The cloth, by rung: METHOD_ and its name.
#include "frame.glsl"
#include "cloth_fetch.glsl"

#if defined(METHOD_FLAT)
#include "rung_flat.glsl"
#elif defined(METHOD_VRST03)
#include "rung_vrst03.glsl"
#elif defined(METHOD_ENGINE)
#include "rung_engine.glsl"
#else
#include "rung_yarn.glsl"
#include "rung_cell.glsl"
#include "rung_repeat.glsl"
#include "rung_auto.glsl"
#endif

out vec4 out_color;

vec3 shade(Side side, Lights x, Footprint f) {
#if defined(METHOD_FLAT)
  return shade_flat(side, x, f);
#elif defined(METHOD_VRST03)
  return shade_vrst03(side, x, f);
#elif defined(METHOD_ENGINE)
  return shade_engine(side, x, f);
#elif defined(METHOD_YARN)
  return shade_yarn(side, x, f);
#elif defined(METHOD_CELL)
  return shade_cell(side, x, f);
#elif defined(METHOD_REPEAT)
  return shade_repeat(side, x, f);
#elif defined(METHOD_CLOTH)
  return shade_cloth(side, x);
#else
  return shade_auto(side, x, f);
#endif
}

void main() {
  Side side = seen_side();
  Lights lights = seen_lights(side);
  Footprint f = footprint_here();
  vec3 color = shade(side, lights, f);
  float alpha = 1.0;
  if (cloth.gaps.w > 0.5) {
    float coverage = min(fetch_color(side, f, 0).a + fetch_color(side, f, 1).a, 1.0);
    alpha = coverage_by_view(coverage, cloth.gaps.xy, cloth.gaps.z, lights.v);
  }
  out_color = leave(color, alpha);
}
