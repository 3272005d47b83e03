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

// Share of the pixel that threads fill, of the prefiltered rungs.
float cover_of(Side side, Lights x, Footprint f) {
  if (cloth.gaps.w < 0.5) return 1.0;
  float coverage = min(fetch_color(side, f, 0).a + fetch_color(side, f, 1).a, 1.0);
  return coverage_by_view(coverage, cloth.gaps.xy, cloth.gaps.z, x.v);
}

// Radiance and cover.
vec4 shade(Side side, Lights x, Footprint f) {
#if defined(METHOD_FLAT)
  return vec4(shade_flat(side, x, f), cover_of(side, x, f));
#elif defined(METHOD_VRST03)
  return vec4(shade_vrst03(side, x, f), cover_of(side, x, f));
#elif defined(METHOD_ENGINE)
  return vec4(shade_engine(side, x, f), cover_of(side, x, f));
#elif defined(METHOD_YARN)
  return shade_yarn(side, x, f);
#elif defined(METHOD_CELL)
  return vec4(shade_cell(side, x, f), cover_of(side, x, f));
#elif defined(METHOD_REPEAT)
  return vec4(shade_repeat(side, x, f), cover_of(side, x, f));
#elif defined(METHOD_CLOTH)
  return vec4(shade_cloth(side, x), cover_of(side, x, f));
#else
  return shade_auto(side, x, f, cover_of(side, x, f));
#endif
}

void main() {
  Side side = seen_side();
  Lights lights = seen_lights(side);
  Footprint f = footprint_here();
  vec4 color = shade(side, lights, f);
  out_color = leave(color.rgb, color.a);
}
